"""Functions that solve the exercises of the book's chapter 9.

The functions do not change their arguments. Angles are in radians.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import Point
from ch09_rotations.quaternion import Quaternion

Stone = tuple[str, float, float, float]  # what it is, its mass in kg, x and y in m


def two_other_turns() -> tuple[float, float]:
    """Exercise 9.1: find two rotations that have the same effect as two others.

    Rotate an object by 90 degrees about the world's X and then Y. The result is the same if you
    rotate the object by a about Z, then by b about X. Return (a, b) in degrees, from -180 to 180.
    """
    raise NotImplementedError("Exercise 9.1: Two rotations, and two others")


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    """Exercise 9.2: find the rotation that takes an orientation back to the reference (1, 0, 0, 0).

    The result is a new unit vector, the axis in world axes, and an angle from -pi to pi. For the
    reference itself the angle is 0 and the axis may be any unit vector.
    """
    raise NotImplementedError("Exercise 9.2: One rotation back to the reference")


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    """Exercise 9.3a: multiply quaternions whose j and k are zero, with only four multiplications.

    >>> product_without_j_and_k(Quaternion(2, 3, 0, 0), Quaternion(4, -1, 0, 0))
    Quaternion(11.0, 10.0, 0.0, 0.0)
    """
    raise NotImplementedError("Exercise 9.3a: Two quaternions without j and k")


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    """Exercise 9.4: rotate an orientation at a constant rate about the world's X axis.

    ``rate`` is in rad/s and may be negative, and ``duration`` is in s. Return a new quaternion.
    """
    raise NotImplementedError("Exercise 9.4: A steady rotation, at once and in steps")


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    """Exercise 9.4: approximate the rotation of ``turned_by_sense`` with time steps of Eq. 9.5.

    Make ``steps`` equal steps, and normalize only after the last one. Return the final orientation,
    and the angle in radians, from 0 to pi, between it and the result of ``turned_by_sense``.
    """
    raise NotImplementedError("Exercise 9.4: A steady rotation, at once and in steps")


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    """Exercise 9.5: split a matrix into rotation, the first three columns, and position."""
    raise NotImplementedError("Exercise 9.5: Reading off rotation and position")


def easy_inverse(matrix: Matrix4) -> Matrix4:
    """Exercise 9.6: invert a matrix that rotates and then translates, without any division.

    The inverse of a rotation is its transpose, so transpose the 3x3 part. Then multiply the
    translation by this transpose and negate it. Return a new matrix, which is wrong if the 3x3 part
    is not a rotation. Do not check for this.
    """
    raise NotImplementedError("Exercise 9.6: The inverse, the easy way")


def center_of_stones(stones: Sequence[Stone]) -> Point:
    """Exercise 9.7: compute the center of mass (x, y) of a box with stones in it, in m."""
    raise NotImplementedError("Exercise 9.7: A box with stones")


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    """Exercise 9.7: compute where to put a straight edge so that a box of stones balances on it.

    The edge passes directly below the center of mass, parallel to (cos(angle), sin(angle)). The
    result is its distance in m from the corner at x = y = 0. The offset is positive if the edge
    passes to the left of the corner, which is in the direction (-sin(angle), cos(angle)).
    """
    raise NotImplementedError("Exercise 9.7: A box with stones")


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    """Exercise 9.7: compute the total mass on each side of the balancing edge, in kg.

    The result is (left, right). The book says that these masses are equal (erratum E-32). However,
    they can differ. A stone belongs to the side on which its center lies. If its center is within
    1e-9 m of the edge, the stone belongs to neither side.
    """
    raise NotImplementedError("Exercise 9.7: A box with stones")
