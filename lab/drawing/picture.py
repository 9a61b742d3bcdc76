"""Draw a scene of the lab with matplotlib, for windows and recordings.

A scene only records its shapes with a ``Pen``. This module draws the recorded shapes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from matplotlib import patches
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from lab.drawing.pen import Item, Pen
from lab.scene import Scene

# The colors of the light page (page/styles/colors.css).
PAINT = {
    "blue": "#0072b2",
    "orange": "#d08a00",
    "green": "#008060",
    "red": "#d55e00",
    "sky": "#3a9fd8",
    "pink": "#b8578a",
    "violet": "#7a00c8",
    "brown": "#7a4a10",
    "gray": "#6b7078",
    "black": "#1a1a1a",
    "water": "#3a9fd8",
    "wood": "#9a6324",
}
TURNS = 24  # corners of a spring


class Picture:
    """A matplotlib figure of an interactive scene, which can be redrawn after every step."""

    def __init__(self, scene: Scene, figure: Figure, *, arrows: bool = True) -> None:
        self.scene = scene
        self.figure = figure
        self.arrows = arrows
        self.axes = figure.subplots()
        self.title = figure.suptitle("", fontsize=10)
        self.drawn: list[Any] = []

    def draw(self) -> None:
        """Redraw the figure to show the current state of the scene."""
        for artist in self.drawn:
            artist.remove()
        pen = Pen()
        self.scene.draw(pen)
        left, right, bottom, top = self.scene.view
        self.axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
        self.drawn = [
            artist
            for kind, color, *values in pen.items
            if kind != "arrow" or self.arrows
            for artist in DRAW[kind](self.axes, PAINT[color], values)
        ]
        self.title.set_text(f"{self.scene.title}, {self.scene.time:.2f} s\n{self.scene.facts()}")


def _pairs(flat: list[float]) -> list[tuple[float, float]]:
    return list(zip(flat[::2], flat[1::2], strict=True))


def _circle(axes: Axes, paint: str, values: Item) -> list[Any]:
    x, y, radius, fill, _ = values
    return [axes.add_patch(patches.Circle((x, y), radius, color=paint, fill=fill, zorder=3))]


def _dots(axes: Axes, paint: str, values: Item) -> list[Any]:
    flat, size = values
    return axes.plot(flat[::2], flat[1::2], "o", color=paint, ms=0.7 * size, zorder=3)


def _line(axes: Axes, paint: str, values: Item) -> list[Any]:
    flat, width, dashed = values
    style = "--" if dashed else "-"
    return axes.plot(flat[::2], flat[1::2], style, color=paint, lw=0.7 * width)


def _segments(axes: Axes, paint: str, values: Item) -> list[Any]:
    flat, width = values
    ends = _pairs(flat)
    lines = list(map(list, zip(ends[::2], ends[1::2], strict=True)))
    return [axes.add_collection(LineCollection(lines, colors=paint, linewidths=0.7 * width))]


def _area(axes: Axes, paint: str, values: Item) -> list[Any]:
    flat, solid = values
    alpha = 1.0 if solid else 0.3
    return [axes.add_patch(patches.Polygon(_pairs(flat), color=paint, alpha=alpha, lw=0))]


def _spring(axes: Axes, paint: str, values: Item) -> list[Any]:
    ax, ay, bx, by = values
    dx, dy = bx - ax, by - ay
    length = math.hypot(dx, dy) or 1.0
    left, right = axes.get_xlim()
    side = 0.012 * (right - left)
    offsets = [0.0 if i < 3 or i > TURNS - 3 else side * (-1) ** i for i in range(TURNS + 1)]
    xs = [ax + dx * i / TURNS - dy / length * off for i, off in enumerate(offsets)]
    ys = [ay + dy * i / TURNS + dx / length * off for i, off in enumerate(offsets)]
    return axes.plot(xs, ys, color=paint, lw=1)


def _arrow(axes: Axes, paint: str, values: Item) -> list[Any]:
    x, y, dx, dy, _ = values
    style = {"arrowstyle": "->", "color": paint, "lw": 1.5, "shrinkA": 0, "shrinkB": 0}
    return [axes.annotate("", (x + dx, y + dy), (x, y), arrowprops=style, annotation_clip=False)]


def _text(axes: Axes, paint: str, values: Item) -> list[Any]:
    x, y, words, size = values
    return [axes.text(x, y, words, color=paint, fontsize=0.7 * size, ha="center", va="center")]


def _ground(axes: Axes, paint: str, values: Item) -> list[Any]:
    bottom, _ = axes.get_ylim()
    return [axes.axhspan(bottom, values[0], color=paint, alpha=0.25, lw=0)]


DRAW: dict[str, Callable[[Axes, str, Item], list[Any]]] = {
    "circle": _circle,
    "dots": _dots,
    "line": _line,
    "segments": _segments,
    "area": _area,
    "spring": _spring,
    "arrow": _arrow,
    "text": _text,
    "ground": _ground,
}
