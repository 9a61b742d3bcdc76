"""Draw a box in 3D, with only the faces that the viewer can see.

Opposite faces have the same color, so that the reader can tell the three axes of the box apart.
"""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.vector import Vector3
from lab.drawing.camera import TOWARD, flat
from lab.drawing.pen import Pen

COLORS = ("blue", "orange", "green")  # of the faces perpendicular to X, Y and Z
VIEWER = Vector3(*TOWARD, 1.0)


def draw_box(
    pen: Pen,
    sides: tuple[float, float, float],
    turn: Callable[[Vector3], Vector3],
    center: tuple[float, float] = (0.0, 0.0),
) -> None:
    """Draw a rotated box in 3D.

    ``sides`` are the lengths of its sides in m. ``turn`` is a function that converts a vector from
    the box's own axes to those of the world. ``center`` is the position of the box's center in the
    picture.
    """
    x0, y0 = center
    for face, axis in _faces(sides):
        corners = [turn(corner) for corner in face]
        normal = (corners[1] - corners[0]).cross(corners[2] - corners[1])
        if normal.dot(VIEWER) > 0.0:
            seen = [(x0 + x, y0 + y) for x, y in map(flat, corners)]
            pen.area(seen, COLORS[axis])
            pen.line([*seen, seen[0]], COLORS[axis], 3.0)


def _faces(sides: tuple[float, float, float]) -> list[tuple[list[Vector3], int]]:
    """List the six faces of a box, each with its corners and the axis perpendicular to it.

    The axis is 0 for X, 1 for Y or 2 for Z. The corners run counter-clockwise as seen from outside
    the box, so the cross product of two successive edges points outward.
    """
    around = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    faces = []
    for axis in range(3):
        for sign in (-1, 1):
            signs = [(sign, *pair) for pair in around[::sign]]  # along this axis and the next two
            corners = [Vector3(*(0.5 * sides[i] * s[i - axis] for i in range(3))) for s in signs]
            faces.append((corners, axis))
    return faces
