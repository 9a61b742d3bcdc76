"""Exercises of the book's chapter 2, and our own B2.11. None of these changes its arguments.

A zero vector has no direction, so its angles are a ValueError. The angles of NaN are NaN.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3

# What is left of a unit vector counts as zero if it is shorter than this.
_SHORTEST = 1e-6


def split(v: Vector3) -> tuple[float, Vector3]:
    """Split ``v`` into its magnitude and its direction: a unit vector, or zero for zero (2.1)."""
    return v.magnitude(), v.normalized()


def scalar_product_and_angle(a: Vector3, b: Vector3) -> tuple[float, str]:
    """Compute a . b, and say whether the angle is acute, right or obtuse (exercise 2.2a).

    The sign of the scalar product tells you which. "right" is only for exactly 0.
    """
    product = a.dot(b)
    if product > 0.0:
        return product, "acute"
    return product, "obtuse" if product < 0.0 else "right"


def make_perpendicular(a: Vector3, x: float, y: float) -> float:
    """Find the z that makes the vector (x, y, z) perpendicular to ``a`` (exercise 2.4).

    Raises ValueError if ``a.z`` is zero, because then z changes nothing.
    """
    if a.z == 0.0:
        raise ValueError(f"a.z must not be zero, got {a!r}")
    return -(a.x * x + a.y * y) / a.z


def angle_by_scalar_product(a: Vector3, b: Vector3) -> float:
    """Compute the angle from the scalar product, in radians between 0 and pi (exercise 2.5).

    Rounding can give a cosine slightly above 1 or below -1, so limit it to this range before you
    call ``math.acos``.
    """
    if a.magnitude() == 0.0 or b.magnitude() == 0.0:
        raise ValueError(f"a and b must not be zero, got {a!r} and {b!r}")
    cosine = a.normalized().dot(b.normalized())
    return math.acos(max(min(cosine, 1.0), -1.0))  # rounding may put it just outside -1..1


def angles_by_vector_product(a: Vector3, b: Vector3) -> tuple[float, float]:
    """Compute the two possible angles from the length of the vector product (exercise 2.5).

    Two angles that add up to pi have the same sine. Return both in radians, the smaller one first.
    Rounding can give a sine slightly above 1, so limit it to 1.
    """
    if a.magnitude() == 0.0 or b.magnitude() == 0.0:
        raise ValueError(f"a and b must not be zero, got {a!r} and {b!r}")
    sine = a.normalized().cross(b.normalized()).magnitude()
    smaller = math.asin(min(sine, 1.0))  # rounding may put it just above 1
    return smaller, math.pi - smaller


def remove_projection(a: Vector3, b: Vector3) -> tuple[float, Vector3, float]:
    """Compute c = a . b, the vector d = b - c a, and the angle between ``a`` and d (2.6).

    Both ``a`` and ``b`` are unit vectors. Return c, d and the angle. Raises ValueError if d is
    shorter than 1e-6, because then it is only a rounding error without a direction.
    """
    c = a.dot(b)
    d = b - a * c
    if d.magnitude() < _SHORTEST:
        raise ValueError(f"a and b must not be parallel, got {a!r} and {b!r}")
    return c, d, math.acos(a.dot(d) / d.magnitude())


def checked_duration(duration: float) -> float:
    """Return the duration of a time step as a float, if it is positive and finite (B2.11).

    Raises ValueError for zero, a negative number, an infinity or NaN, and TypeError for anything
    that is not a number. The message names the argument, says what it must be, and shows the value:
    ``duration must be positive and finite, got -1.5``.
    """
    if not isinstance(duration, (int, float)):
        raise TypeError(f"duration must be a number, got {duration!r}")
    # Every comparison with NaN is False, so test for what is allowed and refuse everything else.
    if not 0.0 < duration < math.inf:
        raise ValueError(f"duration must be positive and finite, got {duration!r}")
    return float(duration)


def position_after(position: Vector3, velocity: Vector3, duration: float) -> Vector3:
    """Compute p' = p + v t, the position after a motion at constant velocity (exercise 2.7)."""
    return position + velocity * positive("duration", duration)
