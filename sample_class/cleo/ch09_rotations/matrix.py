"""Matrices."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar, overload

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix3 import Matrix3
from ch09_rotations.quaternion import Quaternion

M = TypeVar("M", "Matrix3", "Matrix4")


class Matrix4:
    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 12:
            raise TypeError(f"Matrix4 takes twelve numbers, row by row, got {len(entries)}")
        self.entries = tuple(float(entry) for entry in entries)

    def __repr__(self) -> str:
        return f"Matrix4({', '.join(map(repr, self.entries))})"

    def __iter__(self) -> Iterator[float]:
        return iter(self.entries)

    def __eq__(self, other: object) -> bool:
        return self.entries == other.entries if isinstance(other, Matrix4) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        row, column = place
        if row not in range(3) or column not in range(4):
            raise IndexError(f"row must be from 0 to 2 and column from 0 to 3, got {place!r}")
        return self.entries[4 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix4) -> Matrix4: ...
    def __matmul__(self, other: Vector3 | Matrix4) -> Vector3 | Matrix4:
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix4) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        a, b, c, p, d, e, f, q, g, h, i, r = self.entries
        return Vector3(
            a * v.x + b * v.y + c * v.z + p,
            d * v.x + e * v.y + f * v.z + q,
            g * v.x + h * v.y + i * v.z + r,
        )

    def product(self, m: Matrix4) -> Matrix4:
        n = []
        for row in range(3):
            for column in range(4):
                n.append(sum(self[row, k] * m[k, column] for k in range(3)))
            n[-1] += self[row, 3]
        return Matrix4(*n)

    def determinant(self) -> float:
        d = self.entries
        return (
            d[8] * d[5] * d[2]
            + d[4] * d[9] * d[2]
            + d[8] * d[1] * d[6]
            - d[0] * d[9] * d[6]
            - d[4] * d[1] * d[10]
            + d[0] * d[5] * d[10]
        )

    def inverse(self) -> Matrix4:
        m = _linear(self).inverse()
        t = _translation(self)
        return _joined(m, m.transform(-t))

    @staticmethod
    def from_orientation_and_position(q: Quaternion, p: Vector3) -> Matrix4:
        return _joined(Matrix3.from_quaternion(q), p)

    def transform_inverse(self, v: Vector3) -> Vector3:
        back = _linear(self).transpose()
        return back.transform(v) - _translation(self)

    def transform_direction(self, v: Vector3) -> Vector3:
        return _linear(self).transform(v)

    def transform_inverse_direction(self, v: Vector3) -> Vector3:
        return _linear(self).transpose().transform(v)


def change_basis(m: M, basis: M) -> M:
    raise NotImplementedError("Exercise B9.16: A change of basis")


def _linear(m: Matrix4) -> Matrix3:
    e = m.entries
    return Matrix3(*e[0:3], *e[4:7], *e[8:11])


def _translation(m: Matrix4) -> Vector3:
    return Vector3(m[0, 3], m[1, 3], m[2, 3])


def _joined(linear: Matrix3, translation: Vector3) -> Matrix4:
    e = linear.entries
    return Matrix4(*e[0:3], translation.x, *e[3:6], translation.y, *e[6:9], translation.z)
