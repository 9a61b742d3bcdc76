"""Project points in 3D space onto the flat picture of a scene, and draw boxes.

In the picture, x points to the right, y points up, and z points toward the lower left.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

from ch02_vectors.vector import Vector3
from lab.drawing.pen import Pen

TOWARD = (0.4, 0.3)  # how far one unit along z moves a point to the left and down
COLORS = ("blue", "orange", "green")  # of the faces of a box perpendicular to X, Y and Z
VIEWER = Vector3(*TOWARD, 1.0)


def flat(v: Vector3) -> tuple[float, float]:
    """Return the picture coordinates (x, y) of the point ``v`` in 3D space."""
    return v.x - TOWARD[0] * v.z, v.y - TOWARD[1] * v.z


def on_the_ground(x: float, y: float) -> tuple[float, float]:
    """Return x and z of the point on the ground (y = 0) that appears at (x, y) in the picture."""
    z = -y / TOWARD[1]
    return x + TOWARD[0] * z, z


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
