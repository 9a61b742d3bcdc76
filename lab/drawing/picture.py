"""Draw the shapes that a scene's pen has recorded with matplotlib, for recordings and stills."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from matplotlib import patches
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from lab.drawing.pen import Item

SHEET = Path(__file__).parent.parent / "page" / "styles" / "colors.css"
LIGHT, DARK = (  # the page's colors by name, on light and on dark paper
    dict(re.findall(r"--(\w+): (#\w+);", sheet))
    for sheet in SHEET.read_text(encoding="utf-8").split("@media")
)
WIDTH, HEIGHT = 640.0, 400.0  # px, the size of a picture
TURNS = 24  # corners of a spring


class Painter:
    """Draws recorded shapes into matplotlib's axes, with a method for each kind of shape."""

    def __init__(self, axes: Axes, paint: Mapping[str, str], pixel: float) -> None:
        self.axes = axes
        self.paint = paint  # from names of colors to colors
        self.pixel = pixel  # in points; a pen gives the sizes of lines and letters in pixels
        left, right = axes.get_xlim()
        self.unit = (right - left) / WIDTH  # of the scene, for a pixel

    def draw(self, items: Iterable[Item]) -> list[Any]:
        """Draw each shape in front of the ones before it, and return matplotlib's artists."""
        drawn: list[Any] = []
        for kind, color, *values in items:
            self.look: Any = {"color": self.paint[color], "zorder": 3.0 + 0.001 * len(drawn)}
            drawn += getattr(self, kind)(*values)
        return drawn

    def stroke(self, xs: Iterable[float], ys: Iterable[float], width: float, **more: Any) -> Any:
        return self.axes.plot([*xs], [*ys], lw=self.pixel * width, **self.look, **more)

    def circle(self, x: float, y: float, radius: float, fill: bool, _: str) -> Any:
        line = 0.0 if fill else 2.0 * self.pixel
        circle = patches.Circle((x, y), max(radius, self.unit), fill=fill, lw=line, **self.look)
        return [self.axes.add_patch(circle)]

    def dots(self, flat: list[float], size: float) -> Any:
        return self.stroke(flat[::2], flat[1::2], 0.0, marker="o", ms=self.pixel * size, mew=0.0)

    def line(self, flat: list[float], width: float, dashed: bool) -> Any:
        style = (0, (6.0 / width, 5.0 / width)) if dashed else "-"
        return self.stroke(flat[::2], flat[1::2], width, ls=style)

    def segments(self, flat: list[float], width: float) -> Any:
        ends = [*zip(flat[::2], flat[1::2], strict=True)]
        lines = [*zip(ends[::2], ends[1::2], strict=True)]
        found = LineCollection(lines, linewidths=self.pixel * width, **self.look)
        return [self.axes.add_collection(found)]

    def area(self, flat: list[float], solid: bool) -> Any:
        corners, alpha = [*zip(flat[::2], flat[1::2], strict=True)], 1.0 if solid else 0.3
        return [self.axes.add_patch(patches.Polygon(corners, alpha=alpha, lw=0.0, **self.look))]

    def spring(self, ax: float, ay: float, bx: float, by: float) -> Any:
        dx, dy = (bx - ax) / TURNS, (by - ay) / TURNS
        side = 7.0 * self.unit / (math.hypot(dx, dy) or 1.0)
        off = [0.0 if i < 3 or i > TURNS - 3 else side * (-1) ** i for i in range(TURNS + 1)]
        xs = [ax + dx * i - dy * off[i] for i in range(TURNS + 1)]
        ys = [ay + dy * i + dx * off[i] for i in range(TURNS + 1)]
        return self.stroke(xs, ys, 1.5)

    def arrow(self, x: float, y: float, dx: float, dy: float, _: str) -> Any:
        length = math.hypot(dx, dy)
        if length < 2.0 * self.unit:
            return []
        head, angle = min(9.0 * self.unit, length / 2.0), math.atan2(dy, dx)
        xs, ys = [x, x + dx], [y, y + dy]
        for side in (2.6, -2.6):  # rad, from the direction of the arrow to a barb
            xs += [x + dx + head * math.cos(angle + side), x + dx]
            ys += [y + dy + head * math.sin(angle + side), y + dy]
        return self.stroke(xs, ys, 2.0, clip_on=False)

    def text(self, x: float, y: float, words: str, size: float) -> Any:
        size *= self.pixel
        return [self.axes.text(x, y, words, size=size, ha="center", va="center", **self.look)]

    def ground(self, height: float) -> Any:
        bottom, _ = self.axes.get_ylim()
        earth = self.axes.axhspan(bottom, height, alpha=0.25, lw=0.0, **self.look)
        return [earth, self.axes.axhline(height, lw=2.0 * self.pixel, **self.look)]
