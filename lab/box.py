"""Draw a box in space: the faces that point toward the viewer, in one color per axis."""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.vector import Vector3
from lab.camera import TOWARD, flat
from lab.pen import Pen

COLORS = ("blue", "orange", "green")  # of the faces along X, Y and Z
VIEWER = Vector3(*TOWARD, 1.0)


def draw_box(
    pen: Pen,
    sides: tuple[float, float, float],
    turn: Callable[[Vector3], Vector3],
    center: tuple[float, float] = (0.0, 0.0),
) -> None:
    """Draw a box with these sides in m, with ``turn`` from its own axes to those of the world."""
    x0, y0 = center
    for face, axis in _faces(sides):
        corners = [turn(corner) for corner in face]
        normal = (corners[1] - corners[0]).cross(corners[2] - corners[1])
        if normal.dot(VIEWER) > 0.0:
            seen = [(x0 + x, y0 + y) for x, y in map(flat, corners)]
            pen.area(seen, COLORS[axis])
            pen.line([*seen, seen[0]], COLORS[axis], 3.0)


def _faces(sides: tuple[float, float, float]) -> list[tuple[list[Vector3], int]]:
    """Return the corners of the six faces, counter-clockwise from outside, and their axes."""
    around = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    faces = []
    for axis in range(3):
        for sign in (-1, 1):
            signs = [(sign, *pair) for pair in around[::sign]]  # of the axis and the two after it
            corners = [Vector3(*(0.5 * sides[i] * s[i - axis] for i in range(3))) for s in signs]
            faces.append((corners, axis))
    return faces
