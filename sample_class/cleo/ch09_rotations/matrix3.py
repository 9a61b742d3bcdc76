"""Matrices of three rows and columns, which turn and scale."""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

# A determinant below this share of the product of the rows' lengths, the largest that rows of such
# lengths can have, is rounding.
SINGULAR = 1e-13
# How far the products of a rotation's rows may be from 1 and 0: a quaternion that just passes for
# one of length 1 makes them 4e-6.
ROTATION_TOLERANCE = 1e-5


class Matrix3:
    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 9:
            raise TypeError(f"Matrix3 takes nine numbers, row by row, got {len(entries)}")
        self.entries = tuple(float(entry) for entry in entries)

    def __repr__(self) -> str:
        return f"Matrix3({', '.join(map(repr, self.entries))})"

    def __iter__(self) -> Iterator[float]:
        return iter(self.entries)

    def __eq__(self, other: object) -> bool:
        return self.entries == other.entries if isinstance(other, Matrix3) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        row, column = place
        if row not in range(3) or column not in range(3):
            raise IndexError(f"row and column must be from 0 to 2, got {place!r}")
        return self.entries[3 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix3) -> Matrix3: ...
    def __matmul__(self, other: Vector3 | Matrix3) -> Vector3 | Matrix3:
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix3) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        if not isinstance(v, Vector3):
            raise TypeError("v is no Vector3")
        a, b, c, d, e, f, g, h, i = self.entries
        return Vector3(
            a * v.x + b * v.y + c * v.z,
            d * v.x + e * v.y + f * v.z,
            g * v.x + h * v.y + i * v.z,
        )

    def product(self, m: Matrix3) -> Matrix3:
        if not isinstance(m, Matrix3):
            raise TypeError("m is no Matrix3")
        n = []
        for row in range(3):
            for column in range(3):
                n.append(sum(self[row, k] * m[k, column] for k in range(3)))
        return Matrix3(*n)

    def transpose(self) -> Matrix3:
        a, b, c, d, e, f, g, h, i = self.entries
        return Matrix3(a, d, g, b, e, h, c, f, i)

    def determinant(self) -> float:
        a, b, c, d, e, f, g, h, i = self.entries
        return a * e * i - a * f * h - b * d * i + b * f * g + c * d * h - c * e * g

    def inverse(self) -> Matrix3:
        a, b, c, d, e, f, g, h, i = self.entries
        det = self.determinant()
        if det == 0.0:
            raise ValueError("determinant is 0")
        return Matrix3(
            (e * i - f * h) / det,
            (c * h - b * i) / det,
            (b * f - c * e) / det,
            (f * g - d * i) / det,
            (a * i - c * g) / det,
            (c * d - a * f) / det,
            (d * h - e * g) / det,
            (b * g - a * h) / det,
            (a * e - b * d) / det,
        )

    def is_rotation(self) -> bool:
        # a rotation keeps the volume
        return abs(self.determinant() - 1) < ROTATION_TOLERANCE

    @staticmethod
    def from_quaternion(q: Quaternion) -> Matrix3:
        r, i, j, k = q
        return Matrix3(
            1 - (2 * j * j + 2 * k * k),
            2 * i * j + 2 * k * r,
            2 * i * k - 2 * j * r,
            2 * i * j - 2 * k * r,
            1 - (2 * i * i + 2 * k * k),
            2 * j * k + 2 * i * r,
            2 * i * k + 2 * j * r,
            2 * j * k - 2 * i * r,
            1 - (2 * i * i + 2 * j * j),
        )

    def to_quaternion(self) -> Quaternion:
        raise NotImplementedError("Exercise B9.13: From a matrix to a quaternion")
