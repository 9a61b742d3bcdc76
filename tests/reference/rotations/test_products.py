"""Quaternions and matrices compared with NumPy and SciPy, on 2,000 random cases each.

SciPy has the scalar of a quaternion last, so its (x, y, z, w) is our (r, i, j, k).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion

Array = numpy.ndarray
COUNT = 2_000
RANDOM = numpy.random.default_rng(9)

VECTORS, POINTS, MOVES = (RANDOM.normal(size=(COUNT, 3)) for _ in "abc")
ANGLES = RANDOM.uniform(-10.0, 10.0, (COUNT, 3))
# Rotations, half of which are half turns, or miss them by 1e-1 to 1e-15 rad on either side.
MISSING = numpy.resize([0.0, *10.0 ** -numpy.arange(1.0, 16.0)], COUNT // 2)
TURNS = VECTORS / numpy.linalg.norm(VECTORS, axis=1)[:, None]
TURNS *= numpy.concatenate([math.pi - MISSING, RANDOM.uniform(0.0, math.pi, COUNT // 2)])[:, None]
THEIRS, OTHERS = Rotation.from_rotvec(TURNS), Rotation.random(COUNT, random_state=9)


def ours(kind: Callable[..., Any], rows: Array) -> list[Any]:
    return [kind(*map(float, row)) for row in rows.reshape(COUNT, -1)]


def quaternions(rotations: Rotation) -> Array:
    return numpy.roll(rotations.as_quat(), 1, axis=1)


V, P, M = (ours(Vector3, rows) for rows in (VECTORS, POINTS, MOVES))
Q, R = (ours(Quaternion, quaternions(rotations)) for rotations in (THEIRS, OTHERS))

# Matrices, and 4x4 matrices with the last row that the book leaves out. The condition of all of
# them is below 20, because an inverse cannot be more accurate than a rounding times the condition.
DRAWN = RANDOM.normal(size=(2 * COUNT, 3, 3))
LINEAR = DRAWN[numpy.linalg.cond(DRAWN) < 20.0][:COUNT]
OTHER = LINEAR[::-1]
LAST = numpy.tile([0.0, 0.0, 0.0, 1.0], (COUNT, 1, 1))
AFFINE = numpy.concatenate([LINEAR, MOVES[:, :, None]], axis=2)
FULL = numpy.concatenate([AFFINE, LAST], axis=1)
M3, N3, M4 = ours(Matrix3, LINEAR), ours(Matrix3, OTHER), ours(Matrix4, AFFINE)


def each(call: Callable[..., Any], *arguments: Iterable[Any]) -> list[Any]:
    return [call(*row) for row in zip(*arguments, strict=True)]


def turned(method: str, *arguments: Iterable[Any]) -> list[Quaternion]:
    """Return copies of the quaternions after a method has changed them."""
    found = [q.copy() for q in Q]
    each(lambda q, *rest: getattr(q, method)(*rest), found, *arguments)
    return found


def rotation_vectors(found: list[tuple[Vector3, float]]) -> list[Vector3]:
    assert all(0.0 <= angle <= math.pi for _, angle in found)
    return [axis * angle for axis, angle in found]


def unsigned(quaternions: Iterable[Iterable[float]]) -> Array:
    """Return the matrices of rotations, which q and -q have in common, from SciPy."""
    rows = numpy.array([tuple(q) for q in quaternions])
    assert numpy.abs(numpy.linalg.norm(rows, axis=1) - 1.0).max() < 1e-15
    return Rotation.from_quat(numpy.roll(rows, -1, axis=1)).as_matrix()


def of_rotation_vectors(rows: Array) -> Array:
    """Return the matrices of rotations. Half a turn about v is also one about -v."""
    return Rotation.from_rotvec(rows).as_matrix()


COMPARED: dict[str, Callable[[], tuple[Any, Array]]] = {
    "product of quaternions": lambda: (
        each(Quaternion.__mul__, Q, R),
        quaternions(THEIRS * OTHERS),
    ),
    "conjugate": lambda: (unsigned(each(Quaternion.conjugate, Q)), THEIRS.inv().as_matrix()),
    "rotate": lambda: (each(Quaternion.rotate, Q, P), THEIRS.apply(POINTS)),
    # The sign is that of half the angle, which SciPy's is not.
    "from_axis_angle": lambda: (
        each(Quaternion.from_axis_angle, V, ANGLES[:, 0].tolist()),
        numpy.column_stack(
            [
                numpy.cos(ANGLES[:, 0] / 2.0),
                TURNS / numpy.linalg.norm(TURNS, axis=1)[:, None] * numpy.sin(ANGLES[:, :1] / 2.0),
            ]
        ),
    ),
    "to_axis_angle": lambda: (
        of_rotation_vectors(rows_of(rotation_vectors(each(Quaternion.to_axis_angle, Q)))),
        THEIRS.as_matrix(),
    ),
    "from_quaternion": lambda: (each(Matrix3.from_quaternion, Q), THEIRS.as_matrix()),
    "to_quaternion": lambda: (
        unsigned(each(Matrix3.to_quaternion, ours(Matrix3, THEIRS.as_matrix()))),
        THEIRS.as_matrix(),
    ),
    # The later rotation is on the left, so it is about axes of the world.
    "rotate_by": lambda: (
        unsigned(turned("rotate_by", P)),
        (Rotation.from_rotvec(POINTS) * THEIRS).as_matrix(),
    ),
    "add_scaled": lambda: (
        turned("add_scaled", V, [2.0] * COUNT),
        quaternions(THEIRS)
        + quaternions(Rotation.from_quat(numpy.pad(VECTORS, [(0, 0), (0, 1)])) * THEIRS)
        * numpy.linalg.norm(VECTORS, axis=1)[:, None],
    ),
    "inverse of a 3x3 matrix": lambda: (each(Matrix3.inverse, M3), numpy.linalg.inv(LINEAR)),
    "inverse of a 4x4 matrix": lambda: (each(Matrix4.inverse, M4), numpy.linalg.inv(FULL)),
    "change_basis": lambda: (
        each(change_basis, N3, M3),
        LINEAR @ OTHER @ numpy.linalg.inv(LINEAR),
    ),
}


def rows_of(found: Any) -> Array:
    """Return results as rows of numbers."""
    return numpy.array([(f,) if isinstance(f, float) else tuple(f) for f in found])


@pytest.mark.parametrize("what", COMPARED)
def test_it_agrees_with_numpy_and_scipy(what: str) -> None:
    found, wanted = COMPARED[what]()
    if wanted.shape[1:] == (4, 4):
        wanted = wanted[:, :3]  # without the last row
    wanted = wanted.reshape(COUNT, -1)
    got = found if isinstance(found, numpy.ndarray) else rows_of(found)
    size = 1.0 + numpy.abs(wanted).max(axis=1)[:, None]
    # Some ten roundings of 1e-16, and those of an inverse times a condition of 20.
    most = 1e-13 if "inverse" in what or "basis" in what else 1e-14
    assert numpy.abs((got.reshape(COUNT, -1) - wanted) / size).max() <= most


@pytest.mark.parametrize(
    "diagonal",
    [
        (1e200, 1e200, 1e200),
        (1e-200, 1e-200, 1e-200),
        (1e200, -1e200, 1e-300),
        (1e-160, 1e-160, 1e160),
    ],
    ids=str,
)
def test_the_inverse_of_tiny_and_huge_numbers_is_right(
    diagonal: tuple[float, float, float],
) -> None:
    """Their determinant may be too large or too small for a float."""
    a, b, c = diagonal
    wanted = [1.0 / number for number in diagonal]
    for m in (Matrix3(a, 0, 0, 0, b, 0, 0, 0, c), Matrix4(a, 0, 0, 0, 0, b, 0, 0, 0, 0, c, 0)):
        inverse = m.inverse()
        got = [inverse[place, place] for place in range(3)]
        assert got == pytest.approx(wanted, rel=1e-15, abs=0.0)


def test_a_tiny_row_beside_nearly_parallel_ones_costs_no_digits() -> None:
    """share * length is below the smallest normal float, but column / share / length is not."""
    first = Matrix3(1e-300, 0, 0, 0, 1, 0, 0, 1, 1e-12).inverse()[0, 0]
    assert first == pytest.approx(1e300, rel=1e-14)
