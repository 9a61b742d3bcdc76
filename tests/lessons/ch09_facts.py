"""Compute the numbers of chapter 9's lesson with the reference."""

from __future__ import annotations

import math
import operator

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, velocity_of_point
from ch09_rotations.euler import euler_rates, euler_to_quaternion
from ch09_rotations.exercises import (
    back_to_reference,
    product_without_j_and_k,
    turned_by_sense,
    turned_by_steps,
)
from ch09_rotations.matrix import Matrix4
from ch09_rotations.matrix3 import Matrix3
from ch09_rotations.plane import center_of_mass, rotate_point, wrap_angle
from ch09_rotations.quaternion import Quaternion


def turn_about(axis: Vector3, degrees: float) -> Quaternion:
    return Quaternion.from_axis_angle(axis, math.radians(degrees))


QUARTER = Quaternion.from_axis_angle(Vector3(0, 0, 1), math.pi / 2)


def flat() -> dict[str, float]:
    assert center_of_mass([1, 3], [(0, 0), (4, 0)]) == (3, 0)
    x, y = rotate_point((2, 1), math.pi / 2, (10, 5))
    return {"3.142": math.pi, "6.283": math.tau, "2.283": wrap_angle(4), "9": x, "7": y}


def same_orientation(p: Quaternion, q: Quaternion) -> bool:
    return abs(abs(p.r * q.r + p.i * q.i + p.j * q.j + p.k * q.k) - 1) < 1e-15


def locked() -> dict[str, float]:
    x, y, z = (math.radians(angle) for angle in (20, 90, 50))
    both = euler_to_quaternion(x, y, z)
    assert same_orientation(both, euler_to_quaternion(0, y, z - x))
    assert same_orientation(
        both, turn_about(Vector3(0, 0, 1), math.degrees(z - x)) * turn_about(Vector3(0, 1), 90)
    )
    return {"30": math.degrees(z - x)}


def order() -> dict[str, float]:
    rotated = Matrix3(0, -1, 0, 1, 0, 0, 0, 0, 1).transform(Vector3(2, 3, 5))
    assert rotated == Vector3(-3, 2, 5)
    assert Matrix3(1, 0, 0, 0, 1, 0, 0, 0, -1).determinant() == -1
    return {}


def stretched() -> float:
    """Return the length of the worst column after 1,000 cheap steps of a matrix at 1 rad/s."""
    columns = [Vector3(1), Vector3(0, 1), Vector3(0, 0, 1)]
    for _ in range(1000):
        for column in columns:
            column.add_scaled(Vector3(0, 0, 1).cross(column), 1 / 60)
    return max(column.magnitude() for column in columns)


def quaternions() -> dict[str, float]:
    small = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(1, 2, 3), 0.1))
    turned = Matrix3(1, 0, 0, 0, 1, 0, 0, 0, 1)
    for _ in range(1000):
        turned = small.product(turned)
    square = turned.product(turned.transpose())
    assert max(abs(square[i, j] - (i == j)) for i in range(3) for j in range(3)) < 1e-13
    twice = QUARTER * QUARTER
    assert abs(twice.k - 1) < 1e-15
    return {"0.707": QUARTER.k, "0.5": QUARTER.k**2, "45": math.degrees(math.acos(QUARTER.r))} | {
        "15": 100 * (stretched() - 1)
    }


def propeller() -> dict[str, float]:
    step = Quaternion()
    step.add_scaled(Vector3(0, 0, math.tau), 1 / 15)
    _, missing = first_order_drift(math.tau, 1, 15)
    return {
        "6.283": math.tau,
        "0.4189": math.tau / 15,
        "0.4129": 2 * math.atan2(step.k, step.r),
        "0.09": missing,
        "5.1": math.degrees(missing),
        "0.2094": step.k,
        "1.0217": step.magnitude(),
    }


def from_axis_and_angle(v: Vector3, axis: Vector3, angle: float) -> Vector3:
    """Rotate a vector by the lesson's form of Eq. 9.3."""
    c, s = math.cos(angle), math.sin(angle)
    return v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c))


def directly() -> dict[str, float]:
    """Compare Eq. 9.3 with the way through a quaternion."""
    units = Vector3(1), Vector3(0, 1), Vector3(0, 0, 1)
    for direction, angle in ((Vector3(1, 2, 2), 1.2), (Vector3(-3, 1, 7), -2.9)):
        axis = direction.normalized()
        matrix = Matrix3.from_quaternion(Quaternion.from_axis_angle(direction, angle))
        for unit in units:
            off = from_axis_and_angle(unit, axis, angle) - matrix.transform(unit)
            assert off.magnitude() < 1e-14  # some rounding errors of numbers up to 1
    axis, angle = Vector3(1, 1, 1).normalized(), math.radians(120)
    third = Matrix3.from_quaternion(Quaternion(0.5, 0.5, 0.5, 0.5))
    assert third.transform(Vector3(1)) == Vector3(0, 1)
    assert (from_axis_and_angle(Vector3(1), axis, angle) - Vector3(0, 1)).magnitude() < 1e-15
    terms = (
        Vector3(math.cos(angle)),
        axis.cross(Vector3(1)) * math.sin(angle),
        axis * (axis.x * (1 - math.cos(angle))),
    )
    for term, told in zip(terms, ((-0.5, 0, 0), (0, 0.5, -0.5), (0.5, 0.5, 0.5)), strict=True):
        assert (term - Vector3(*told)).magnitude() < 1e-15
    return {"0.5": -math.cos(angle)}


def tank() -> dict[str, float]:
    placed = Matrix4.from_orientation_and_position(QUARTER, Vector3(10, 0, 5))
    muzzle = placed.transform(Vector3(3, 0, 1))
    assert (placed.transform_inverse(muzzle) - Vector3(3, 0, 1)).magnitude() < 1e-12
    assert [*placed] == pytest.approx([0, -1, 0, 10, 1, 0, 0, 0, 0, 0, 1, 5], abs=1e-15)
    turn, move = (
        Matrix4(0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0),
        Matrix4(1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 5),
    )
    moved_first = turn.product(move).transform(Vector3(3, 0, 1))
    assert move.product(turn).transform(Vector3(3, 0, 1)) == Vector3(10, 3, 6)
    assert moved_first.x == 0
    rows = times(transposed(square(turn)), transposed(square(move)))
    assert times([[3, 0, 1, 1]], rows) == [[10, 3, 6, 1]]
    assert times([[1, 0, 0, 0]], rows) == [[0, 1, 0, 0]]
    assert rows == transposed(square(move.product(turn)))
    return {"10": muzzle.x, "6": muzzle.z, "13": moved_first.y}


def square(matrix: Matrix4) -> list[list[float]]:
    """Return all sixteen entries of a matrix, row by row."""
    entries = [*matrix]
    return [entries[:4], entries[4:8], entries[8:], [0, 0, 0, 1]]


def transposed(rows: list[list[float]]) -> list[list[float]]:
    return [list(column) for column in zip(*rows, strict=True)]


def times(a: list[list[float]], b: list[list[float]]) -> list[list[float]]:
    columns = transposed(b)
    return [[sum(map(operator.mul, row, column)) for column in columns] for row in a]


def lock() -> dict[str, float]:
    def largest(degrees: float) -> float:
        return euler_rates(0, math.radians(degrees), 0, Vector3(1, 0, 0)).x

    assert abs(largest(60) - 2) < 1e-12
    return {"57": largest(89), "573": largest(89.9)}


def spins() -> dict[str, float]:
    moving = velocity_of_point(Vector3(2), Vector3(), Vector3(), Vector3(0, 0, 3))
    return {"6": moving.y}


def with_a_ball() -> None:
    """Check the answers on exercises 9.1 and 9.2."""
    x, y, z = Vector3(1), Vector3(0, 1), Vector3(0, 0, 1)
    fixed, own = turn_about(y, 90) * turn_about(x, 90), turn_about(x, 90) * turn_about(y, 90)
    assert same_orientation(fixed, Quaternion(0.5, 0.5, 0.5, -0.5))
    assert same_orientation(own, Quaternion(0.5, 0.5, 0.5, 0.5))
    assert same_orientation(own, turn_about(z, 90) * turn_about(x, 90))
    for mark, now in ((x, -z), (y, x), (z, -y), (Vector3(1, 2, 3), Vector3(2, -3, -1))):
        assert (fixed.rotate(mark) - now).magnitude() < 1e-14
    axis, angle = back_to_reference(fixed)
    assert (axis - Vector3(-1, -1, 1).normalized()).magnitude() < 1e-14
    assert abs(math.degrees(angle) - 120) < 1e-12


def by_algebra() -> dict[str, float]:
    """Check the answer on exercise 9.4, with x = 0.5."""
    start, x = Quaternion(0.1, 0.2, 0.3, 0.4), 0.5
    stepped = start.copy()
    stepped.add_scaled(Vector3(0.5), 2)
    expected = (0.1 - x * 0.2, 0.2 + x * 0.1, 0.3 - x * 0.4, 0.4 + x * 0.3)
    assert [*stepped] == pytest.approx(expected, abs=1e-15)
    half = Quaternion(0.5, 0.5, 0.5, 0.5)
    by_steps, _ = turned_by_steps(half, 0.5, 2)
    exact = turned_by_sense(half, 0.5, 2)
    half.add_scaled(Vector3(0.5), 2)
    assert [*half] == [0.25, 0.75, 0.25, 0.75]
    assert [*by_steps][2:] == pytest.approx([*by_steps][:2])
    assert [*exact][2:] == pytest.approx([*exact][:2])
    return {
        "0.25": half.r,
        "0.75": half.i,
        "0.224": by_steps.r,
        "0.671": by_steps.i,
        "0.199": exact.r,
        "0.679": exact.i,
    }


def exercises() -> dict[str, float]:
    with_a_ball()
    _, angle = back_to_reference(Quaternion(0.5, 0.5, 0.5, 0.5))
    product = product_without_j_and_k(Quaternion(2, 3), Quaternion(4, -1))
    return {
        "120": math.degrees(angle),
        "11": product.r,
        "10": product.i,
        "12": 3 * 4,
    } | by_algebra()


SECTIONS = {
    "Flat first: one angle": ("5 10 20 90", flat),
    "In space, the order matters": ("90", dict),
    "Euler angles, and where they fail": ("20 50 90", locked),
    "Matrices": ("5 90", order),
    "Quaternions": ("60 90 180 1e-13", quaternions),
    "Spinning: a rotation step": ("15", propeller),
    "From quaternions to matrices and back": ("120", directly),
    "How fast Euler angles must change": ("45 60 89 89.9 90", lock),
    "Objects in the world": ("5 90", tank),
    "A step for a spinning body": ("", spins),
    "The book's exercises": ("0.5 90", exercises),
}
