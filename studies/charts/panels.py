"""Prepare the chart and the table that the page of charts shows for each scene.

The chart plots the error of every model against its time. The table contains the same numbers.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from plots.drawing import (
    BLACK,
    BLUE,
    BROWN,
    GRAY,
    GREEN,
    ORANGE,
    PINK,
    RED,
    SKY,
    VIOLET,
    YELLOW,
)
from scenes.clock import RATE
from studies.accuracy.chart import CEILING, FLOOR, said, styles_of
from studies.accuracy.measure import Point
from studies.accuracy.results import front, models_of
from studies.accuracy.scene import Scene
from studies.charts.axes import Axis, axis_for

WIDTH, HEIGHT = 380, 290
LEFT, RIGHT, TOP, BOTTOM = 52.0, 360.0, 10.0, 246.0
# The page has two shades of each color, for its light mode and for its dark mode.
NAMES = {
    BLACK: "black",
    BLUE: "blue",
    BROWN: "brown",
    GRAY: "gray",
    GREEN: "green",
    ORANGE: "orange",
    PINK: "pink",
    RED: "red",
    SKY: "sky",
    VIOLET: "violet",
    YELLOW: "yellow",
}
# The same marks as in the pictures, as SVG paths around 0, by their names in matplotlib.
MARKS = {
    "o": "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z",
    "s": "M-3.5,-3.5h7v7h-7z",
    "^": "M0,-4.5L4.5,3.5H-4.5z",
    "v": "M0,4.5L4.5,-3.5H-4.5z",
    "<": "M-4.5,0L3.5,-4.5V4.5z",
    ">": "M4.5,0L-3.5,-4.5V4.5z",
    "D": "M0,-5L5,0L0,5L-5,0z",
    "d": "M0,-5L3,0L0,5L-3,0z",
    "p": "M0,-4.6L4.4,-1.4L2.7,3.7H-2.7L-4.4,-1.4z",
    "h": "M0,-4.6L4,-2.3V2.3L0,4.6L-4,2.3V-2.3z",
    "x": "M-4,-4L4,4M-4,4L4,-4",
    "+": "M-5.5,0H5.5M0,-5.5V5.5",
    "1": "M0,0V5.5M0,0L-4.8,-2.8M0,0L4.8,-2.8",
    "2": "M0,0V-5.5M0,0L-4.8,2.8M0,0L4.8,2.8",
    "3": "M0,0H-5.5M0,0L2.8,4.8M0,0L2.8,-4.8",
    "4": "M0,0H5.5M0,0L-2.8,4.8M0,0L-2.8,-4.8",
    "|": "M0,-5.5V5.5",
    "_": "M-5.5,0H5.5",
    "*": "M-5,0H5M-2.5,-4.4L2.5,4.4M-2.5,4.4L2.5,-4.4",
}
IDS = {mark: f"mark{i}" for i, mark in enumerate(MARKS)}
SIDES = {"pymunk": "pymunk", "the book": "the book's step"}  # our own models need no remark


@dataclass(frozen=True)
class Drawn:
    """The line of one model in the chart of a scene, with its color and its marks.

    Each of the ``points`` is a tuple of x, y and the index of the point's row in the table.
    """

    name: str
    side: str
    color: str
    mark: str
    path: str
    points: list[tuple[float, float, int]]


@dataclass(frozen=True)
class Panel:
    """A scene's section of the page of charts, with a description, a chart and a table."""

    name: str
    id: str
    about: str
    said: list[str]
    counted: str
    x: Axis
    y: Axis
    front: str
    models: list[Drawn]
    rows: list[tuple[str, ...]]


def panel(scene: Scene, points: Sequence[Point]) -> Panel:
    """Prepare the chart and the table of a scene from its measured points.

    Runs whose error is too large to be useful are left out of the chart.
    """
    # Errors that come only from rounding are drawn at the floor. Useless runs are not drawn.
    seen = [point for point in points if point.error < CEILING]
    x = axis_for([1e3 * point.time for point in seen] or [1.0], LEFT, RIGHT)
    y = axis_for([*(max(point.error, FLOOR) for point in seen), 0.1], BOTTOM, TOP)
    styles = styles_of(points)

    def place(point: Point) -> tuple[float, float]:
        return x.at(1e3 * point.time), y.at(max(point.error, FLOOR))

    order = {id(point): i for i, point in enumerate(points)}
    models = []
    for name, own in models_of(points).items():
        placed = [(*place(point), order[id(point)]) for point in own if point.error < CEILING]
        style = styles[name]
        color, mark = NAMES[style["color"]], IDS[style["marker"]]
        path = _path([(a, b) for a, b, _ in placed])
        models.append(Drawn(name, SIDES.get(own[0].by, ""), color, mark, path, placed))
    best = [place(point) for point in front(points) if point.error < CEILING]
    seconds = f"{scene.frames / RATE:.3g}"
    return Panel(
        scene.name,
        re.sub("[^a-z0-9]+", "-", scene.name.lower()).strip("-"),
        f"{seconds} s; errors in units of its scale, {scene.scale:.3g} m",
        said(points, 1e-4),
        scene.counted,
        x,
        y,
        _path(best),
        models,
        [_row(scene, point) for point in points],
    )


def _path(places: Sequence[tuple[float, float]]) -> str:
    """Build an SVG path through the points ``places``. A single point becomes a dot."""
    if len(places) == 1:
        return f"M{places[0][0]:g},{places[0][1]:g}h0"
    return "M" + "L".join(f"{a:g},{b:g}" for a, b in places) if places else ""


def _row(scene: Scene, point: Point) -> tuple[str, ...]:
    """Format a measured point as a row of a scene's table.

    The first columns are the model, its number of steps or its tolerance, and the error. They are
    followed by the median and the quartiles of the time, and by the amount of work.
    """
    model = next(model for model in scene.models if model.name == point.model)
    choice = model.chosen(point.steps)
    low, high = point.spread
    return (
        point.model,
        choice,
        f"{point.error:.2g}" if point.error < CEILING else "useless",
        f"{1e3 * point.time:.3g}",
        f"{1e3 * low:.3g} to {1e3 * high:.3g}",
        f"{point.work:,}",
    )
