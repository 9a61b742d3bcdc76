"""Functions that solve the exercises of the book's chapter 9.

The functions do not change their arguments. Angles are in radians unless a docstring says degrees.
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

    Rotate an object by 90 degrees about X and then by 90 degrees about Y. The result is the same if
    you rotate the object by an angle ``a`` about Z and then by an angle ``b`` about X. Return the
    tuple (``a``, ``b``), with both angles in degrees, from -180 to 180. The axes are those of the
    world, so they do not rotate with the object, and rotations are right-handed.
    """
    return -90.0, 90.0


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    """Exercise 9.2: find the rotation that takes an orientation back to the reference (1, 0, 0, 0).

    The result is an axis, which is a new unit vector in world axes, and an angle in radians, from
    -pi to pi. You may also return the opposite axis with the opposite angle, which is the same
    rotation. If the orientation is already the reference, the angle is 0 and the axis may be any
    unit vector.

    >>> axis, angle = back_to_reference(Quaternion(0.5, 0.5, 0.5, 0.5))
    >>> round(angle, 6), [round(component, 6) for component in axis]  # 120 degrees
    (2.094395, [-0.57735, -0.57735, -0.57735])
    """
    instance_of("orientation", orientation, Quaternion)
    return orientation.conjugate().to_axis_angle()


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    """Exercise 9.3a: multiply quaternions whose j and k are zero, with only four multiplications.

    The result is a * b, as a new quaternion. The general product needs sixteen multiplications.

    >>> product_without_j_and_k(Quaternion(2, 3, 0, 0), Quaternion(4, -1, 0, 0))
    Quaternion(11.0, 10.0, 0.0, 0.0)
    """
    instance_of("a", a, Quaternion)
    instance_of("b", b, Quaternion)
    return Quaternion(a.r * b.r - a.i * b.i, a.r * b.i + a.i * b.r)


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    """Exercise 9.4: rotate an orientation at a constant rate about the world's X axis.

    The axis never changes, so you can compute the result with a single rotation. ``rate`` is in
    rad/s and may be negative, and ``duration`` is in s. The result is a new quaternion.
    """
    instance_of("orientation", orientation, Quaternion)
    angle = finite("rate", rate) * positive("duration", duration)
    return Quaternion.from_axis_angle(Vector3(1.0, 0.0, 0.0), angle) * orientation


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    """Exercise 9.4: approximate the rotation of ``turned_by_sense`` with time steps of Eq. 9.5.

    Divide ``duration`` into ``steps`` equal steps, and normalize only after the last one. Return
    the final orientation as a new quaternion, and its error. The error is the angle in radians,
    from 0 to pi, between this orientation and the result of ``turned_by_sense``.

    >>> q, error = turned_by_steps(Quaternion(0.5, 0.5, 0.5, 0.5), 0.5, 2.0)
    >>> [round(component, 6) for component in q], round(error, 6)  # 4.2 degrees
    ([0.223607, 0.67082, 0.223607, 0.67082], 0.072705)
    """
    right = turned_by_sense(orientation, rate, duration)
    spin = Vector3(rate, 0.0, 0.0)
    turned = orientation.copy()
    for _ in range(whole("steps", steps)):
        turned.add_scaled(spin, duration / steps)
    turned.normalize()
    return turned, (right * turned.conjugate()).to_axis_angle()[1]


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    """Exercise 9.5: split a 3x4 matrix into the rotation and the position that it contains.

    The rotation consists of the first three columns, and the position is the fourth. Both results
    are new objects.

    >>> read_off(Matrix4(0, -1, 0, 4, 1, 0, 0, 5, 0, 0, 1, 6))
    (Matrix3(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0), Vector3(4.0, 5.0, 6.0))
    """
    a, b, c, x, d, e, f, y, g, h, i, z = instance_of("matrix", matrix, Matrix4)
    return Matrix3(a, b, c, d, e, f, g, h, i), Vector3(x, y, z)


def easy_inverse(matrix: Matrix4) -> Matrix4:
    """Exercise 9.6: invert a matrix that rotates and then translates, without any division.

    The inverse of a rotation is its transpose, so transpose the 3x3 part. Then multiply the
    translation by this transpose and negate it. The result is a new matrix, which is wrong if the
    3x3 part is not a rotation. Do not check for this, because the check would take most of the time
    that the shortcut saves.
    """
    a, b, c, x, d, e, f, y, g, h, i, z = instance_of("matrix", matrix, Matrix4)
    return Matrix4(
        *(a, d, g, -(a * x + d * y + g * z)),
        *(b, e, h, -(b * x + e * y + h * z)),
        *(c, f, i, -(c * x + f * y + i * z)),
    )


def center_of_stones(stones: Sequence[Stone]) -> Point:
    """Exercise 9.7: compute the center of mass (x, y) of a box with stones in it, in m.

    Each stone is a tuple of its name, its mass in kg, and the x and y of its center in m. The box
    has a mass too, so include it as one of the stones unless its mass is negligible.
    """
    masses = [mass for _, mass, _, _ in stones]
    return center_of_mass(masses, [(x, y) for _, _, x, y in stones])


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    """Exercise 9.7: compute where to put a straight edge so that a box of stones balances on it.

    The box balances if the edge passes directly below its center of mass. ``angle`` is the
    direction of the edge in radians, so the edge is parallel to the vector (cos(angle),
    sin(angle)).

    The result is the offset of the edge: its distance in m from the corner of the box at x = y = 0.
    Look along the edge in its direction. The offset is positive if the edge passes to the left of
    the corner. Left is the direction (-sin(angle), cos(angle)).
    """
    x, y = center_of_stones(stones)
    along = angle_to_vector(angle)
    return along[0] * y - along[1] * x


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    """Exercise 9.7: compute the total mass on each side of the balancing edge, in kg.

    The box balances on this edge, whose position is computed by ``balance_offset``. The result is a
    tuple of the masses on the left and on the right.

    The book says that these two masses are equal (erratum E-32). However, they can differ, because
    a small mass far from the edge balances a large mass near it.

    A stone belongs to the side on which its center lies. If its center is within 1e-9 m of the
    edge, the stone belongs to neither side.
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
