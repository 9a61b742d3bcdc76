"""The exercises of the book's chapter 9, as functions of their data."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from ch02_vectors.arguments import finite, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import Point, center_of_mass, rotate_point, wrap_angle
from ch09_rotations.quaternion import Quaternion

Stone = tuple[str, float, float, float]  # what it is, its mass in kg, x and y in m

_X, _Y, _Z = Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1.0)
_OVER = 1e-9  # m


def two_other_turns() -> tuple[float, float]:
    # Two turns are the same where they take X and Y to the same: of quarter turns, exactly.
    wanted = [_quarter_turned(_quarter_turned(axis, _X, 1), _Y, 1) for axis in (_X, _Y)]
    for a, b in product((-1, 0, 1, 2), repeat=2):
        if wanted == [_quarter_turned(_quarter_turned(axis, _Z, a), _X, b) for axis in (_X, _Y)]:
            return 90.0 * a, 90.0 * b
    raise AssertionError("no two quarter turns do it")


def back_to_reference(orientation: Quaternion) -> tuple[Vector3, float]:
    _must_be(Quaternion, orientation)
    axis, angle = orientation.to_axis_angle()
    return axis, -angle


def product_without_j_and_k(a: Quaternion, b: Quaternion) -> Quaternion:
    for q in (a, b):
        _must_be(Quaternion, q)
        if q.j != 0.0 or q.k != 0.0:
            raise ValueError(f"j and k must be zero, got {q!r}")
    number = complex(a.r, a.i) * complex(b.r, b.i)
    return Quaternion(number.real, number.imag)


def turned_by_sense(orientation: Quaternion, rate: float, duration: float) -> Quaternion:
    _must_be(Quaternion, orientation)
    turned = orientation.copy()
    turned.rotate_by(_X * (finite("rate", rate) * positive("duration", duration)))
    return turned


def turned_by_steps(
    orientation: Quaternion, rate: float, duration: float, steps: int = 1
) -> tuple[Quaternion, float]:
    _must_be(Quaternion, orientation)
    if not orientation.is_unit():
        raise ValueError(f"the orientation must have the length 1, got {orientation!r}")
    spin = Vector3(finite("rate", rate), 0.0, 0.0)
    step = positive("duration", duration) / whole("steps", steps)
    turned = orientation.copy()
    for _ in range(steps):
        turned.add_scaled(spin, step)
        turned.normalize()  # each time, or else long turns grow out of the floats
    _, lacking = first_order_drift(rate, duration, steps)
    return turned, abs(wrap_angle(lacking))


def read_off(matrix: Matrix4) -> tuple[Matrix3, Vector3]:
    _must_be(Matrix4, matrix)
    origin = matrix.transform(Vector3())
    columns = [part for axis in (_X, _Y, _Z) for part in matrix.transform(axis) - origin]
    rotation = Matrix3(*columns).transpose()
    if not rotation.is_rotation():
        raise ValueError(f"the matrix does more than turn and move: {matrix!r}")
    return rotation, origin


def easy_inverse(matrix: Matrix4) -> Matrix4:
    _must_be(Matrix4, matrix)
    moved = matrix.transform_inverse(Vector3())  # where the origin comes from
    entries: list[float] = []
    for row, last in enumerate(moved):
        entries += [matrix[column, row] for column in range(3)]
        entries.append(last)
    return Matrix4(*entries)


def center_of_stones(stones: Sequence[Stone]) -> Point:
    masses, positions = [], []
    for _, mass, x, y in stones:
        masses.append(mass)
        positions.append((x, y))
    return center_of_mass(masses, positions)


def balance_offset(stones: Sequence[Stone], angle: float) -> float:
    return _to_the_left(center_of_stones(stones), angle)


def masses_beside(stones: Sequence[Stone], angle: float) -> tuple[float, float]:
    edge = balance_offset(stones, angle)
    sides = {True: 0.0, False: 0.0}
    for _, mass, x, y in stones:
        beside = _to_the_left((x, y), angle) - edge
        if abs(beside) > _OVER:
            sides[beside > 0.0] += mass
    return sides[True], sides[False]


def _to_the_left(point: Point, angle: float) -> float:
    """Return how far a point is to the left of a line through the corner: turn it back, read y."""
    return rotate_point(point, -finite("angle", angle), (0.0, 0.0))[1]


def _quarter_turned(v: Vector3, axis: Vector3, quarters: int) -> Vector3:
    """Return a vector turned by so many quarters: each leaves the part along the axis alone."""
    for _ in range(quarters % 4):
        v = axis * axis.dot(v) + axis.cross(v)
    return v


def _must_be(kind: type, thing: object) -> None:
    if not isinstance(thing, kind):
        raise TypeError(f"a {kind.__name__} is wanted, got {thing!r}")
