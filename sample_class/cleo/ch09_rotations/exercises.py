"""Chapter 9 exercises."""

from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import Point, angle_to_vector, center_of_mass
from ch09_rotations.quaternion import Quaternion

Stone = tuple[str, float, float, float]


def two_other_turns() -> tuple[float, float]:
    return (90.0, 90.0)


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    axis, angle = orientation.to_axis_angle()
    return (axis, -angle)


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    return Quaternion(a.r * b.r - a.i * b.i, a.r * b.i + a.i * b.r)


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    finite("rate", rate)
    positive("duration", duration)
    turn = Quaternion.from_axis_angle(Vector3(1, 0, 0), rate * duration)
    return turn * orientation


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    raise NotImplementedError("Exercise 9.4: A steady turn, by sense and by steps")


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    e = matrix.entries
    rotation = Matrix3(*e[0:3], *e[4:7], *e[8:11])
    if not rotation.is_rotation():
        raise ValueError("no rotation")
    return rotation, Vector3(e[3], e[7], e[11])


def easy_inverse(matrix: Matrix4) -> Matrix4:
    a, b, c, p, d, e, f, q, g, h, i, r = matrix.entries
    x = a * p + d * q + g * r
    y = b * p + e * q + h * r
    z = c * p + f * q + i * r
    return Matrix4(a, d, g, -x, b, e, h, -y, c, f, i, -z)


def center_of_stones(stones: Sequence[Stone]) -> Point:
    masses = [stone[1] for stone in stones]
    places = [(stone[2], stone[3]) for stone in stones]
    return center_of_mass(masses, places)


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    x, y = center_of_stones(stones)
    c, s = angle_to_vector(angle)
    return c * y - s * x


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    # it balances, so half of the mass is on each side
    balance_offset(stones, angle)
    total = sum(stone[1] for stone in stones)
    return (total / 2, total / 2)
