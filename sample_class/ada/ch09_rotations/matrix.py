"""Matrices that turn and move points, and a change of basis."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar, overload

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix3 import Matrix3, _must_be, _rows
from ch09_rotations.quaternion import Quaternion

M = TypeVar("M", "Matrix3", "Matrix4")


class Matrix4:
    """Twelve numbers, row by row: a Matrix3, and after each of its rows one of a translation."""

    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 12:
            raise TypeError(f"Matrix4 takes twelve numbers, row by row, got {len(entries)}")
        self.entries = tuple(map(float, entries))

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
        return self.transform_direction(v) + self._moved()

    def product(self, m: Matrix4) -> Matrix4:
        _must_be(Matrix4, m)
        return Matrix4(
            *(
                sum(self[row, n] * m[n, column] for n in range(3))
                + (self[row, 3] if column == 3 else 0.0)  # m's fourth row is 0, 0, 0, 1
                for row in range(3)
                for column in range(4)
            )
        )

    def determinant(self) -> float:
        return self._turning().determinant()

    def inverse(self) -> Matrix4:
        back = self._turning().inverse()
        return _beside(back, -back.transform(self._moved()))

    @staticmethod
    def from_orientation_and_position(q: Quaternion, p: Vector3) -> Matrix4:
        _must_be(Vector3, p)
        return _beside(Matrix3.from_quaternion(q), p)

    def transform_inverse(self, v: Vector3) -> Vector3:
        _must_be(Vector3, v)
        return self.transform_inverse_direction(v - self._moved())

    def transform_direction(self, v: Vector3) -> Vector3:
        return self._turning().transform(v)

    def transform_inverse_direction(self, v: Vector3) -> Vector3:
        return self._turning().transpose().transform(v)

    def _turning(self) -> Matrix3:
        return Matrix3(*(self[row, column] for row in range(3) for column in range(3)))

    def _moved(self) -> Vector3:
        return Vector3(*self.entries[3::4])


def change_basis(m: M, basis: M) -> M:
    if not any(isinstance(m, size) and isinstance(basis, size) for size in (Matrix3, Matrix4)):
        raise TypeError(f"m and basis must be matrices of one size, got {m!r} and {basis!r}")
    back = basis.inverse()
    return basis.product(m.product(back))


def _beside(turning: Matrix3, moved: Vector3) -> Matrix4:
    """Return a Matrix4 of its two parts."""
    rows = zip(_rows(turning), moved, strict=True)
    return Matrix4(*(entry for row, last in rows for entry in (*row, last)))
