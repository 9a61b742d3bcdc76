"""Angles, directions and points in the plane, and the center of mass (book 9.1).

Points are tuples (x, y). Angles are in radians, counter-clockwise from the X axis.
"""

from __future__ import annotations

from collections.abc import Sequence

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Convert an angle to the equivalent angle in the range -pi < angle <= pi (9.1.1).

    The angles pi and -pi are the same direction too, and both give pi. An angle may contain many
    turns, so remove them all at once and not one by one.
    """
    raise NotImplementedError("Exercise B9.1: Wrapping an angle")


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle as the unit vector (cos(angle), sin(angle)) (Eq. 9.1)."""
    raise NotImplementedError("Exercise B9.2: Directions and points in the plane")


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Convert a point from the coordinates of an object to world coordinates (Eq. 9.2).

    ``angle`` is the object's orientation, and ``origin`` its position. Rotate ``point`` first and
    then add ``origin``.
    """
    raise NotImplementedError("Exercise B9.2: Directions and points in the plane")


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Compute the center of mass of several bodies: their mean position, weighted by their masses.

    Both may be lists or tuples, and several masses may be equal. Book 9.1.3.
    """
    raise NotImplementedError("Exercise B9.3: The center of mass")
