"""Functions that solve the exercises of the book's chapter 2, and our own exercise B2.11.

None of these functions changes its arguments. Angles are in radians.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3


def split(v: Vector3) -> tuple[float, Vector3]:
    """Split a vector into its magnitude and its direction.

    The direction is a new unit vector. For the zero vector, which has no direction, return 0 and a
    new zero vector. Exercise 2.1.

    >>> magnitude, direction = split(Vector3(2, -2, -2))
    >>> round(magnitude, 6), [round(component, 6) for component in direction]
    (3.464102, [0.57735, -0.57735, -0.57735])
    """
    raise NotImplementedError("Exercise 2.1: Magnitude and direction")


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
    raise NotImplementedError("Exercise 2.2a: A scalar product and what its sign says")


def make_perpendicular(a: Vector3, x: float, y: float) -> float:
    """Find the component z that makes the vector (x, y, z) perpendicular to ``a``.

    Two vectors are perpendicular if their scalar product is zero.

    Raises:
        ValueError: if ``a.z`` is zero, because then no choice of z changes the scalar product.

    Exercise 2.4.

    >>> make_perpendicular(Vector3(1, 2, 3), 7, -2)
    -1.0
    """
    raise NotImplementedError("Exercise 2.4: The component that makes two vectors perpendicular")


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
    raise NotImplementedError("Exercise 2.5: The angle between two vectors, in two ways")


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
    raise NotImplementedError("Exercise 2.5: The angle between two vectors, in two ways")


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
    raise NotImplementedError("Exercise 2.6: The rest of a vector after a projection")


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
    raise NotImplementedError("Exercise B2.11: Refuse bad arguments")


def position_after(position: Vector3, velocity: Vector3, duration: float) -> Vector3:
    """Compute where a body is after it has moved at a constant velocity for some time.

    ``position`` is in m, ``velocity`` in m/s and ``duration`` in s. The result is the new position,
    p' = p + v t, as a new vector. The start position in the example differs from the book's.

    Exercise 2.7, Eq. 2.7.

    >>> position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
    Vector3(13.0, -5.0, 16.0)
    """
    raise NotImplementedError("Exercise 2.7: A position that changes with a velocity")
