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
from functools import cache
from pathlib import Path
from typing import Any

from matplotlib import pyplot
from matplotlib.axes import Axes

from plots.drawing import (
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
    VIOLET,
    YELLOW,
)
from studies.accuracy.measure import Point
from studies.accuracy.results import Row, Side, front, models_of, power, row, table
from studies.accuracy.scene import Scene

FLOOR, CEILING = 1e-15, 10.0  # smaller errors are rounding, and larger errors are useless
OWN = COLORS | {"adaptive": BROWN}  # these have the colors of the other pictures
OURS = (BLUE, GREEN, ORANGE, SKY, PINK, BROWN, VIOLET, YELLOW)
TITLES = (
    "our steps of the same equations",
    "our better models: closed forms, angles, impacts, rest",
)
OPEN = {
    "o": "open: pymunk's time is extrapolated",
    ">": "at least this ratio (pymunk was too slow)",
    "<": "at most this ratio (ours was too slow)",
}
UP = (0.25, 0.0, -0.25)  # vertical offsets of the three tolerances in a scene's row
MARKERS = "s^Dvph<>"
COLUMNS = (
    *("model", "by", "steps, or 1 / tolerance", "per frames", "error / scale", "work"),
    *("time, ms", "lower quartile, ms", "upper quartile, ms"),
)


def draw(points: Sequence[Point], scene: Scene, png: Path) -> None:
    """Draw the chart of a scene, which shows how accurate and how fast each model is.

    A model is one way to simulate the scene, for example with a certain integrator. The left panel
    plots the error of each model against its processor time, and the right panel plots it against
    its work. The chart is saved as ``png``, and a CSV file next to it contains the plotted points.
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
    right.set(xlabel=scene.counted)
    for axes in (left, right):
        axes.set(xscale="log", yscale="log", ylabel="largest error / scale of the scene")
        axes.set_ylim(max(FLOOR, min(point.error for point in points)) / 3.0, CEILING)
        axes.grid(alpha=0.3)
    labels = left.get_legend_handles_labels()
    figure.legend(*labels, loc="outside lower center", ncols=5, fontsize=8.5, borderpad=0.8)
    figure.suptitle("\n".join((scene.name, *said(points, 1e-4))), fontsize=11)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)
    with png.with_suffix(".csv").open("w", encoding="utf-8", newline="") as file:
        per = {model.name: model.per for model in scene.models}
        rows = []
        for p in points:
            spent = (1e3 * time for time in (p.time, *p.spread))
            rows.append((p.model, p.by, p.steps, per[p.model], p.error, p.work, *spent))
        csv.writer(file).writerows([COLUMNS, *rows])


def _draw_extrapolated(
    axes: Axes, points: Sequence[Point], styles: dict[str, dict[str, Any]]
) -> None:
    """Draw a dotted line that extends pymunk's curve to smaller errors.

    The times on this line are extrapolated. The line ends at the smallest error tolerance for which
    an extrapolated time exists. If there is none, nothing is drawn.
    """
    rows = [row for row in table(points) if row.pymunk.order is not None]
    found = [(row.tolerance, row.pymunk) for row in sorted(rows, key=lambda row: -row.tolerance)]
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

    The left panel compares pymunk with our models that step the same equations, and the right panel
    with those that know more about the scene. The legend explains the marks.
    """
    scenes = list(dict.fromkeys(row.scene for row in rows))[::-1]
    figure, panels = pyplot.subplots(
        1, 2, figsize=(13, 0.42 * len(scenes) + 2.6), layout="constrained", sharey=True
    )
    ends = [end for found in rows for end in found.bounds if 0.0 < end < math.inf]
    low, high = min([0.1, *ends]) / 3.0, max([10.0, *ends]) * 10.0
    tolerances = sorted({row.tolerance for row in rows}, reverse=True)
    marks = {
        tolerance: (color, mark, up)
        for tolerance, color, mark, up in zip(
            tolerances, (ORANGE, BLUE, GREEN), "o^s", UP, strict=True
        )
    }
    for axes, is_formula, title in zip(panels, (False, True), TITLES, strict=True):
        axes.set(xscale="log", xlim=(low, high), ylim=(-0.7, len(scenes) - 0.3))
        axes.set(yticks=range(len(scenes)), yticklabels=scenes)
        axes.axvspan(low, 1.0, color=GRAY, alpha=0.12, lw=0)
        axes.axvline(1.0, color=BLACK, lw=1)
        for found in rows:
            color, mark, up = marks[found.tolerance]
            if found.is_formula == is_formula:
                _draw_ratio(axes, found, scenes.index(found.scene) + up, color, mark)
        axes.set_xlabel("time of pymunk / time of our fastest model with the same error")
        axes.set_title(title, fontsize=11)
        axes.grid(alpha=0.3)
    for tolerance, (color, mark, _) in marks.items():
        label = f"error of {tolerance:g} of the scale"
        panels[0].plot([], [], mark, color=color, label=label)
    for mark, label in OPEN.items():
        if mark != "o" or any(row.is_extrapolated for row in rows):
            panels[0].plot([], [], mark, color=GRAY, mfc="none", label=label)
    figure.suptitle(
        "How many times as long as ours does pymunk at its best take? In the gray area it is faster"
    )
    figure.legend(loc="outside lower center", ncols=3, fontsize=9)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)


def _draw_ratio(axes: Axes, found: Row, y: float, color: str, mark: str) -> None:
    """Draw one mark in the overview chart, at the ratio of pymunk's time to ours.

    The mark is drawn at height ``y``. It is filled if both times were measured, and open if
    pymunk's time is extrapolated. If only one of the two times is known, an arrow shows that the
    ratio is a bound. If no number of steps would meet the tolerance, the word "never" appears at
    the edge instead. There is no mark if neither pymunk nor our models reach the tolerance.
    """
    if found.ratio:
        face = "none" if found.is_extrapolated else color
        axes.plot(found.ratio, y, mark, color=color, mfc=face, ms=5)
    elif found.ours.time or found.pymunk.time:
        most = found.ours.time is None
        if (found.ours if most else found.pymunk).never:
            edge = axes.get_xlim()[not most] * (2.5 if most else 0.4)
            axes.text(edge, y, "never", color=color, ha="center", va="center", fontsize=7)
            return
        value = found.bounds[most]
        axes.plot(value, y, "<" if most else ">", color=color, mfc="none", ms=6)


def said(points: Sequence[Point], tolerance: float) -> list[str]:
    """Compare our fastest models of both kinds with pymunk's in a line each, for a title.

    For example, "steps, at an error of 1e-4: 3.2 ms (leapfrog); pymunk 12 times as long (pymunk, as
    in its examples)".
    """
    rows = [row(points, tolerance, is_formula=is_formula) for is_formula in (False, True)]
    return [_said(found) for found in rows if found]


def _said(found: Row) -> str:
    ours, theirs = found.ours, found.pymunk
    kind = "better model" if found.is_formula else "steps"
    start = f"{kind}, at an error of {power(found.tolerance)}: "
    if ours.time is None or theirs.time is None:
        mine, others = (told(side) for side in (ours, theirs))
        return f"{start}ours: {mine}; pymunk: {others}"
    many = theirs.time / ours.time
    end = f"{_number(many)} times as long" if many >= 1.0 else f"1/{_number(1.0 / many)} of that"
    end += ", extrapolated" * found.is_extrapolated
    return f"{start}{_number(1e3 * ours.time)} ms ({ours.model}); pymunk {end} ({theirs.model})"


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
    """Return the color and the marker of each model in a chart, which are the same in all charts.

    Pymunk's models are black or gray, and the textbook's are red.
    """
    styles: dict[str, dict[str, Any]] = {}
    for name, own in models_of(points).items():
        color, marker = looks()[name]
        is_single = math.isclose(own[0].steps, own[-1].steps)
        styles[name] = {"color": color, "marker": marker, "ls": "-", "ms": 11 if is_single else 5}
        if own[0].by == "pymunk":
            styles[name] |= {"ls": "--", "ms": 7}
    return styles


@cache
def looks() -> dict[str, tuple[str, str]]:
    """Return a color and a marker for every model of every scene."""
    from studies.accuracy.catalog import scenes_with

    found: dict[str, tuple[str, str]] = {}
    pairs = {
        "pymunk": ((c, m) for m in "x+*1234|_d" + MARKERS for c in (BLACK, GRAY)),
        "the book": ((RED, m) for m in "+*x1234"),
        "ours": ((c, m) for m in MARKERS for c in OURS),
    }
    for scene in scenes_with(""):
        for model in scene.models:
            if model.name not in found:
                own = OWN.get(model.name)
                found[model.name] = (own, "o") if own else next(pairs[model.by])
    return found
