"""Angles, directions and points in the plane, and the center of mass (book 9.1).

A point or direction is a tuple (x, y). Angles are in radians, counter-clockwise from the X axis
toward the Y axis. The functions do not change their arguments.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Convert an angle to the equivalent angle in the range -pi < angle <= pi (9.1.1).

    Angles that differ by a full turn point in the same direction, so wrap them before you compare
    them. The angles pi and -pi are the same direction too, and both give pi. An angle may contain
    hundreds of thousands of turns, so remove them all at once and not one by one.
    """
    wrapped = math.remainder(finite("angle", angle), math.tau)
    return wrapped if wrapped > -math.pi else math.pi


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle as the unit vector (cos(angle), sin(angle)) (Eq. 9.1)."""
    finite("angle", angle)
    return math.cos(angle), math.sin(angle)


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Convert a point from the coordinates of an object to world coordinates (Eq. 9.2).

    ``point`` is given relative to the object, for example the headlight of a car. ``angle`` is the
    object's orientation in the world, and ``origin`` is its position. Rotate ``point`` first and
    then add ``origin``, because in the other order the position would rotate too.

    >>> x, y = rotate_point((1.5, -0.75), 3 * math.pi / 8, (4, 3.85))  # a headlight of a car
    >>> round(x, 2), round(y, 2)
    (5.27, 4.95)
    """
    x, y = finite("point[0]", point[0]), finite("point[1]", point[1])
    across, up = finite("origin[0]", origin[0]), finite("origin[1]", origin[1])
    cosine, sine = angle_to_vector(angle)
    return across + cosine * x - sine * y, up + sine * x + cosine * y


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Compute the center of mass of several bodies: their mean position, weighted by their masses.

    ``masses`` are in kg. ``positions`` are in m, in the same order as the masses. Both may be
    lists or tuples, and several masses may be equal. Book: section 9.1.3.
    """
    total = math.fsum(positive("masses", mass) for mass in masses)
    shares = [mass / total for mass in masses]
    x = math.fsum(s * finite("positions", p[0]) for s, p in zip(shares, positions, strict=True))
    y = math.fsum(s * finite("positions", p[1]) for s, p in zip(shares, positions, strict=True))
    return x, y
