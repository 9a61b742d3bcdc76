"""Draw a box in 3D, with only the faces that the viewer can see."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

from ch02_vectors.vector import Vector3
from lab.drawing.camera import TOWARD, flat
from lab.drawing.pen import Pen

COLORS = ("blue", "orange", "green")  # of the faces perpendicular to X, Y and Z
VIEWER = Vector3(*TOWARD, 1.0)


def draw_box(
    pen: Pen,
    sides: tuple[float, float, float],  # m
    turn: Callable[[Vector3], Vector3],  # from the box's own axes to the world's
    center: tuple[float, float] = (0.0, 0.0),  # in the picture
) -> None:
    """Draw a rotated box."""
    x0, y0 = center
    around = ((-1, -1), (1, -1), (1, 1), (-1, 1))  # counter-clockwise, if seen from outside
    for axis, sign in product(range(3), (-1, 1)):
        signs = [(sign, *pair) for pair in around[::sign]]  # along this axis and the next two
        own = [Vector3(*(0.5 * sides[i] * s[i - axis] for i in range(3))) for s in signs]
        corners = [turn(corner) for corner in own]
        normal = (corners[1] - corners[0]).cross(corners[2] - corners[1])  # points outward
        if normal.dot(VIEWER) > 0.0:
            seen = [(x0 + x, y0 + y) for x, y in map(flat, corners)]
            pen.area(seen, COLORS[axis])
            pen.line([*seen, seen[0]], COLORS[axis], 3.0)
