"""Matrices of three rows and columns, which turn and scale."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import permutations
from typing import overload

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

SINGULAR = 1e-13
ROTATION_TOLERANCE = 1e-5
_AXES = (Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1.0))


class Matrix3:
    """Nine numbers, row by row: what turns and scales, and leaves the origin where it is."""

    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 9:
            raise TypeError(f"Matrix3 takes nine numbers, row by row, got {len(entries)}")
        self.entries = tuple(map(float, entries))

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
        _must_be(Vector3, v)
        column = [*v]
        return Vector3(*(sum(self[row, n] * column[n] for n in range(3)) for row in range(3)))

    def product(self, m: Matrix3) -> Matrix3:
        _must_be(Matrix3, m)
        return Matrix3(
            *(
                sum(self[row, n] * m[n, column] for n in range(3))
                for row in range(3)
                for column in range(3)
            )
        )

    def transpose(self) -> Matrix3:
        return Matrix3(*(self[row, column] for column in range(3) for row in range(3)))

    def determinant(self) -> float:
        total = 0.0
        for a, b, c in permutations(range(3)):
            sign = (b - a) * (c - a) * (c - b) // 2
            total += sign * self[0, a] * self[1, b] * self[2, c]
        return total

    def inverse(self) -> Matrix3:
        rows = _rows(self)
        lengths = [math.hypot(*row) for row in rows]
        largest = math.prod(lengths)
        # Divided by its length, each row is of length 1, or zero.
        rows = [[part / (lengths[n] or 1.0) for part in row] for n, row in enumerate(rows)]
        share = Matrix3(*rows[0], *rows[1], *rows[2]).determinant()
        if not abs(share * largest) > SINGULAR * largest:
            determinant, limit = self.determinant(), SINGULAR * largest
            raise ValueError(
                f"no inverse: the determinant {determinant!r} is not above {limit!r} in size"
            )
        for n, row in enumerate(rows):
            row += [float(n == column) / lengths[n] for column in range(3)]
        for n in range(3):
            sizes = [abs(row[n]) for row in rows[n:]]
            pivot = n + sizes.index(max(sizes))
            rows[n], rows[pivot] = rows[pivot], rows[n]
            rows[n] = [part / rows[n][n] for part in rows[n]]
            for other in {0, 1, 2} - {n}:
                factor = rows[other][n]
                rows[other] = [a - factor * b for a, b in zip(rows[other], rows[n], strict=True)]
        return Matrix3(*(part for row in rows for part in row[3:]))

    def is_rotation(self) -> bool:
        rows = _rows(self)
        for n, first in enumerate(rows):
            for m, second in enumerate(rows):
                product = sum(a * b for a, b in zip(first, second, strict=True))
                if not abs(product - (n == m)) <= ROTATION_TOLERANCE:
                    return False
        return self.determinant() > 0.0

    @staticmethod
    def from_quaternion(q: Quaternion) -> Matrix3:
        _must_be(Quaternion, q)
        turned = [part for axis in _AXES for part in q.rotate(axis)]
        return Matrix3(*turned).transpose()

    def to_quaternion(self) -> Quaternion:
        if not self.is_rotation():
            raise ValueError(f"only a rotation has a quaternion, got {self!r}")
        (a, b, c), (d, e, f), (g, h, i) = _rows(self)
        if a + e + i > 0.0:
            q = Quaternion(1.0 + a + e + i, h - f, c - g, d - b)
        elif a >= e and a >= i:
            q = Quaternion(h - f, 1.0 + a - e - i, b + d, c + g)
        elif e >= i:
            q = Quaternion(c - g, b + d, 1.0 - a + e - i, f + h)
        else:
            q = Quaternion(d - b, c + g, f + h, 1.0 - a - e + i)
        q.normalize()
        return q


def _rows(m: Matrix3) -> list[list[float]]:
    return [[m[row, column] for column in range(3)] for row in range(3)]


def _must_be(kind: type, thing: object) -> None:
    if not isinstance(thing, kind):
        raise TypeError(f"a {kind.__name__} is wanted, got {thing!r}")
