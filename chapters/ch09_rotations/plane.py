"""Angles, directions and points in the plane, and the centre of mass (book 9.1).

A point or direction is a tuple (x, y). Angles are in radians and counter-clockwise, from the X axis
towards the Y axis. None of these functions changes what it is given.
"""

from __future__ import annotations

from collections.abc import Sequence

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Return the same direction's angle above -pi and up to pi (9.1.1).

    An angle and one that is turned on by 2 pi point the same way; this picks one of them. Half a
    turn is pi, whether it came as pi or as -pi.

    Raises ValueError where the angle is not finite, TypeError where it is no number.
    """
    raise NotImplementedError("Exercise B9.1: An angle and its whole turns")


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle, a vector of length 1 (Eq. 9.1).

    Raises ValueError where the angle is not finite, TypeError where it is no number.
    """
    raise NotImplementedError("Exercise B9.2: A direction, and a point of an object, in the plane")


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Return where a point of an object is in the world (Eq. 9.2).

    ``point`` is where the object has it, before it was turned and moved; ``angle`` is the object's
    orientation and ``origin`` its position, both in the world: turn first, then move.

    >>> x, y = rotate_point((1.5, -0.75), 3 * math.pi / 8, (4, 3.85))  # a headlight of a car
    >>> round(x, 2), round(y, 2)
    (5.27, 4.95)

    Raises ValueError where a number is not finite, TypeError where one is no number.
    """
    raise NotImplementedError("Exercise B9.2: A direction, and a point of an object, in the plane")


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Return the mean of the positions, each counted by its mass (9.1.3).

    Masses in kg, positions in m, one for each mass and in the same order.

    Raises ValueError where there is no mass, where masses and positions are not as many, where a
    mass is not positive or a number not finite; TypeError where one is no number.
    """
    raise NotImplementedError("Exercise B9.3: The centre of mass")
