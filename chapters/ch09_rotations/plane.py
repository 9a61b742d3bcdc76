"""Angles, directions and points in the plane, and the center of mass (book 9.1).

A point or direction is a tuple (x, y). Angles are in radians, counter-clockwise from the X axis
toward the Y axis. The functions do not change their arguments.
"""

from __future__ import annotations

from collections.abc import Sequence

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Convert an angle to the equivalent angle in the range -pi < angle <= pi (9.1.1).

    Angles that differ by a full turn point in the same direction, so wrap them before you compare
    them. The angles pi and -pi are the same direction too, and both give pi. An angle may contain
    hundreds of thousands of turns, so remove them all at once and not one by one.
    """
    raise NotImplementedError("Exercise B9.1: Wrapping an angle")


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle as the unit vector (cos(angle), sin(angle)) (Eq. 9.1)."""
    raise NotImplementedError("Exercise B9.2: Directions and points in the plane")


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Convert a point from the coordinates of an object to world coordinates (Eq. 9.2).

    ``point`` is given relative to the object, for example the headlight of a car. ``angle`` is the
    object's orientation in the world, and ``origin`` is its position. Rotate ``point`` first and
    then add ``origin``, because in the other order the position would rotate too.

    >>> x, y = rotate_point((1.5, -0.75), 3 * math.pi / 8, (4, 3.85))  # a headlight of a car
    >>> round(x, 2), round(y, 2)
    (5.27, 4.95)
    """
    raise NotImplementedError("Exercise B9.2: Directions and points in the plane")


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Compute the center of mass of several bodies: their mean position, weighted by their masses.

    ``masses`` are in kg. ``positions`` are in m, in the same order as the masses. Both may be
    lists or tuples, and several masses may be equal. Book: section 9.1.3.
    """
    raise NotImplementedError("Exercise B9.3: The center of mass")
