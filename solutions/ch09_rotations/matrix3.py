"""Matrices of three rows and columns, which turn and scale vectors (book 9.2.3, 9.4.1 to 9.4.4).

A vector is a column and stands on the right: ``m @ v``; ``a @ b`` is b first and then a. Matrices
are not changed once they are made: every method returns a new one.

Raises TypeError for what is no Vector3, no Quaternion or no Matrix3 where one is wanted. Of vectors
only the type is looked at: any components will do.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

# A determinant below this share of the product of the rows' lengths, the largest that rows of such
# lengths can have, is rounding.
SINGULAR = 1e-13
# How far the products of a rotation's rows may be from 1 and 0: a quaternion that just passes for
# one of length 1 makes them 8e-6, in a half-turn.
ROTATION_TOLERANCE = 1e-5


class Matrix3:
    """Nine numbers, row by row: what turns and scales, and leaves the origin where it is.

    ``m[row, column]`` reads one, both from 0 to 2; ``entries`` is the tuple of all. They are what
    float() takes. Raises TypeError where there are not nine.
    """

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
        """Exact, number by number."""
        return self.entries == other.entries if isinstance(other, Matrix3) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        """Return the number in a row and column. Raises IndexError where there is none."""
        row, column = place
        if row not in range(3) or column not in range(3):
            raise IndexError(f"row and column must be from 0 to 2, got {place!r}")
        return self.entries[3 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix3) -> Matrix3: ...
    def __matmul__(self, other: Vector3 | Matrix3) -> Vector3 | Matrix3:
        """Return m.transform(v) or m.product(n), by what is on the right."""
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix3) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        """Return m v, as new; also written m @ v (9.4.2)."""
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        x, y, z = v.x, v.y, v.z
        a, b, c, d, e, f, g, h, i = self.entries
        return Vector3(a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)

    def product(self, m: Matrix3) -> Matrix3:
        """Return this matrix times m: m first, then this one; also written @ (9.4.2)."""
        if not isinstance(m, Matrix3):
            raise TypeError(f"m must be a Matrix3, got {m!r}")
        a, b, c, d, e, f, g, h, i = self.entries
        j, k, l, n, o, p, q, r, s = m.entries  # noqa: E741
        return Matrix3(
            *(a * j + b * n + c * q, a * k + b * o + c * r, a * l + b * p + c * s),
            *(d * j + e * n + f * q, d * k + e * o + f * r, d * l + e * p + f * s),
            *(g * j + h * n + i * q, g * k + h * o + i * r, g * l + h * p + i * s),
        )

    def transpose(self) -> Matrix3:
        """Return the matrix whose rows are the columns here: a rotation turned back (9.4.3)."""
        a, b, c, d, e, f, g, h, i = self.entries
        return Matrix3(a, d, g, b, e, h, c, f, i)

    def determinant(self) -> float:
        """Return the volume that a unit cube comes to have, negative where mirrored (9.4.3)."""
        first, second, third = _rows(self)
        return first.dot(second.cross(third))

    def inverse(self) -> Matrix3:
        """Return the matrix that undoes this one (9.4.3).

        Raises ValueError, with the determinant and what it was compared with, where no matrix
        does, or nearly so: where |determinant| is not above SINGULAR, 1e-13, of the product of the
        lengths of the rows; and where a number is not finite.
        """
        rows = _rows(self)
        lengths = [row.magnitude() for row in rows]
        first, second, third = (row.normalized() for row in rows)
        share = first.dot(second.cross(third))  # of the product of the lengths
        if not abs(share) > SINGULAR:  # "not >" refuses NaN too
            raise ValueError(
                f"the matrix must have an inverse, but its determinant {self.determinant()!r} is "
                f"{share!r} of the product of its rows' lengths, which is not above {SINGULAR}"
            )
        columns = (second.cross(third), third.cross(first), first.cross(second))
        scaled = [column / share / length for column, length in zip(columns, lengths, strict=True)]
        return Matrix3(*(number for row in zip(*scaled, strict=True) for number in row))

    def is_rotation(self) -> bool:
        """Say whether this turns and does nothing else: no scaling, no skewing, no mirroring.

        Then the product of each row with itself is 1 and with each other row 0, both to within
        ROTATION_TOLERANCE, and the determinant is positive. What is not finite is no rotation.
        """
        products = self.product(self.transpose())
        identity = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
        return self.determinant() > 0.0 and all(
            abs(got - wanted) <= ROTATION_TOLERANCE
            for got, wanted in zip(products, identity, strict=True)
        )

    @staticmethod
    def from_quaternion(q: Quaternion) -> Matrix3:
        """Return the rotation of a quaternion: its columns are the turned axes.

        The book prints its transpose, which turns the other way (E-11).

        Raises ValueError where the quaternion's length is not 1 (is_unit).
        """
        if not isinstance(q, Quaternion):
            raise TypeError(f"q must be a Quaternion, got {q!r}")
        if not q.is_unit():
            raise ValueError(f"q must be of length 1, got {q!r}")
        r, i, j, k = q
        return Matrix3(
            *(1.0 - 2.0 * (j * j + k * k), 2.0 * (i * j - k * r), 2.0 * (i * k + j * r)),
            *(2.0 * (i * j + k * r), 1.0 - 2.0 * (i * i + k * k), 2.0 * (j * k - i * r)),
            *(2.0 * (i * k - j * r), 2.0 * (j * k + i * r), 1.0 - 2.0 * (i * i + j * j)),
        )

    def to_quaternion(self) -> Quaternion:
        """Return the quaternion of this rotation, of length 1; q and -q are equally right.

        Four sums of the diagonal give four squares of the components, 4 r^2, 4 i^2, 4 j^2 and
        4 k^2. The largest is never below 1, and the others follow from it safely, while another may
        be rounding alone, as r is in a half-turn.

        Raises ValueError where this is no rotation (is_rotation).
        """
        if not self.is_rotation():
            raise ValueError(f"the matrix must be a rotation, got {self!r}")
        a, b, c, d, e, f, g, h, i = self.entries
        candidates = (
            Quaternion(1.0 + a + e + i, h - f, c - g, d - b),
            Quaternion(h - f, 1.0 + a - e - i, b + d, c + g),
            Quaternion(c - g, b + d, 1.0 - a + e - i, f + h),
            Quaternion(d - b, c + g, f + h, 1.0 - a - e + i),
        )
        q = max(candidates, key=Quaternion.magnitude)  # each is 4 of its component times q
        q.normalize()
        return q


def _rows(m: Matrix3) -> tuple[Vector3, Vector3, Vector3]:
    """Return the rows as vectors."""
    a, b, c, d, e, f, g, h, i = m.entries
    return Vector3(a, b, c), Vector3(d, e, f), Vector3(g, h, i)
