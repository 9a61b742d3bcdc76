"""Plots for chapter 7: errors that the contact resolver leaves in a pile, and how far stacks sink.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine. A curve is omitted if the student has not yet solved its exercise.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from matplotlib import pyplot

from plots.drawing import BLUE, GRAY, ORANGE, RED, Picture, tell
from scenes.piles import pile, residuals, stack
from scenes.readings import number, written
from scenes.track import Track


def resolver_convergence() -> Picture:
    """Plot the errors left in a pile of spheres against the number of contacts resolved.

    The errors are the largest closing velocity and the largest penetration depth.
    """
    figure, panels = pyplot.subplots(1, 2, figsize=(12, 5.0), layout="constrained")
    counts = [*range(31), *range(32, 100, 4), *range(100, 401, 20)]
    found = written(
        {
            "worst first": lambda: [residuals(count, False) for count in counts],
            "in list order": lambda: [residuals(count, True) for count in counts],
        }
    )
    rows: list[Sequence[object]] = []
    for name, seen in found.items():
        color, style = (BLUE, "o-") if name == "worst first" else (ORANGE, "s-")
        for i, axes in enumerate(panels):
            # Zeros and rounding errors are drawn at the lower edge of the picture.
            left = [max(number(pair[i]), (1e-8, 1e-10)[i]) for pair in seen]
            axes.semilogy(counts, left, style, color=color, ms=3, lw=1, label=name)
        rows += [(name, count, *pair) for count, pair in zip(counts, seen, strict=True)]
    contacts = len(pile(4, 0.01, 1.0)[1])
    shown = ("closing velocity", "m/s"), ("depth", "m")
    for i, (axes, (what, unit)) in enumerate(zip(panels, shown, strict=True)):
        at = {name: seen[counts.index(100)][i] for name, seen in found.items()}
        words = [f"{name} {value:.2g} {unit}" for name, value in at.items()]
        axes.set_title(
            f"Largest {what} of {contacts} contacts, after 100 resolutions:\n{', '.join(words)}",
            fontsize=10,
        )
        axes.axvline(2 * contacts, color=GRAY, lw=1, ls=":", label=f"default: {2 * contacts}")
        axes.set(xlabel="resolutions", ylabel=f"largest {what}, {unit}")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    columns = ("order", "resolutions", "largest closing velocity, m/s", "largest depth, m")
    return Picture(figure, columns, rows)


def stack_height() -> Picture:
    """Plot how far stacks of 3 and 10 spheres sink, and how far the spheres overlap.

    The stacks are simulated with different limits on the number of iterations per contact.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.0), layout="constrained")
    numbers_of = (1, 2, 5, 10, 20, 50)
    found = written(
        {
            (count, iterations): _stacked(count, iterations)
            for count in (3, 10)
            for iterations in (None, *numbers_of)
        }
    )
    rows: list[Sequence[object]] = []
    sunk: dict[int, list[str]] = {}
    overlaps: dict[int, list[str]] = {}
    for (count, iterations), (height, overlap) in found.items():
        name = "default" if iterations is None else str(iterations)
        seen = zip(height.times, height.values, overlap.values, strict=True)
        rows += [(count, name, *row) for row in seen]
        if iterations in (None, 50):
            how, style = ("default", "-") if iterations is None else (f"{name} per contact", "--")
            color, label = BLUE if count == 3 else RED, f"{count} spheres, {how}"
            left.plot(height.times, height.values, style, color=color, label=label)
            down = height.values[0] - height.values[-1]
            sunk.setdefault(count, []).append(f"{down:.3g} m ({how})")
            most = 100.0 * max(overlap.values)
            overlaps.setdefault(count, []).append(f"{most:.2g} % ({how})")
    for count, color in ((3, BLUE), (10, RED)):
        highest = [
            max(100.0 * max(found[count, i][1].values), 1e-6)
            for i in numbers_of
            if (count, i) in found
        ]
        right.loglog(
            numbers_of[: len(highest)], highest, "o-", color=color, label=f"{count} spheres"
        )
    for axes, what, told in ((left, "sink by", sunk), (right, "overlap by up to", overlaps)):
        lines = [f"{count} spheres {what} {', '.join(words)}" for count, words in told.items()]
        axes.set_title("\n".join(lines), fontsize=10)
    left.set(xlabel="time, s", ylabel="height of the center of the top sphere, m")
    right.set(xlabel="iterations per contact", ylabel="largest overlap in 2 s, % of a diameter")
    right.set_xticks(numbers_of, [str(i) for i in numbers_of])
    right.set_xticks([], minor=True)
    left.set_ylim(0.0, 14.0)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, [f"{key}: {run.message}" for key, (run, _) in found.items() if run.message])
    columns = ("spheres", "iterations per contact", "time, s", "height, m", "overlap / diameter")
    return Picture(figure, columns, rows)


def _stacked(count: int, iterations: int | None) -> Callable[[], tuple[Track, Track]]:
    return lambda: stack(count, iterations, 120)
