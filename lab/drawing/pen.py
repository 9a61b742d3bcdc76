"""Record what a scene draws as plain data, for a web page or matplotlib to draw later.

Coordinates are in the scene's units, with +y up. Widths, dots and letters are in pixels.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

COLORS = (  # names, so that a page can choose shades for a light or a dark background
    *("blue", "orange", "green", "red", "sky", "pink"),
    *("violet", "brown", "gray", "black", "water", "wood"),
)
ARROWS = ("velocity", "force", "contact")  # kinds that the reader can show or hide


class HasXY(Protocol):
    """Any object with x and y attributes, such as a Vector3."""

    x: float
    y: float


Point = HasXY | tuple[float, float]
Item = list[Any]


class Pen:
    """Records the shapes that a scene draws, as lists of a kind, a color and the kind's values."""

    def __init__(self) -> None:
        self.items: list[Item] = []

    def circle(
        self,
        center: Point,
        radius: float,
        color: str = "blue",
        *,
        grab: str = "",
        fill: bool = True,
    ) -> None:
        """Draw a circle. If it has a name to ``grab``, the reader can drag it (see Scene.drag)."""
        self._add("circle", color, *_xy(center), _short(radius), fill, grab)

    def dots(self, centers: Iterable[Point], color: str = "blue", size: float = 4.0) -> None:
        self._add("dots", color, _flat(centers), size)

    def line(
        self,
        points: Iterable[Point],
        color: str = "black",
        width: float = 2.0,
        *,
        dashed: bool = False,
    ) -> None:
        self._add("line", color, _flat(points), width, dashed)

    def segments(
        self, pairs: Iterable[tuple[Point, Point]], color: str = "black", width: float = 1.0
    ) -> None:
        self._add("segments", color, _flat(end for pair in pairs for end in pair), width)

    def area(self, corners: Iterable[Point], color: str = "gray", *, solid: bool = False) -> None:
        """Fill a polygon with a color, which is translucent unless ``solid`` is true."""
        self._add("area", color, _flat(corners), solid)

    def spring(self, a: Point, b: Point, color: str = "gray") -> None:
        """Draw a spring as a zigzag line between two points."""
        self._add("spring", color, *_xy(a), *_xy(b))

    def arrow(self, start: Point, vector: Point, color: str = "green", kind: str = "") -> None:
        """Draw an arrow to ``start + vector``. The reader can hide all arrows of a ``kind``."""
        self._add("arrow", color, *_xy(start), *_xy(vector), kind)

    def text(self, at: Point, words: str, color: str = "black", size: float = 14.0) -> None:
        """Write ``words`` centered at the point ``at``."""
        self._add("text", color, *_xy(at), words, size)

    def ground(self, height: float = 0.0) -> None:
        """Draw level ground that extends across the whole view."""
        self._add("ground", "gray", _short(height))

    def _add(self, kind: str, color: str, *values: Any) -> None:
        if color not in COLORS:
            raise ValueError(f"color must be one of {', '.join(COLORS)}, got {color!r}")
        self.items.append([kind, color, *values])


def _xy(point: Point) -> tuple[float, float]:
    x, y = point if isinstance(point, tuple) else (point.x, point.y)
    return _short(x), _short(y)


def _flat(points: Iterable[Point]) -> list[float]:
    return [coordinate for point in points for coordinate in _xy(point)]


def _short(value: float) -> float:
    """Round a value to five significant digits, which keeps messages short."""
    return float(f"{value:.5g}")
