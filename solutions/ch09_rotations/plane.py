"""Angles, directions and points in the plane, and the center of mass (book 9.1).

Points are tuples (x, y). Angles are in radians, counter-clockwise from the X axis.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Convert an angle to the equivalent angle in the range -pi < angle <= pi (9.1.1).

    The angles pi and -pi are the same direction too, and both give pi. An angle may contain many
    turns, so remove them all at once and not one by one.
    """
    wrapped = math.remainder(finite("angle", angle), math.tau)
    return wrapped if wrapped > -math.pi else math.pi


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle as the unit vector (cos(angle), sin(angle)) (Eq. 9.1)."""
    finite("angle", angle)
    return math.cos(angle), math.sin(angle)


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Convert a point from the coordinates of an object to world coordinates (Eq. 9.2).

    ``angle`` is the object's orientation, and ``origin`` its position. Rotate ``point`` first and
    then add ``origin``.
    """
    x, y = finite("point[0]", point[0]), finite("point[1]", point[1])
    across, up = finite("origin[0]", origin[0]), finite("origin[1]", origin[1])
    cosine, sine = angle_to_vector(angle)
    return across + cosine * x - sine * y, up + sine * x + cosine * y


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Compute the center of mass of several bodies: their mean position, weighted by their masses.

    Both may be lists or tuples, and several masses may be equal. Book 9.1.3.
    """
    total = math.fsum(positive("masses", mass) for mass in masses)
    shares = [mass / total for mass in masses]
    x = math.fsum(s * finite("positions", p[0]) for s, p in zip(shares, positions, strict=True))
    y = math.fsum(s * finite("positions", p[1]) for s, p in zip(shares, positions, strict=True))
    return x, y
