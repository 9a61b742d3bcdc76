"""Plots for chapter 7: bounces, resting contacts, and the restitution of dropped balls.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine. A curve is omitted if the student has not yet solved its exercise.
"""

from __future__ import annotations

import math
import statistics
import textwrap
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any

from matplotlib import pyplot
from matplotlib.figure import Figure

from ch07_constraints.drops import find_drops, read_drops
from ch07_constraints.exercises import restitution_of_drop, table_of_drops
from plots.drawing import BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, tell
from scenes.clock import FRAME
from scenes.constraints import (
    GRAVITY,
    ball,
    ball_by_time_division,
    no_bounce_below,
    without_rule,
)
from scenes.integrators import INTEGRATORS
from scenes.readings import number, written
from scenes.resolving import Resolve
from scenes.track import Track

HEIGHT = 2.0
COLORS = {"explicit Euler": RED, "semi-implicit Euler": BLUE, "time division": GREEN}


def bounce_heights() -> Picture:
    """Plot the height of a ball dropped from 2 m over time, with restitution 1 and with 0.5."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.2), layout="constrained")
    rows: list[Sequence[object]] = []
    found = written(
        {
            (name, c): _bouncing(name, c, round(seconds / FRAME))
            for c, seconds in ((1.0, 20.0), (0.5, 2.5))
            for name in COLORS
        }
    )
    words, ends = [], []
    for (name, c), run in found.items():
        axes = left if c == 1.0 else right
        axes.plot(run.times, run.values, color=COLORS[name], lw=1.2, label=name)
        rows += [(name, c, *row) for row in run.points]
        late = [height for time, height in run.points if time > 18.0]
        if c == 1.0 and late:
            words.append(f"{name}: up to {max(late):.3f} m")
        elif c < 1.0 and name == "time division":
            ended = run.message.startswith("TooManyImpacts")
            end = f"the impacts end after {run.times[-1]:.7f} s" if ended else "no end is reported"
            ends.append(f"{name}: {end}")
        elif c < 1.0:
            late = [height for time, height in run.points if time > 2.0]
            ends.append(f"{name}: up to {1e3 * max(late, default=math.nan):.3g} mm after 2 s")
    true_end = math.sqrt(2.0 * HEIGHT / GRAVITY) * (1.0 + 0.5) / (1.0 - 0.5)
    right.axvline(true_end, color=GRAY, lw=1, ls=":", label=f"theory: ends at {true_end:.7f} s")
    left.axhline(HEIGHT, color=GRAY, lw=1, ls=":")
    left.set_title("\n".join(["Restitution 1, in the last two seconds", *words]), fontsize=10)
    right.set_title("\n".join(["Restitution 0.5", *ends]), fontsize=10)
    for axes in (left, right):
        axes.set(xlabel="time, s", ylabel="height, m (60 Hz, 10 m/s$^2$)")
        axes.grid(alpha=0.3)
    left.set_ylim(top=max([1.25 * HEIGHT, *_finite(found.values())]) * 1.15)
    left.legend(fontsize=8, ncols=3, loc="upper center")
    right.legend(fontsize=8)
    # With restitution 0.5, time division should report that the impacts end.
    _notes(figure, {key: run for key, run in found.items() if key != ("time division", 0.5)})
    return Picture(figure, ("method", "restitution", "time, s", "height, m"), rows)


def resting_jitter() -> Picture:
    """Plot the height of a ball that should lie still on the ground.

    The plot compares the engine's rule for resting contacts with a stricter rule and with no rule.
    """
    figure, panels = pyplot.subplots(1, 3, figsize=(16, 5.4), layout="constrained")
    rows: list[Sequence[object]] = []
    rules = {"resting rule": None, "no rule": without_rule}
    found = written(
        {
            (c, name, rule, made): _resting(name, c, rules[rule], made == "generated")
            for c in (0.5, 0.9)
            for rule in rules
            for name in ("explicit Euler", "semi-implicit Euler")
            for made in ("built-in", "generated")
        }
    )
    looks = {("explicit Euler", "resting rule"): RED, ("explicit Euler", "no rule"): ORANGE}
    looks |= {("semi-implicit Euler", "resting rule"): BLUE}
    looks |= {("semi-implicit Euler", "no rule"): SKY}
    for (c, name, rule, made), run in found.items():
        axes = panels[0] if c == 0.5 else panels[1]
        mm = [1e3 * height for height in run.values]
        style = "-" if made == "built-in" else "o"
        label = f"{name}, {rule}, {made} gravity: {max(mm[1:], default=math.nan):.3g} mm"
        every = slice(None, None, 1 if made == "built-in" else 5)
        color = looks[name, rule]
        axes.plot(run.times[every], mm[every], style, color=color, ms=3, lw=1, label=label)
        rows += [(c, f"{name}, {rule}, {made}", *row) for row in run.points]
    for axes, c in zip(panels, (0.5, 0.9), strict=False):
        most = {key[1:]: 1e3 * _highest(run) for key, run in found.items() if key[0] == c}
        top = max([1.0, *most.values()])
        axes.set_ylim(-0.05 * top, 1.9 * top)
        words = []
        for rule in rules:
            high = [value for key, value in most.items() if key[1] == rule]
            words.append(f"with {rule} {max(high, default=math.nan):.3g} mm")
        axes.set_title(
            f"A ball at rest at 1 $\\mu$m, restitution {c:g}: largest height\n{', '.join(words)}",
            fontsize=10,
        )
        axes.legend(fontsize=7.5, loc="upper left")
    fall, c, words, axes = 0.04, 0.9, [], panels[2]
    falls = written(
        {
            "time division": lambda: ball_by_time_division(fall, c, 60),
            "explicit Euler, resting rule": lambda: ball(
                INTEGRATORS["explicit Euler"], fall, c, 60
            ),
            "semi-implicit Euler, resting rule": _falling(fall, c, None),
            "semi-implicit Euler, no bounce below 1 m/s": _falling(fall, c, no_bounce_below(1.0)),
        }
    )
    for (name, run), color in zip(falls.items(), (GREEN, RED, BLUE, PINK), strict=False):
        mm = [1e3 * height for height in run.values]
        label = f"{name}: {1e3 * _rise(run):.3g} mm"
        axes.plot(run.times, mm, color=color, lw=1.2, label=label)
        rows += [(c, f"fall of {fall:g} m, {name}", *row) for row in run.points]
        words.append(f"{1e3 * _rise(run):.3g}")
    axes.set_title(
        f"A fall of {1e3 * fall:g} mm, to {math.sqrt(2.0 * GRAVITY * fall):.2f} m/s, restitution "
        f"{c:g}: highest\nbounce {', '.join(words)} mm (theory {1e3 * fall * c**2:.3g})",
        fontsize=10,
    )
    axes.set_ylim(-3.0, 75.0)
    axes.legend(fontsize=8, loc="upper right")
    for axes in panels:
        axes.set(xlabel="time, s", ylabel="height, mm (60 Hz)")
        axes.grid(alpha=0.3)
    _notes(figure, {**found, **falls})
    return Picture(figure, ("restitution", "what", "time, s", "height, m"), rows)


def restitution_of_materials() -> Picture:
    """Plot the coefficient of restitution of several balls, computed from measured bounce heights.

    The coefficient is the square root of the bounce height divided by the drop height. A second set
    of marks shows the quotient itself, because our copy of the book omits the root in exercise 7.1.
    """
    path, drops = _drops()
    table = table_of_drops(drops)
    singles = [(material, number(restitution_of_drop(a, b))) for material, a, b in drops]
    figure, (axes, beside) = pyplot.subplots(
        1, 2, figsize=(12, 5.0), layout="constrained", width_ratios=(3, 2)
    )
    rows: list[Sequence[object]] = []
    cells, off, printed_off = [], [], []
    for i, (material, count, mean, error) in enumerate(table):
        mean = number(mean)
        error = number(error)  # NaN for a single drop
        dots = [value for name, value in singles if name == material]
        ratios = [b / a for name, a, b in drops if name == material and a]
        printed = statistics.fmean(ratios) if ratios else math.nan
        # A ball dropped from 1 m should bounce to the square of its restitution, in m.
        off.append(abs(mean * mean - printed))
        printed_off.append(abs(printed * printed - printed))
        spread = [i + 0.05 * (j - 0.5 * (len(dots) - 1)) for j in range(len(dots))]
        first = i == 0
        axes.plot(spread, dots, "o", color=SKY, ms=4, label="single drops" if first else None)
        bars = None if math.isnan(error) else error
        label = "mean, with its standard error" if first else None
        axes.errorbar(i - 0.2, mean, bars, fmt="D", color=BLUE, ms=5, capsize=4, label=label)
        label = "without the square root" if first else None
        axes.plot(i + 0.25, printed, "x", color=RED, ms=8, mew=2, label=label)
        cells.append([material, str(count), f"{mean:.3f}", f"{error:.3f}", f"{printed:.3f}"])
        rows.append(("mean", material, count, mean, error, printed))
    rows += [("drop", material, 1, value, "", "") for material, value in singles]
    names = [textwrap.fill(str(row[0]), 14) for row in table]
    axes.set_xticks(range(len(table)), names, fontsize=8)
    axes.set(ylim=(0.0, 1.15), xlim=(-0.6, max(len(table), 1) - 0.4), ylabel="restitution")
    axes.grid(alpha=0.3, axis="y")
    beside.axis("off")
    if cells:
        axes.legend(fontsize=8, ncols=3, loc="upper center")
        heading = ["material", "drops", "mean", "error", "no root"]
        widths = [0.5, 0.12, 0.14, 0.14, 0.16]
        shown = beside.table(cells, colLabels=heading, loc="center", colWidths=widths)
        shown.auto_set_font_size(False)
        shown.set_fontsize(8)
        shown.scale(1.0, 1.6)
    else:
        beside.text(0.5, 0.5, "the table has no rows", ha="center")
    most, printed_most = (100.0 * max(values, default=math.nan) for values in (off, printed_off))
    figure.suptitle(
        f"{len(drops)} drops in {path}. The mean restitutions predict the bounces to within "
        f"{most:.2g} % of the fall,\nwithout the square root to within {printed_most:.2g} %",
        fontsize=11,
    )
    columns = ("row", "material", "drops", "restitution", "standard error", "without the root")
    return Picture(figure, columns, rows)


def _bouncing(name: str, restitution: float, frames: int) -> Callable[[], Track]:
    if name == "time division":
        return lambda: ball_by_time_division(HEIGHT, restitution, frames)
    return lambda: ball(INTEGRATORS[name], HEIGHT, restitution, frames)


def _resting(
    name: str, restitution: float, rule: Resolve | None, generated: bool
) -> Callable[[], Track]:
    """Return a function that simulates a ball released one micrometer above the ground.

    The small gap keeps explicit Euler from finding a contact in its first step.
    """
    return lambda: ball(INTEGRATORS[name], 1e-6, restitution, 120, rule, generated)


def _falling(height: float, restitution: float, rule: Resolve | None) -> Callable[[], Track]:
    return lambda: ball(INTEGRATORS["semi-implicit Euler"], height, restitution, 60, rule)


def _finite(runs: Iterable[Track]) -> list[float]:
    """Keep only the heights that fit into a plot, since a faulty engine may compute huge ones."""
    return [height for run in runs for height in run.values if abs(height) < 10.0 * HEIGHT]


def _highest(run: Track) -> float:
    """Find the greatest height of a ball, ignoring heights that are too large to plot."""
    return max((height for height in run.values[1:] if abs(height) < 1e3), default=math.nan)


def _rise(run: Track) -> float:
    """Find how high a ball rises after it first bounces, or 0 if it never rises."""
    for i, (a, b) in enumerate(pairwise(run.values)):
        if b > a:
            return max(run.values[i:])
    return 0.0


def _drops() -> tuple[str, list[tuple[str, float, float]]]:
    """Read the bounce heights that the student has measured.

    If the student has not recorded any drops yet, read the sample file instead. Return the name of
    the file along with the drops.
    """
    for name in ("drops.csv", "drops_sample.csv"):
        try:
            drops = read_drops(find_drops(name))
        except FileNotFoundError:
            continue
        if drops:
            return name, drops
    raise ValueError("there are no drops in drops.csv or drops_sample.csv")


def _notes(figure: Figure, found: dict[Any, Track]) -> None:
    tell(figure, [f"{key}: {run.message}" for key, run in found.items() if run.message])
