"""Plots for chapter 8: how accurate simulated ropes and bridge cables are, and at what cost.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

from matplotlib import pyplot
from matplotlib.axes import Axes
from scenes.ropes import (
    LENGTH,
    SPAN,
    Hanging,
    catenary_radius,
    catenary_sag,
    hang_by_direct_chain,
    hang_by_rods,
    polygon_sag,
)

from plots.drawing import BLACK, BLUE, GRAY, ORANGE, PINK, RED, SKY, Picture, tell
from scenes.mass_aggregate import load_on_bridge
from scenes.readings import stopped, written
from scenes.track import Track

BOUND = 2.0  # %, allowed excess length of a cable
MANY, SECONDS = 30, 0.5  # links and s; a resolver takes far longer for more of either
THROUGH = 1e3  # %, where an infinite excess length is drawn


def mass_ratios() -> Picture:
    """Plot how far the cables of the rope bridge stretch under balls of 1 kg to 1 t.

    Each curve is for a different number of iterations or substeps.
    """
    figure, axes = pyplot.subplots(figsize=(10, 5.8), layout="constrained")
    ratios = (1, 10, 30, 100, 300, 1000)
    # Cases that take the longest and are accurate enough anyway are left out.
    ways: dict[str, tuple[int | None, int, tuple[int, ...], str]] = {
        "default iterations": (None, 1, ratios, RED),
        "200 iterations per phase": (200, 1, ratios, ORANGE),
        "default, 4 substeps": (None, 4, ratios, SKY),
        "default, 16 substeps": (None, 16, (1000,), BLUE),
    }
    found = written(
        {
            (way, ratio): partial(load_on_bridge, float(ratio), iterations, substeps, 4.0)
            for way, (iterations, substeps, some, _) in ways.items()
            for ratio in some
        }
    )
    rows: list[Sequence[object]] = []
    words = []
    for way, (*_, some, color) in ways.items():
        seen = {ratio: found[way, ratio] for ratio in some if (way, ratio) in found}
        worst = {ratio: _late(run, 3.0) for ratio, (run, _) in seen.items()}
        rows += [(way, ratio, seen[ratio][1], value) for ratio, value in worst.items()]
        bad = [ratio for ratio, value in worst.items() if not value <= BOUND]
        ends = f"fails at {bad[0]}:1" if bad else f"holds at {max(worst, default=0)}:1"
        most = max((work for _, work in seen.values()), default=0)
        # Values without an error are drawn at the lower edge.
        shown = {ratio: min(max(value, 1e-3), THROUGH) for ratio, value in worst.items()}
        label = f"{way}: {ends} (up to {most:,} resolutions)"
        axes.loglog(*zip(*shown.items(), strict=True), "o-", color=color, label=label)
        axes.plot(bad, [shown[ratio] for ratio in bad], "x", color=BLACK, ms=11, mew=2)
        if 300 in worst:
            words.append(f"{way} {worst[300]:.2g} %")
    axes.plot([], [], "x", color=BLACK, ms=9, mew=2, label="fails")
    axes.axhline(THROUGH, color=GRAY, lw=1, ls=":", label="the ball has fallen through")
    axes.axhspan(BOUND, 1e6, color=GRAY, alpha=0.12, lw=0)
    axes.axhline(BOUND, color=GRAY, lw=1, ls="--", label=f"limit: {BOUND:g} %")
    axes.set_ylim(8e-4, 2e5)
    axes.set_xticks(ratios, [f"{ratio}:1" for ratio in ratios])
    axes.set_xticks([], minor=True)
    axes.set_title(
        "The heavier the load on light planks, the longer the cables; excess length at 300:1:\n"
        f"{'; '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="mass of the ball : mass of the end of a plank")
    axes.set_ylabel("excess length of the worst cable from 3 to 4 s, % (60 Hz)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8.5, loc="upper left")
    notes = [f"{key}: {run.message}" for key, (run, _) in found.items() if run.message]
    tell(figure, notes)
    columns = ("method", "ball : plank's end", "resolutions", "excess length of the worst cable, %")
    return Picture(figure, columns, rows)


def hanging_rope() -> Picture:
    """Plot how accurately each method simulates the sag of a rope between two nails.

    The error in the sag is plotted against the work, which is the number of contacts resolved. For
    DirectChain, it is the number of rod forces computed. These counts are the same on every
    computer.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    # A rope that starts at rest should stay there, and DirectChain keeps it there to 1e-8 m. So
    # DirectChain is also shown with a rope that starts in the shape of a V.
    scenes: dict[tuple[int, str], Callable[[], Hanging]] = {
        (links, f"rods, {substeps} substep{'s' * (substeps > 1)}"): partial(
            hang_by_rods, links, 60, substeps, SECONDS
        )
        for links in (10, MANY)
        for substeps in (1, 4, 16)
    }
    for links, rate in ((10, 60), (MANY, 60), (MANY, 240)):
        scenes[links, f"DirectChain, {rate} Hz"] = partial(
            hang_by_direct_chain, links, rate, SECONDS
        )
    for links in (10, MANY):
        name = "DirectChain, 240 Hz, from a V for 8 s"
        scenes[links, name] = partial(hang_by_direct_chain, links, 240, 8.0, True)
    notes: list[str] = []
    hung = written({key: _ended(scene, key, notes) for key, scene in scenes.items()})
    found = {key: hanging for key, hanging in hung.items() if hanging is not None}
    a = catenary_radius()
    xs = [SPAN * i / 100 for i in range(101)]
    ys = [a * (math.cosh((x - 0.5 * SPAN) / a) - math.cosh(0.5 * SPAN / a)) for x in xs]
    left.plot(xs, ys, color=GRAY, lw=5, alpha=0.5, label=f"catenary: sag {catenary_sag():.5f} m")
    for color, substeps in ((RED, "1 substep"), (ORANGE, "4 substeps"), (PINK, "16 substeps")):
        _shape(left, found.get((MANY, f"rods, {substeps}")), f"rods, {substeps}", color)
    direct = found.get((MANY, "DirectChain, 240 Hz"))
    _shape(left, direct, "DirectChain, 240 Hz", BLACK)
    rows: list[Sequence[object]] = []
    looks = (("rods", 10, SKY), ("rods", MANY, RED), ("DirectChain", 10, BLUE))
    for kind, links, color in (*looks, ("DirectChain", MANY, BLACK)):
        points = []
        for (count, name), hanging in found.items():
            if count == links and name.startswith(kind):
                error = hanging.sag - polygon_sag(links)
                rows.append((links, name, hanging.work, hanging.sag, error, hanging.stretch))
                points.append((hanging.work, max(abs(error), 1e-10), name))
        if points:
            work, errors, _ = zip(*points, strict=True)
            style = "o-" if kind == "rods" else "D"
            label = f"{kind}, {links} links: {min(errors):.1g} to {max(errors):.1g} m"
            right.loglog(work, errors, style, color=color, label=label)
            for spent, error, name in points:
                words = name.removeprefix(f"{kind}, ").replace(", from", "\nfrom")
                above = kind == "rods" or ("\n" in words and links == MANY)
                offset = (6, 4) if above else (-2, -24 if "\n" in words else -16)
                right.annotate(
                    words, (spent, error), offset, textcoords="offset points", fontsize=7.5
                )
    sinks = [_sinks(found, 10, s) for s in (1, 16)]
    deep = [_sinks(found, MANY, s) for s in (1, 16)]
    stays = "?" if direct is None else f"{direct.sag - polygon_sag(MANY):.1g}"
    right.set_title(
        f"With 1 and 16 substeps, 10 links sink by {sinks[0]} and {sinks[1]} m,\n"
        f"{MANY} links by {deep[0]} and {deep[1]} m, with DirectChain by {stays} m",
        fontsize=10,
    )
    left.set_title(
        f"{MANY} links of {LENGTH / MANY:g} m, {SECONDS:g} s after a start at rest:\n"
        f"rods with 16 substeps are {_stretch(found, MANY, 16)} m too long",
        fontsize=10,
    )
    left.set(xlabel="position along the span, m", ylabel="height relative to the nails, m")
    right.set(xlabel="work: contacts resolved, or rods solved")
    right.set_ylabel("error of the sag, m (1e-10 or less at the edge)")
    left.set(xlim=(-0.6, 2.6), ylim=(-4.0, 1.5))
    right.set(xlim=(1.5e2, 1e6), ylim=(1e-11, 1e3))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, notes)
    columns = ("links", "method", "work", "sag, m", "error of the sag, m", "excess length, m")
    return Picture(figure, columns, rows)


def _late(run: Track, since: float) -> float:
    """Find the largest value that a simulation recorded after the first ``since`` seconds.

    If the engine raised an exception, return infinity.
    """
    late = [value for time, value in run.points if time >= since]
    return max(late, default=math.inf) if not run.message else math.inf


def _ended(
    scene: Callable[[], Hanging], key: tuple[int, str], notes: list[str]
) -> Callable[[], Hanging | None]:
    """Wrap the simulation of a rope, so that one failed run does not stop the whole plot.

    If the simulation raises an exception, the wrapped function returns None. The message of the
    exception is added to ``notes``.
    """

    def run() -> Hanging | None:
        hung: list[Hanging] = []
        message = stopped(lambda: hung.append(scene()))
        if message:
            notes.append(f"{key[0]} links, {key[1]}: {message}")
        return hung[0] if hung else None

    return run


def _shape(axes: Axes, hanging: Hanging | None, name: str, color: str) -> None:
    if hanging is not None:
        label = f"{name}: sag {hanging.sag:.5g} m, {abs(hanging.stretch):.2g} m too long"
        axes.plot(*zip(*hanging.places, strict=True), color=color, lw=1.3, label=label)


def _sinks(found: dict[tuple[int, str], Hanging], links: int, substeps: int) -> str:
    name = f"rods, {substeps} substep{'s' * (substeps > 1)}"
    hanging = found.get((links, name))
    return "?" if hanging is None else f"{hanging.sag - polygon_sag(links):.2g}"


def _stretch(found: dict[tuple[int, str], Hanging], links: int, substeps: int) -> str:
    hanging = found.get((links, f"rods, {substeps} substeps"))
    return "?" if hanging is None else f"{hanging.stretch:.2g}"
