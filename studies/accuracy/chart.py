"""Draw charts that show how accurate and how fast our engine and pymunk are in each scene.

A scene, such as a pendulum, can be simulated in several ways, for example with different
integrators. Each of these ways is called a model. The chart of a scene has two panels, which plot
the error of each model against its processor time and against its work. An overview compares the
fastest models of our engine with those of pymunk in all scenes.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

from matplotlib import pyplot
from matplotlib.axes import Axes

from studies.accuracy.measure import Point
from studies.accuracy.results import TOLERANCES, Row, Side, front, models_of, row
from studies.drawing import (
    BLACK,
    BLUE,
    BROWN,
    COLORS,
    GRAY,
    GREEN,
    ORANGE,
    PINK,
    RED,
    SKY,
    YELLOW,
)

FLOOR, CEILING = 1e-15, 10.0  # smaller errors are rounding, and larger errors are useless
OWN = COLORS | {"adaptive": BROWN}  # models with the same color in all charts
OURS = (BLUE, GREEN, ORANGE, SKY, PINK, BROWN, GRAY, YELLOW)
UP = (0.25, 0.0, -0.25)  # vertical offsets of the three tolerances in a scene's row
MARKERS = "os^Dvph<>"
COLUMNS = (
    *("model", "by", "steps per frame, or 1 / tolerance", "error / scale", "work"),
    *("time, ms", "lower quartile, ms", "upper quartile, ms"),
)


def draw(points: Sequence[Point], counted: str, png: Path) -> None:
    """Draw the chart of a scene, which shows how accurate and how fast each model is.

    A model is one way to simulate the scene, for example with a certain integrator. The left panel
    plots the error of each model against its processor time, and the right panel plots it against
    its work. ``counted`` says what is counted as work, such as "contacts resolved". The chart is
    saved as ``png``, and a CSV file next to it contains the plotted points.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(14, 6.5), layout="constrained")
    styles = styles_of(points)
    edge = front(points)
    left.plot(
        [1e3 * point.time for point in edge],
        [max(point.error, FLOOR) for point in edge],
        color=YELLOW,
        marker="o",
        ms=18,
        lw=9,
        alpha=0.45,
        label="best trade-offs",
        zorder=0,
    )
    for name, own in models_of(points).items():
        seen = [point for point in own if point.error < CEILING]
        errors = [max(point.error, FLOOR) for point in seen]
        times = [1e3 * point.time for point in seen]
        around = [
            [1e3 * (point.time - point.spread[0]) for point in seen],
            [1e3 * (point.spread[1] - point.time) for point in seen],
        ]
        label = name if seen else f"{name}: useless"
        left.errorbar(times, errors, xerr=around, capsize=2, label=label, **styles[name])
        right.plot([point.work for point in seen], errors, **styles[name])
    _draw_extrapolated(left, points, styles)
    left.set(xlabel="processor time of the scene, ms (bars: quartiles)")
    right.set(xlabel=counted)
    for axes in (left, right):
        axes.set(xscale="log", yscale="log", ylabel="largest error / scale of the scene")
        axes.set_ylim(max(FLOOR, min(point.error for point in points)) / 3.0, CEILING)
        axes.grid(alpha=0.3)
    labels = left.get_legend_handles_labels()
    figure.legend(*labels, loc="outside lower center", ncols=5, fontsize=8.5, borderpad=0.8)
    figure.suptitle(f"{points[0].scene}\n{said(row(points, 1e-4))}", fontsize=11)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)
    with png.with_suffix(".csv").open("w", encoding="utf-8", newline="") as file:
        rows = [
            (p.model, p.by, p.steps, p.error, p.work, *(1e3 * t for t in (p.time, *p.spread)))
            for p in points
        ]
        csv.writer(file).writerows([COLUMNS, *rows])


def _draw_extrapolated(
    axes: Axes, points: Sequence[Point], styles: dict[str, dict[str, Any]]
) -> None:
    """Draw a dotted line that extends pymunk's curve to smaller errors.

    The times on this line are extrapolated. The line ends at the smallest error tolerance for which
    an extrapolated time exists. If there is none, nothing is drawn.
    """
    sides = [(tolerance, row(points, tolerance).pymunk) for tolerance in TOLERANCES]
    found = [(tolerance, side) for tolerance, side in sides if side.order is not None]
    if not found:
        return
    tolerance, side = found[-1]
    assert side.time is not None
    own = [point for point in points if point.model == side.model]
    finest = max(own, key=lambda point: point.steps)
    times, errors = [1e3 * finest.time, 1e3 * side.time], [finest.error, tolerance]
    label = f"extrapolated, order {side.order:.2f}"
    color = styles[finest.model]["color"]
    axes.plot(times, errors, ":", color=color, marker="D", mfc="none", markevery=[1], label=label)


def draw_overview(rows: Sequence[Row], png: Path) -> None:
    """Plot the ratio of pymunk's time to ours for every scene and every error tolerance.

    A filled mark is a measured ratio. Other marks:

    - An open mark without an arrow is an estimate. Pymunk did not reach the tolerance within the
      time limit, so its time is extrapolated from its order of convergence.
    - An open mark with an arrow is only a bound. Either pymunk or our models did not reach the
      tolerance within the time limit.
    - The word "never" at the edge means that one of the two cannot reach the tolerance at all.

    There is no mark if neither pymunk nor our models reach the tolerance.
    """
    scenes = list(dict.fromkeys(row.scene for row in rows))[::-1]
    tolerances = sorted({row.tolerance for row in rows}, reverse=True)
    figure, axes = pyplot.subplots(figsize=(11, 0.45 * len(scenes) + 2.4), layout="constrained")
    ends = [end for found in rows for end in found.bounds if 0.0 < end < math.inf]
    low, high = min([0.1, *ends]) / 3.0, max([10.0, *ends]) * 10.0
    axes.set(xscale="log", xlim=(low, high), yticks=range(len(scenes)), yticklabels=scenes)
    for tolerance, color, mark, up in zip(
        tolerances, (ORANGE, BLUE, GREEN), "o^s", UP, strict=True
    ):
        for found in rows:
            if found.tolerance == tolerance:
                _draw_ratio(axes, found, scenes.index(found.scene) + up, color, mark)
        axes.plot([], [], mark, color=color, label=f"error of {tolerance:g} of the scale")
    if any(found.is_extrapolated for found in rows):
        axes.plot([], [], "o", color=GRAY, mfc="none", label="pymunk's time extrapolated")
    axes.axvline(1.0, color=BLACK, lw=1)
    axes.set_xlabel(
        "time of pymunk / time of our cheapest model with the same error\n"
        "(left of 1, pymunk is faster; arrows: the ratio is even larger or smaller)"
    )
    axes.set_title("Pymunk's time relative to ours, if the position is needed in every 60 Hz frame")
    axes.grid(alpha=0.3)
    figure.legend(loc="outside lower center", ncols=4, fontsize=9)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)


def _draw_ratio(axes: Axes, found: Row, y: float, color: str, mark: str) -> None:
    """Draw one mark in the overview chart, at the ratio of pymunk's time to ours.

    The mark is drawn at height ``y``. It is filled if both times were measured, and open if
    pymunk's time is extrapolated. If only one of the two times is known, an arrow shows that the
    ratio is a bound. If no number of steps would meet the tolerance, the word "never" appears at
    the edge instead.
    """
    if found.ratio:
        face = "none" if found.is_extrapolated else color
        axes.plot(found.ratio, y, mark, color=color, mfc=face)
    elif found.ours.time or found.pymunk.time:
        most = found.ours.time is None
        if (found.ours if most else found.pymunk).never:
            edge = axes.get_xlim()[not most] * (2.0 if most else 0.5)
            axes.text(edge, y, "never", color=color, ha="center", va="center", fontsize=8)
            return
        value = found.bounds[most]
        axes.plot(value, y, mark, color=color, mfc="none")
        arrow = {"arrowstyle": "->", "color": color}
        axes.annotate("", (value / 2.2 if most else 2.2 * value, y), (value, y), arrowprops=arrow)


def said(found: Row) -> str:
    """Compare our fastest model with pymunk's in one sentence, for the title of a chart.

    For example, "at an error of 0.0001 of the scale, leapfrog takes 3.2 ms, and pymunk takes 12
    times as long".
    """
    ours, theirs = found.ours, found.pymunk
    start = f"at an error of {found.tolerance:g} of the scale, "
    if ours.time is None or theirs.time is None:
        mine, others = (told(side) for side in (ours, theirs))
        return f"{start}ours: {mine}; pymunk: {others}"
    many = theirs.time / ours.time
    end = f"{_number(many)} times as long" if many >= 1.0 else f"1/{_number(1.0 / many)} of that"
    end += " (extrapolated)" * found.is_extrapolated
    return (
        f"{start}{ours.model} takes {_number(1e3 * ours.time)} ms, and {theirs.model} takes {end}"
    )


def told(side: Side) -> str:
    """Describe the fastest model of our engine or of pymunk, as in "leapfrog, 3.2 ms".

    If the time is extrapolated, the text also gives the order of convergence. If no model met the
    tolerance, the text is "never" or, if more steps might have helped, "not within 600 ms".
    """
    if side.time is not None:
        time = f"{side.model}, {_number(1e3 * side.time)} ms"
        return time if side.order is None else f"{time} (extrapolated, order {side.order:.2f})"
    return "never" if side.never else f"not within {_number(1e3 * side.longest)} ms"


def told_ratio(found: Row) -> str:
    """Format the ratio of pymunk's time to ours, as in "5.51", "~ 5.51" or "> 120".

    A "~" means that pymunk's time is extrapolated. A ">" or "<" means that the ratio is only a
    bound. The text is empty if there is no useful bound, for example because pymunk can never reach
    the tolerance.
    """
    low, high = found.bounds
    if found.ratio:
        return "~ " * found.is_extrapolated + _number(found.ratio)
    if low > 0.0 and not found.pymunk.never:
        return f"> {_number(low)}"
    return f"< {_number(high)}" if high < math.inf and not found.ours.never else ""


def _number(value: float) -> str:
    """Format ``value`` to three significant digits, as in 0.0277, 5.51 or 4,190."""
    return f"{value:.3g}" if value < 1000.0 else f"{float(f'{value:.3g}'):,.0f}"


def styles_of(points: Sequence[Point]) -> dict[str, dict[str, Any]]:
    """Choose a color and a marker for each model in a chart.

    Pymunk's models are black or gray, and the textbook's are red. Each integrator of chapter 6 has
    the same color in all charts. All other models share the remaining colors.
    """
    styles: dict[str, dict[str, Any]] = {}
    models = models_of(points)
    taken = {OWN[name] for name in models if name in OWN}
    theirs, markers = iter((BLACK, GRAY)), cycle(MARKERS)
    colors = cycle([color for color in OURS if color not in taken])
    for name, own in models.items():
        if own[0].by == "pymunk":
            styles[name] = {"color": next(theirs), "marker": "x", "ls": "--", "ms": 7}
        elif own[0].by == "the book":
            many = sum(style["color"] == RED for style in styles.values())
            styles[name] = {"color": RED, "marker": "+*"[many % 2], "ls": "-", "ms": 8}
        else:
            color = OWN.get(name) or next(colors)
            size = 11 if math.isclose(own[0].steps, own[-1].steps) else 5
            styles[name] = {"color": color, "marker": next(markers), "ls": "-", "ms": size}
    return styles
