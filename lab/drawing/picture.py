"""Draw the shapes that a scene's pen has recorded with matplotlib, for recordings and stills."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
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
WIDTH, HEIGHT = 640.0, 400.0  # px, of a picture for which sizes in pixels are meant
TURNS = 24  # corners of a spring


def draw_items(
    axes: Axes, items: Iterable[Item], paint: Mapping[str, str], pixel: float
) -> list[Any]:
    """Draw recorded shapes, each in front of the ones before it, and return matplotlib's artists.

    ``paint`` maps names of colors to colors. ``pixel`` is the length in points of a pixel, in which
    a pen gives the widths of lines and the sizes of letters.
    """
    drawn = []
    for kind, color, *values in items:
        style = {"color": paint[color], "zorder": 3.0 + 0.001 * len(drawn)}
        drawn += DRAW[kind](axes, style, pixel, *values)
    return drawn


def _unit(axes: Axes) -> float:
    """Return the length of a pixel in the scene's units, if the picture is WIDTH px wide."""
    left, right = axes.get_xlim()
    return (right - left) / WIDTH


def _pairs(flat: list[float]) -> list[tuple[float, float]]:
    return list(zip(flat[::2], flat[1::2], strict=True))


def _circle(
    axes: Axes, paint: Any, pixel: float, x: float, y: float, radius: float, fill: bool, _: str
) -> list[Any]:
    size = max(radius, _unit(axes))
    circle = patches.Circle((x, y), size, fill=fill, lw=0.0 if fill else 2.0 * pixel, **paint)
    return [axes.add_patch(circle)]


def _dots(axes: Axes, paint: Any, pixel: float, flat: list[float], size: float) -> list[Any]:
    return axes.plot(flat[::2], flat[1::2], "o", ms=pixel * size, mew=0.0, **paint)


def _line(
    axes: Axes, paint: Any, pixel: float, flat: list[float], width: float, dashed: bool
) -> list[Any]:
    style = (0, (6.0 / width, 5.0 / width)) if dashed else "-"
    return axes.plot(flat[::2], flat[1::2], ls=style, lw=pixel * width, **paint)


def _segments(axes: Axes, paint: Any, pixel: float, flat: list[float], width: float) -> list[Any]:
    ends = _pairs(flat)
    lines = list(map(list, zip(ends[::2], ends[1::2], strict=True)))
    return [axes.add_collection(LineCollection(lines, linewidths=pixel * width, **paint))]


def _area(axes: Axes, paint: Any, _: float, flat: list[float], solid: bool) -> list[Any]:
    shape = patches.Polygon(_pairs(flat), alpha=1.0 if solid else 0.3, lw=0.0, **paint)
    return [axes.add_patch(shape)]


def _spring(
    axes: Axes, paint: Any, pixel: float, ax: float, ay: float, bx: float, by: float
) -> list[Any]:
    dx, dy = bx - ax, by - ay
    length = math.hypot(dx, dy) or 1.0
    side = 7.0 * _unit(axes)
    offsets = [0.0 if i < 3 or i > TURNS - 3 else side * (-1) ** i for i in range(TURNS + 1)]
    xs = [ax + dx * i / TURNS - dy / length * off for i, off in enumerate(offsets)]
    ys = [ay + dy * i / TURNS + dx / length * off for i, off in enumerate(offsets)]
    return axes.plot(xs, ys, lw=1.5 * pixel, **paint)


def _arrow(
    axes: Axes, paint: Any, pixel: float, x: float, y: float, dx: float, dy: float, _: str
) -> list[Any]:
    length = math.hypot(dx, dy)
    if length < 2.0 * _unit(axes):
        return []
    head, angle = min(9.0 * _unit(axes), length / 2.0), math.atan2(dy, dx)
    tip = x + dx, y + dy
    barbs = [
        (tip[0] + head * math.cos(angle + side), tip[1] + head * math.sin(angle + side))
        for side in (2.6, -2.6)
    ]
    xs, ys = zip((x, y), tip, barbs[0], tip, barbs[1], strict=True)
    return axes.plot(xs, ys, lw=2.0 * pixel, clip_on=False, **paint)


def _text(
    axes: Axes, paint: Any, pixel: float, x: float, y: float, words: str, size: float
) -> list[Any]:
    return [axes.text(x, y, words, fontsize=pixel * size, ha="center", va="center", **paint)]


def _ground(axes: Axes, paint: Any, pixel: float, height: float) -> list[Any]:
    bottom, _ = axes.get_ylim()
    earth = axes.axhspan(bottom, height, alpha=0.25, lw=0.0, **paint)
    return [earth, axes.axhline(height, lw=2.0 * pixel, **paint)]


DRAW: dict[str, Callable[..., list[Any]]] = {
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
