"""Angles, directions and points in the plane, and the centre of mass (book 9.1).

A point or direction is a tuple (x, y). Angles are in radians and counter-clockwise, from the X axis
towards the Y axis. None of these functions changes what it is given.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    """Return the same direction's angle above -pi and up to pi (9.1.1).

    An angle and one that is turned on by 2 pi point the same way; this picks one of them. Half a
    turn is pi, whether it came as pi or as -pi.

    Raises ValueError where the angle is not finite, TypeError where it is no number.
    """
    wrapped = math.remainder(finite("angle", angle), math.tau)
    return wrapped if wrapped > -math.pi else math.pi


def angle_to_vector(angle: float) -> Point:
    """Return the direction of an angle, a vector of length 1 (Eq. 9.1).

    Raises ValueError where the angle is not finite, TypeError where it is no number.
    """
    finite("angle", angle)
    return math.cos(angle), math.sin(angle)


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    """Return where a point of an object is in the world (Eq. 9.2).

    ``point`` is where the object has it, before it was turned and moved; ``angle`` is the object's
    orientation and ``origin`` its position, both in the world: turn first, then move.

    >>> x, y = rotate_point((1.5, -0.75), 3 * math.pi / 8, (4, 3.85))  # a headlight of a car
    >>> round(x, 2), round(y, 2)
    (5.27, 4.95)

    Raises ValueError where a number is not finite, TypeError where one is no number.
    """
    x, y = finite("point[0]", point[0]), finite("point[1]", point[1])
    across, up = finite("origin[0]", origin[0]), finite("origin[1]", origin[1])
    cosine, sine = angle_to_vector(angle)
    return across + cosine * x - sine * y, up + sine * x + cosine * y


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    """Return the mean of the positions, each counted by its mass (9.1.3).

    Masses in kg, positions in m, one for each mass and in the same order.

    Raises ValueError where there is no mass, where masses and positions are not as many, where a
    mass is not positive or a number not finite; TypeError where one is no number.
    """
    if not masses or len(masses) != len(positions):
        raise ValueError(
            "masses and positions must be as many, and one at least: "
            f"got {len(masses)} masses and {len(positions)} positions"
        )
    total = math.fsum(positive("masses", mass) for mass in masses)
    shares = [mass / total for mass in masses]
    x = math.fsum(s * finite("positions", p[0]) for s, p in zip(shares, positions, strict=True))
    y = math.fsum(s * finite("positions", p[1]) for s, p in zip(shares, positions, strict=True))
    return x, y
