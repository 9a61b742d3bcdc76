"""The exercises of the book's chapter 9, as functions of their data.

None of them changes what it is given. Angles are in radians, except where degrees are named. Raises
TypeError for what is no number, no Vector3, no Quaternion or no Matrix4 where one is wanted.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import Point
from ch09_rotations.quaternion import Quaternion

Stone = tuple[str, float, float, float]  # what it is, its mass in kg, x and y in m


def two_other_turns() -> tuple[float, float]:
    """Exercise 9.1: return the angles a and b, in degrees, from -180 to 180.

    Turning an object by 90 degrees about X and then by 90 degrees about Y leaves it as turning it
    by a about Z and then by b about X does. The axes are the world's, and do not turn with it;
    turns are right-handed.
    """
    raise NotImplementedError("Exercise 9.1: Two turns, and two others")


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    """Exercise 9.2: return the one turn, axis and angle, that takes an orientation to (1, 0, 0, 0).

    The axis is a new unit vector in axes of the world, the angle in radians, from -pi to pi: the
    same turn about the opposite axis has the opposite sign, and either will do. Where there is
    nothing to turn back the angle is 0, about any axis.

    >>> axis, angle = back_to_reference(Quaternion(0.5, 0.5, 0.5, 0.5))
    >>> round(angle, 6), [round(component, 6) for component in axis]  # 120 degrees
    (2.094395, [-0.57735, -0.57735, -0.57735])

    Raises ValueError where the length is not 1 (Quaternion.is_unit).
    """
    raise NotImplementedError("Exercise 9.2: One turn back to the reference")


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    """Exercise 9.3a: return a b, where j and k are zero in both, in four multiplications.

    The numbers of the example are ours.

    >>> product_without_j_and_k(Quaternion(2, 3, 0, 0), Quaternion(4, -1, 0, 0))
    Quaternion(11.0, 10.0, 0.0, 0.0)

    Raises ValueError where a j or a k is not zero.
    """
    raise NotImplementedError("Exercise 9.3a: Two quaternions without j and k")


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    """Exercise 9.4: return where a steady turn about the world's X ends, as new: by one rotation.

    rate in rad/s, negative the other way round; duration in s.

    Raises ValueError where the rate is not finite or the duration not positive and finite.
    """
    raise NotImplementedError("Exercise 9.4: A steady turn, by sense and by steps")


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    """Exercise 9.4: return the same by equal steps of Eq. 9.5, normalised, and its error.

    The error is the angle, from 0 to pi, of the turn that would take the result to what
    turned_by_sense returns. The rate of the example is ours.

    >>> q, error = turned_by_steps(Quaternion(0.5, 0.5, 0.5, 0.5), 0.5, 2.0)
    >>> [round(component, 6) for component in q], round(error, 6)  # 4.2 degrees
    ([0.223607, 0.67082, 0.223607, 0.67082], 0.072705)

    Raises ValueError where the orientation's length is not 1 (Quaternion.is_unit), the rate is not
    finite, the duration not positive and finite, or steps not 1 or more; TypeError where steps is
    no whole number.
    """
    raise NotImplementedError("Exercise 9.4: A steady turn, by sense and by steps")


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    """Exercise 9.5: return the rotation and the position that a 3x4 matrix is made of, as new.

    The numbers of the example are ours.

    >>> read_off(Matrix4(0, -1, 0, 4, 1, 0, 0, 5, 0, 0, 1, 6))
    (Matrix3(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0), Vector3(4.0, 5.0, 6.0))

    Raises ValueError where what should be the rotation is none (Matrix3.is_rotation).
    """
    raise NotImplementedError("Exercise 9.5: Rotation and position, read off")


def easy_inverse(matrix: Matrix4) -> Matrix4:
    """Exercise 9.6: return the inverse of a rotation and a translation, without any division.

    The rotation is turned back by its transpose, and the translation with it. For other matrices
    that is no inverse, and it does not look: that would take most of what it saves.
    """
    raise NotImplementedError("Exercise 9.6: The inverse, the easy way")


def center_of_stones(stones: Sequence[Stone]) -> Point:
    """Exercise 9.7: return the centre of mass of a box with stones, in m, by sums.

    A stone is a tuple of what it is, its mass in kg, and where its middle is, x and y in m. The box
    itself is one of them, unless it has no mass to speak of.

    Raises what center_of_mass raises.
    """
    raise NotImplementedError("Exercise 9.7: A box with stones")


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    """Exercise 9.7: return where a straight edge must lie below the box for it to balance, in m.

    The edge has the direction of an angle, (cos, sin). The offset is how far to the left of it, in
    the direction (-sin, cos), the edge lies from the corner of the box where x and y are 0.

    Raises what center_of_stones raises, and ValueError where the angle is not finite.
    """
    raise NotImplementedError("Exercise 9.7: A box with stones")


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    """Exercise 9.7: return the masses on the left and on the right of that edge, in kg.

    Where they differ, it balances all the same, since a small mass far away weighs up a large one
    near by: the book has them equal (E-32). Each stone counts where its middle is; one whose middle
    is over the edge, within 1e-9 m, counts on neither side.

    Raises what balance_offset raises.
    """
    raise NotImplementedError("Exercise 9.7: A box with stones")
