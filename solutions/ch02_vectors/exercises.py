"""Functions that solve the exercises of the book's chapter 2, and our own exercise B2.11.

None of these functions changes its arguments. Angles are in radians.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3

# What is left of a unit vector counts as zero if it is shorter than this.
_SHORTEST = 1e-6


def split(v: Vector3) -> tuple[float, Vector3]:
    """Split a vector into its magnitude and its direction.

    The direction is a new unit vector. For the zero vector, which has no direction, return 0 and a
    new zero vector. Exercise 2.1.

    >>> magnitude, direction = split(Vector3(2, -2, -2))
    >>> round(magnitude, 6), [round(component, 6) for component in direction]
    (3.464102, [0.57735, -0.57735, -0.57735])
    """
    return v.magnitude(), v.normalized()


def scalar_product_and_angle(a: Vector3, b: Vector3) -> tuple[float, str]:
    """Compute the scalar product a . b, and say whether the angle is acute, right or obtuse.

    An acute angle between ``a`` and ``b`` is smaller than a right angle, and an obtuse angle is
    larger. You do not have to compute the angle, because the sign of the scalar product already
    tells you which kind it is. The numbers in the example differ from the book's.

    Return both as a pair. The word "right" is only for a scalar product of exactly 0.

    Exercise 2.2a.

    >>> scalar_product_and_angle(Vector3(1, 2, 3), Vector3(4, -5, 1))
    (-3.0, 'obtuse')
    """
    product = a.dot(b)
    if product > 0.0:
        return product, "acute"
    return product, "obtuse" if product < 0.0 else "right"


def make_perpendicular(a: Vector3, x: float, y: float) -> float:
    """Find the component z that makes the vector (x, y, z) perpendicular to ``a``.

    Two vectors are perpendicular if their scalar product is zero.

    Raises:
        ValueError: if ``a.z`` is zero, because then no choice of z changes the scalar product.

    Exercise 2.4.

    >>> make_perpendicular(Vector3(1, 2, 3), 7, -2)
    -1.0
    """
    if a.z == 0.0:
        raise ValueError(f"a.z must not be zero, got {a!r}")
    return -(a.x * x + a.y * y) / a.z


def angle_by_scalar_product(a: Vector3, b: Vector3) -> float:
    """Compute the angle between two vectors from their scalar product.

    The result is in radians, between 0 and pi, or NaN if a component is NaN. Rounding can give a
    cosine slightly above 1 or below -1, so limit it to this range before you call ``math.acos``.

    Raises:
        ValueError: if ``a`` or ``b`` is zero, because a zero vector has no direction.

    Exercise 2.5.

    >>> round(angle_by_scalar_product(Vector3(0, 1, 1), Vector3(0, -1, 0)), 6)  # 135 degrees
    2.356194
    """
    if a.magnitude() == 0.0 or b.magnitude() == 0.0:
        raise ValueError(f"a and b must not be zero, got {a!r} and {b!r}")
    cosine = a.normalized().dot(b.normalized())
    return math.acos(max(min(cosine, 1.0), -1.0))  # rounding may put it just outside -1..1


def angles_by_vector_product(a: Vector3, b: Vector3) -> tuple[float, float]:
    """Compute the two possible angles between two vectors from the length of their vector product.

    The length |a x b| depends on the sine of the angle. Two angles that add up to pi have the same
    sine, so the length alone cannot distinguish them. Return both angles in radians, the smaller
    one first. Rounding can give a sine slightly above 1, so limit it to 1. If a component is NaN,
    both angles are NaN.

    Raises:
        ValueError: if ``a`` or ``b`` is zero, because a zero vector has no direction.

    Exercise 2.5.

    >>> angles = angles_by_vector_product(Vector3(0, 1, 1), Vector3(0, -1, 0))
    >>> [round(angle, 6) for angle in angles]  # 45 and 135 degrees
    [0.785398, 2.356194]
    """
    if a.magnitude() == 0.0 or b.magnitude() == 0.0:
        raise ValueError(f"a and b must not be zero, got {a!r} and {b!r}")
    sine = a.normalized().cross(b.normalized()).magnitude()
    smaller = math.asin(min(sine, 1.0))  # rounding may put it just above 1
    return smaller, math.pi - smaller


def remove_projection(a: Vector3, b: Vector3) -> tuple[float, Vector3, float]:
    """Compute c = a . b, the vector d = b - c a, and the angle between ``a`` and d.

    Both ``a`` and ``b`` are unit vectors, and the angle is in radians. Return c, d and the angle.
    The lesson asks what this does to ``b``. The numbers in the example differ from the book's.

    Raises:
        ValueError: if d is shorter than 1e-6. Then ``a`` and ``b`` are parallel, and d is only a
            rounding error without a direction.

    Exercise 2.6.

    >>> c, d, angle = remove_projection(Vector3(1, 0, 0), Vector3(0.6, 0.8, 0))
    >>> c, d, round(angle, 6)
    (0.6, Vector3(0.0, 0.8, 0.0), 1.570796)
    """
    c = a.dot(b)
    d = b - a * c
    if d.magnitude() < _SHORTEST:
        raise ValueError(f"a and b must not be parallel, got {a!r} and {b!r}")
    return c, d, math.acos(a.dot(d) / d.magnitude())


def checked_duration(duration: float) -> float:
    """Check the duration of a time step, in s, and return it as a float.

    A valid duration is positive and finite. Call this function at the start of a step, before you
    change anything, so that an invalid duration leaves everything unchanged. The error message
    names the argument, says what it must be, and shows the value: ``duration must be positive and
    finite, got -1.5``.

    Raises:
        ValueError: for zero, a negative number, an infinity or NaN.
        TypeError: for anything that is not a number, such as None or the text "0.5".

    Exercise B2.11.

    >>> checked_duration(2)
    2.0
    """
    if not isinstance(duration, (int, float)):
        raise TypeError(f"duration must be a number, got {duration!r}")
    # Every comparison with NaN is False, so test for what is allowed and refuse everything else.
    if not 0.0 < duration < math.inf:
        raise ValueError(f"duration must be positive and finite, got {duration!r}")
    return float(duration)


def position_after(position: Vector3, velocity: Vector3, duration: float) -> Vector3:
    """Compute where a body is after it has moved at a constant velocity for some time.

    ``position`` is in m, ``velocity`` in m/s and ``duration`` in s. The result is the new position,
    p' = p + v t, as a new vector. The start position in the example differs from the book's.

    Exercise 2.7, Eq. 2.7.

    >>> position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
    Vector3(13.0, -5.0, 16.0)
    """
    return position + velocity * positive("duration", duration)
