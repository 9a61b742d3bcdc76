"""Exercises of the book's chapter 2, and our own B2.11. None of these changes its arguments.

A zero vector has no direction, so its angles are a ValueError. The angles of NaN are NaN.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3


def split(v: Vector3) -> tuple[float, Vector3]:
    """Split ``v`` into its magnitude and its direction: a unit vector, or zero for zero (2.1)."""
    raise NotImplementedError("Exercise 2.1: Magnitude and direction")


def scalar_product_and_angle(a: Vector3, b: Vector3) -> tuple[float, str]:
    """Compute a . b, and say whether the angle is acute, right or obtuse (exercise 2.2a).

    The sign of the scalar product tells you which. "right" is only for exactly 0.
    """
    raise NotImplementedError("Exercise 2.2a: A scalar product and what its sign says")


def make_perpendicular(a: Vector3, x: float, y: float) -> float:
    """Find the z that makes the vector (x, y, z) perpendicular to ``a`` (exercise 2.4).

    Raises ValueError if ``a.z`` is zero, because then z changes nothing.
    """
    raise NotImplementedError("Exercise 2.4: The component that makes two vectors perpendicular")


def angle_by_scalar_product(a: Vector3, b: Vector3) -> float:
    """Compute the angle from the scalar product, in radians between 0 and pi (exercise 2.5).

    Rounding can give a cosine slightly above 1 or below -1, so limit it to this range before you
    call ``math.acos``.
    """
    raise NotImplementedError("Exercise 2.5: The angle between two vectors, in two ways")


def angles_by_vector_product(a: Vector3, b: Vector3) -> tuple[float, float]:
    """Compute the two possible angles from the length of the vector product (exercise 2.5).

    Two angles that add up to pi have the same sine. Return both in radians, the smaller one first.
    Rounding can give a sine slightly above 1, so limit it to 1.
    """
    raise NotImplementedError("Exercise 2.5: The angle between two vectors, in two ways")


def remove_projection(a: Vector3, b: Vector3) -> tuple[float, Vector3, float]:
    """Compute c = a . b, the vector d = b - c a, and the angle between ``a`` and d (2.6).

    Both ``a`` and ``b`` are unit vectors. Return c, d and the angle. Raises ValueError if d is
    shorter than 1e-6, because then it is only a rounding error without a direction.
    """
    raise NotImplementedError("Exercise 2.6: The rest of a vector after a projection")


def checked_duration(duration: float) -> float:
    """Return the duration of a time step as a float, if it is positive and finite (B2.11).

    Raises ValueError for zero, a negative number, an infinity or NaN, and TypeError for anything
    that is not a number. The message names the argument, says what it must be, and shows the value:
    ``duration must be positive and finite, got -1.5``.
    """
    raise NotImplementedError("Exercise B2.11: Refuse bad arguments")


def position_after(position: Vector3, velocity: Vector3, duration: float) -> Vector3:
    """Compute p' = p + v t, the position after a motion at constant velocity (exercise 2.7)."""
    raise NotImplementedError("Exercise 2.7: A position that changes with a velocity")
