"""Draw a scene's points: error over processor time, and over what was worked out."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib import pyplot

from studies.accuracy.measure import Point
from studies.accuracy.results import Row, front, models_of, row
from studies.drawing import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, YELLOW

FLOOR, CEILING = 1e-15, 10.0  # errors below and above are rounding, and no answer
OURS = (BLUE, GREEN, ORANGE, SKY, PINK, YELLOW)
MARKERS = "os^Dvp"
COLUMNS = (
    *("model", "by", "steps a frame", "error / scale", "work"),
    *("time, ms", "lower quartile, ms", "upper quartile, ms"),
)


def draw(points: Sequence[Point], counted: str, png: Path) -> None:
    """Write the chart of one scene, and a table of its points beside it."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(14, 6.5), layout="constrained")
    styles = _styles(points)
    edge = front(points)
    left.plot(
        [1e3 * point.time for point in edge],
        [max(point.error, FLOOR) for point in edge],
        color=YELLOW,
        lw=9,
        alpha=0.45,
        label="front of the best",
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
        label = name if seen else f"{name}: nowhere near"
        left.errorbar(times, errors, xerr=around, capsize=2, label=label, **styles[name])
        right.plot([point.work for point in seen], errors, **styles[name])
    left.set(xlabel="processor time of the scene, ms (bars: quartiles)")
    right.set(xlabel=counted)
    for axes in (left, right):
        axes.set(xscale="log", yscale="log", ylabel="largest error / scale of the scene")
        axes.set_ylim(FLOOR / 3.0, CEILING)
        axes.grid(alpha=0.3)
    left.legend(fontsize=8.5, loc="best")
    figure.suptitle(f"{points[0].scene}\n{said(row(points, 1e-4))}", fontsize=11)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)
    with png.with_suffix(".csv").open("w", encoding="utf-8", newline="") as file:
        rows = [
            (p.model, p.by, p.steps, p.error, p.work, *(1e3 * t for t in (p.time, *p.spread)))
            for p in points
        ]
        csv.writer(file).writerows([COLUMNS, *rows])


def said(found: Row) -> str:
    """Return a row of the table as a sentence."""
    ours, theirs = found.ours, found.pymunk
    start = f"to {found.tolerance:g} of the scale: "
    if ours is None:
        return f"{start}nothing of ours gets there" + (f", {theirs.model} does" if theirs else "")
    mine = f"{ours.model} takes {1e3 * ours.time:.3g} ms"
    if theirs is None and found.stalled:
        return f"{start}{mine}, pymunk never gets there: its error does not fall any more"
    if theirs is None:
        longest = found.longest / ours.time
        return f"{start}{mine}, pymunk more than {longest:.3g} times as long"
    many = theirs.time / ours.time
    end = f"{many:.3g} times as long" if many >= 1.0 else f"1/{1.0 / many:.3g} of that"
    return f"{start}{mine}, {theirs.model} {end}"


def _styles(points: Sequence[Point]) -> dict[str, dict[str, Any]]:
    """Return how each model is drawn: pymunk's in black and grey, the book's in red."""
    styles: dict[str, dict[str, Any]] = {}
    theirs, colors = iter((BLACK, GREY)), iter(zip(OURS, MARKERS, strict=True))
    for name, own in models_of(points).items():
        if own[0].by == "pymunk":
            styles[name] = {"color": next(theirs), "marker": "x", "ls": "--", "ms": 7}
        elif own[0].by == "the book":
            many = sum(style["color"] == RED for style in styles.values())
            styles[name] = {"color": RED, "marker": "+*"[many % 2], "ls": "-", "ms": 8}
        else:
            color, marker = next(colors, (BLACK, "."))
            size = 11 if math.isclose(own[0].steps, own[-1].steps) else 5
            styles[name] = {"color": color, "marker": marker, "ls": "-", "ms": size}
    return styles
