"""Matrices that turn and move points, and matrices in other axes (book 9.4.2, 9.4.3, 9.4.5, 9.4.6).

Columns, products and errors are as in matrix3.py. Its Matrix3 can be imported from here, too.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar, overload

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix3 import ROTATION_TOLERANCE as ROTATION_TOLERANCE
from ch09_rotations.matrix3 import SINGULAR as SINGULAR
from ch09_rotations.matrix3 import Matrix3 as Matrix3
from ch09_rotations.quaternion import Quaternion

M = TypeVar("M", "Matrix3", "Matrix4")


class Matrix4:
    """Twelve numbers, row by row: a Matrix3, and after each of its rows a number of a translation.

    It is the book's matrix of three rows and four columns, whose fourth row would be 0, 0, 0, 1.
    ``m[row, column]`` reads a number, rows from 0 to 2 and columns from 0 to 3; ``entries`` is the
    tuple of all. They are what float() takes. Raises TypeError where there are not twelve.
    """

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
        """Exact, number by number."""
        return self.entries == other.entries if isinstance(other, Matrix4) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        """Return the number in a row and column. Raises IndexError where there is none."""
        row, column = place
        if row not in range(3) or column not in range(4):
            raise IndexError(f"row must be from 0 to 2 and column from 0 to 3, got {place!r}")
        return self.entries[4 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix4) -> Matrix4: ...
    def __matmul__(self, other: Vector3 | Matrix4) -> Vector3 | Matrix4:
        """Return m.transform(v) or m.product(n), by what is on the right."""
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix4) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        """Return where a point is taken, as new: turned, then moved; also written m @ v (9.4.2)."""
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        x, y, z = v.x, v.y, v.z
        a, b, c, p, d, e, f, q, g, h, i, r = self.entries
        return Vector3(
            a * x + b * y + c * z + p, d * x + e * y + f * z + q, g * x + h * y + i * z + r
        )

    def product(self, m: Matrix4) -> Matrix4:
        """Return this matrix times m: m first, then this one; also written @ (9.4.2)."""
        if not isinstance(m, Matrix4):
            raise TypeError(f"m must be a Matrix4, got {m!r}")
        linear = _linear(self).product(_linear(m))
        return _joined(linear, self.transform(_translation(m)))

    def determinant(self) -> float:
        """Return the determinant, in which the translation has no part.

        The book's has a plus where a minus belongs (E-28).
        """
        return _linear(self).determinant()

    def inverse(self) -> Matrix4:
        """Return the matrix that undoes this one: moves back, then turns back (E-13, E-29, E-30).

        Raises ValueError where the nine numbers without the translation have no inverse, as
        Matrix3.inverse does.
        """
        back = _linear(self).inverse()
        return _joined(back, -back.transform(_translation(self)))

    @staticmethod
    def from_orientation_and_position(q: Quaternion, p: Vector3) -> Matrix4:
        """Return what takes an object's own coordinates to the world's: turned by q, moved by p.

        Raises ValueError where the quaternion's length is not 1 (is_unit).
        """
        if not isinstance(p, Vector3):
            raise TypeError(f"p must be a Vector3, got {p!r}")
        return _joined(Matrix3.from_quaternion(q), p)

    def transform_inverse(self, v: Vector3) -> Vector3:
        """Return what transform() takes to v, without the inverse: moved back, then turned back.

        Right only for a rotation and a translation: it turns back by the transpose (9.4.5).
        """
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        a, b, c, p, d, e, f, q, g, h, i, r = self.entries
        x, y, z = v.x - p, v.y - q, v.z - r
        return Vector3(a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z)

    def transform_direction(self, v: Vector3) -> Vector3:
        """Return a direction turned, as new: the translation has no part in it (9.4.5)."""
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        x, y, z = v.x, v.y, v.z
        a, b, c, _, d, e, f, _, g, h, i, _ = self.entries
        return Vector3(a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)

    def transform_inverse_direction(self, v: Vector3) -> Vector3:
        """Return a direction turned back, as new: by the transpose, as transform_inverse does."""
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        x, y, z = v.x, v.y, v.z
        a, b, c, _, d, e, f, _, g, h, i, _ = self.entries
        return Vector3(a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z)


def change_basis(m: M, basis: M) -> M:
    """Return m expressed in other axes: basis m basis^-1 (9.4.6).

    ``m`` is expressed in one set of axes; ``basis`` takes coordinates in those to coordinates in
    the others; both are of one size.

    Raises ValueError where the basis has no inverse, TypeError where the two are not matrices of
    one size.
    """
    if not isinstance(m, (Matrix3, Matrix4)) or type(m) is not type(basis):
        raise TypeError(f"m and basis must be matrices of one size, got {m!r} and {basis!r}")
    return basis.product(m).product(basis.inverse())


def _linear(m: Matrix4) -> Matrix3:
    """Return the numbers without the translation."""
    a, b, c, _, d, e, f, _, g, h, i, _ = m.entries
    return Matrix3(a, b, c, d, e, f, g, h, i)


def _translation(m: Matrix4) -> Vector3:
    """Return the translation."""
    return Vector3(m.entries[3], m.entries[7], m.entries[11])


def _joined(linear: Matrix3, translation: Vector3) -> Matrix4:
    """Return a Matrix4 of its two parts."""
    a, b, c, d, e, f, g, h, i = linear.entries
    x, y, z = translation
    return Matrix4(a, b, c, x, d, e, f, y, g, h, i, z)
