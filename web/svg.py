"""Draw a scene as an SVG picture, in the light and dark colors of the lab's page."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import Any

from lab.drawing.pen import Item

COLORS = Path(__file__).parent.parent / "lab" / "page" / "styles" / "colors.css"
WIDTH, HEIGHT = 640.0, 400.0  # of every picture, in pixels
TURNS = 24  # corners in the zigzag of a spring
HIDDEN = ("force", "contact")  # arrows that a page shows only on request


class View:
    """Converts the coordinates of a scene to pixels, in the same way as the lab's page.

    A scene has its own units, and its y axis points up. The pixels are whole, which makes the files
    smaller.
    """

    def __init__(self, view: tuple[float, float, float, float]) -> None:
        left, right, bottom, top = view
        self.scale = min(WIDTH / (right - left), HEIGHT / (top - bottom))
        self.dx = WIDTH / 2.0 - self.scale * (left + right) / 2.0
        self.dy = HEIGHT / 2.0 + self.scale * (bottom + top) / 2.0

    def x(self, x: float) -> float:
        return round(self.dx + self.scale * x)

    def y(self, y: float) -> float:
        return round(self.dy - self.scale * y)

    def points(self, flat: list[float]) -> list[tuple[float, float]]:
        """Convert a flat list of coordinates (x, y, x, y, ...) to points in pixels."""
        return [(self.x(x), self.y(y)) for x, y in zip(flat[::2], flat[1::2], strict=True)]


def svg(items: list[Item], view: tuple[float, float, float, float]) -> str:
    """Turn the shapes that a scene's pen has recorded into an SVG picture of the scene."""
    place = View(view)
    shapes = "\n".join(shape for kind, *values in items if (shape := DRAW[kind](place, *values)))
    width, height = f"{WIDTH:g}", f"{HEIGHT:g}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        f'width="{width}" height="{height}" fill="none" stroke-width="2">\n'
        f"<style>{_style({item[1] for item in items})}</style>\n{shapes}\n</svg>\n"
    )


def _style(names: set[str]) -> str:
    """Write CSS rules for the named colors, with the values from the lab's style sheet."""
    light, dark = COLORS.read_text(encoding="utf-8").split("@media")
    rules = []
    for sheet in (light, dark):
        values = dict(re.findall(r"--(\w+): (#\w+);", sheet))
        rules.append("".join(f".{name}{{color:{values[name]}}}" for name in sorted(names)))
    return f"{rules[0]}@media (prefers-color-scheme:dark){{{rules[1]}}}"


def _path(points: list[tuple[float, float]], *, closed: bool = False) -> str:
    return "M" + "L".join(f"{x:g} {y:g}" for x, y in points) + ("Z" if closed else "")


def _line(color: str, path: str, width: float = 2.0, more: str = "") -> str:
    return (
        f'<path class="{color}" stroke="currentColor" stroke-width="{width:g}"{more} d="{path}"/>'
    )


def _circle(at: View, color: str, x: float, y: float, radius: float, fill: bool, _: str) -> str:
    paint = "fill" if fill else "stroke"
    size = max(1.0, at.scale * radius)
    where = f'cx="{at.x(x):g}" cy="{at.y(y):g}" r="{size:.1f}"'
    return f'<circle class="{color}" {paint}="currentColor" {where}/>'


def _dots(at: View, color: str, flat: list[float], size: float) -> str:
    path = "".join(f"M{x:g} {y:g}h0" for x, y in at.points(flat))
    return _line(color, path, size, ' stroke-linecap="round"')


def _polyline(at: View, color: str, flat: list[float], width: float, dashed: bool) -> str:
    return _line(color, _path(at.points(flat)), width, ' stroke-dasharray="6 5"' * dashed)


def _segments(at: View, color: str, flat: list[float], width: float) -> str:
    ends = at.points(flat)
    path = "".join(_path([a, b]) for a, b in zip(ends[::2], ends[1::2], strict=True))
    return _line(color, path, width)


def _area(at: View, color: str, flat: list[float], solid: bool) -> str:
    faint = "" if solid else ' fill-opacity="0.3"'
    path = _path(at.points(flat), closed=True)
    return f'<path class="{color}" fill="currentColor"{faint} d="{path}"/>'


def _spring(at: View, color: str, ax: float, ay: float, bx: float, by: float) -> str:
    (x, y), (end_x, end_y) = at.points([ax, ay, bx, by])
    dx, dy = end_x - x, end_y - y
    length = math.hypot(dx, dy) or 1.0
    corners = []
    for i in range(TURNS + 1):
        side = 0.0 if i < 3 or i > TURNS - 3 else 7.0 * (-1) ** (i + 1)
        corners.append(
            (
                round(x + dx * i / TURNS - dy / length * side, 1),
                round(y + dy * i / TURNS + dx / length * side, 1),
            )
        )
    return _line(color, _path(corners), 1.5)


def _arrow(at: View, color: str, x: float, y: float, vx: float, vy: float, kind: str) -> str:
    (px, py), (ex, ey) = at.points([x, y, x + vx, y + vy])
    length = math.hypot(ex - px, ey - py)
    if length < 2.0 or kind in HIDDEN:
        return ""
    head, angle = min(9.0, length / 2.0), math.atan2(ey - py, ex - px)
    barbs = [
        (round(ex + head * math.cos(angle + a), 1), round(ey + head * math.sin(angle + a), 1))
        for a in (2.6, -2.6)
    ]
    return _line(color, _path([(px, py), (ex, ey)]) + _path([barbs[0], (ex, ey), barbs[1]]))


def _text(at: View, color: str, x: float, y: float, words: str, size: float) -> str:
    where = f'x="{at.x(x):g}" y="{at.y(y):g}" font-size="{size:g}"'
    style = 'font-family="system-ui, sans-serif" text-anchor="middle" dominant-baseline="central"'
    return f'<text class="{color}" fill="currentColor" {where} {style}>{escape(words)}</text>'


def _ground(at: View, color: str, height: float) -> str:
    y = at.y(height)
    earth = f"M0 {y:g}H{WIDTH:g}V{HEIGHT:g}H0Z"
    area = f'<path class="{color}" fill="currentColor" fill-opacity="0.25" d="{earth}"/>'
    return area + _line(color, f"M0 {y:g}H{WIDTH:g}")


DRAW: dict[str, Callable[..., Any]] = {
    "circle": _circle,
    "dots": _dots,
    "line": _polyline,
    "segments": _segments,
    "area": _area,
    "spring": _spring,
    "arrow": _arrow,
    "text": _text,
    "ground": _ground,
}
