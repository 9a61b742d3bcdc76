"""Functions that solve the exercises of the book's chapter 9.

The functions do not change their arguments. Angles are in radians.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import finite, instance_of, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import Point, angle_to_vector, center_of_mass
from ch09_rotations.quaternion import Quaternion

Stone = tuple[str, float, float, float]  # what it is, its mass in kg, x and y in m

# A stone within this distance of the balance edge lies on it, in m.
_ON_THE_LINE = 1e-9


def two_other_turns() -> tuple[float, float]:
    """Exercise 9.1: find two rotations that have the same effect as two others.

    Rotate an object by 90 degrees about the world's X and then Y. The result is the same if you
    rotate the object by a about Z, then by b about X. Return (a, b) in degrees, from -180 to 180.
    """
    return -90.0, 90.0


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    """Exercise 9.2: find the rotation that takes an orientation back to the reference (1, 0, 0, 0).

    The result is a new unit vector, the axis in world axes, and an angle from -pi to pi. For the
    reference itself the angle is 0 and the axis may be any unit vector.
    """
    instance_of("orientation", orientation, Quaternion)
    return orientation.conjugate().to_axis_angle()


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    """Exercise 9.3a: multiply quaternions whose j and k are zero, with only four multiplications.

    >>> product_without_j_and_k(Quaternion(2, 3, 0, 0), Quaternion(4, -1, 0, 0))
    Quaternion(11.0, 10.0, 0.0, 0.0)
    """
    instance_of("a", a, Quaternion)
    instance_of("b", b, Quaternion)
    return Quaternion(a.r * b.r - a.i * b.i, a.r * b.i + a.i * b.r)


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    """Exercise 9.4: rotate an orientation at a constant rate about the world's X axis.

    ``rate`` is in rad/s and may be negative, and ``duration`` is in s. Return a new quaternion.
    """
    instance_of("orientation", orientation, Quaternion)
    angle = finite("rate", rate) * positive("duration", duration)
    return Quaternion.from_axis_angle(Vector3(1.0, 0.0, 0.0), angle) * orientation


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    """Exercise 9.4: approximate the rotation of ``turned_by_sense`` with time steps of Eq. 9.5.

    Make ``steps`` equal steps, and normalize only after the last one. Return the final orientation,
    and the angle in radians, from 0 to pi, between it and the result of ``turned_by_sense``.
    """
    right = turned_by_sense(orientation, rate, duration)
    spin = Vector3(rate, 0.0, 0.0)
    turned = orientation.copy()
    for _ in range(whole("steps", steps)):
        turned.add_scaled(spin, duration / steps)
    turned.normalize()
    return turned, (right * turned.conjugate()).to_axis_angle()[1]


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    """Exercise 9.5: split a matrix into rotation, the first three columns, and position."""
    instance_of("matrix", matrix, Matrix4)
    rotation = Matrix3(*(matrix[row, column] for row in range(3) for column in range(3)))
    return rotation, Vector3(matrix[0, 3], matrix[1, 3], matrix[2, 3])


def easy_inverse(matrix: Matrix4) -> Matrix4:
    """Exercise 9.6: invert a matrix that rotates and then translates, without any division.

    The inverse of a rotation is its transpose, so transpose the 3x3 part. Then multiply the
    translation by this transpose and negate it. Return a new matrix, which is wrong if the 3x3 part
    is not a rotation. Do not check for this.
    """
    rotation, position = read_off(matrix)
    back = rotation.transpose()
    x, y, z = -back.transform(position)
    rows = back.entries[:3], back.entries[3:6], back.entries[6:]
    return Matrix4(*rows[0], x, *rows[1], y, *rows[2], z)


def center_of_stones(stones: Sequence[Stone]) -> Point:
    """Exercise 9.7: compute the center of mass (x, y) of a box with stones in it, in m."""
    masses = [mass for _, mass, _, _ in stones]
    return center_of_mass(masses, [(x, y) for _, _, x, y in stones])


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    """Exercise 9.7: compute where to put a straight edge so that a box of stones balances on it.

    The edge passes directly below the center of mass, parallel to (cos(angle), sin(angle)). The
    result is its distance in m from the corner at x = y = 0. The offset is positive if the edge
    passes to the left of the corner, which is in the direction (-sin(angle), cos(angle)).
    """
    x, y = center_of_stones(stones)
    along = angle_to_vector(angle)
    return along[0] * y - along[1] * x


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    """Exercise 9.7: compute the total mass on each side of the balancing edge, in kg.

    The result is (left, right). The book says that these masses are equal (erratum E-32). However,
    they can differ. A stone belongs to the side on which its center lies. If its center is within
    1e-9 m of the edge, the stone belongs to neither side.
    """
    offset = balance_offset(stones, angle)
    cosine, sine = angle_to_vector(angle)
    left = right = 0.0
    for _, mass, x, y in stones:
        side = cosine * y - sine * x - offset
        if side > _ON_THE_LINE:
            left += mass
        elif side < -_ON_THE_LINE:
            right += mass
    return left, right
