"""Matrices that rotate, scale and move points, and a change of basis (book 9.4.2 to 9.4.6).

The conventions are the same as in matrix3.py: vectors are columns, and a product applies its right
factor first. Every method returns a new object. You can also import Matrix3 from here.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar, overload

from ch02_vectors.arguments import instance_of
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix3 import ROTATION_TOLERANCE as ROTATION_TOLERANCE
from ch09_rotations.matrix3 import SINGULAR as SINGULAR
from ch09_rotations.matrix3 import Matrix3 as Matrix3
from ch09_rotations.quaternion import Quaternion

M = TypeVar("M", "Matrix3", "Matrix4")


class Matrix4:
    """A 3x4 matrix, which can rotate, scale and shear a point and then move it.

    Its first three columns are a Matrix3, and the fourth column is the translation. ``entries`` is
    the tuple of its twelve numbers, row by row.
    """

    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 12:
            raise TypeError(
                f"Matrix4 takes twelve numbers, row by row, got {len(entries)} "
                "(if they are in a list, write Matrix4(*numbers))"
            )
        self.entries = tuple(map(float, entries))

    def __repr__(self) -> str:
        return f"Matrix4({', '.join(map(repr, self.entries))})"

    def __iter__(self) -> Iterator[float]:
        return iter(self.entries)

    def __eq__(self, other: object) -> bool:
        """Return True if all numbers of the two matrices are exactly equal."""
        return self.entries == other.entries if isinstance(other, Matrix4) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        """Return the number at a row and a column, as in ``m[0, 3]``."""
        row, column = place
        if row not in range(3) or column not in range(4):
            raise IndexError(f"row must be from 0 to 2 and column from 0 to 3, got {place!r}")
        return self.entries[4 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix4) -> Matrix4: ...
    def __matmul__(self, other: Vector3 | Matrix4) -> Vector3 | Matrix4:
        """Return ``transform(other)`` for a vector, or ``product(other)`` for a matrix."""
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix4) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        """Multiply ``v`` by the 3x3 part, add the translation, and return a new vector (9.4.2)."""
        return _linear(self).transform(v) + _translation(self)

    def product(self, m: Matrix4) -> Matrix4:
        """Return the product ``self @ m``, a new matrix that applies ``m`` first (9.4.2)."""
        instance_of("m", m, Matrix4)
        linear = _linear(self).product(_linear(m))
        return _joined(linear, self.transform(_translation(m)))

    def determinant(self) -> float:
        """Compute the determinant of the 3x3 part. The book's has a sign error (erratum E-28)."""
        return _linear(self).determinant()

    def inverse(self) -> Matrix4:
        """Compute the inverse: a new matrix that undoes the effect of this one (9.4.3).

        Multiply the inverse of the 3x3 part by the negative of the translation. Raises ValueError
        if ``Matrix3.inverse`` rejects the 3x3 part. The book's listings have errors (E-13, E-29).
        """
        back = _linear(self).inverse()
        return _joined(back, -back.transform(_translation(self)))

    @staticmethod
    def from_orientation_and_position(q: Quaternion, p: Vector3) -> Matrix4:
        """Create the matrix of an object: the matrix rotates by q and then adds p."""
        return _joined(Matrix3.from_quaternion(q), instance_of("p", p, Vector3))

    def transform_inverse(self, v: Vector3) -> Vector3:
        """Find the point that ``transform`` maps to ``v``, if the 3x3 part is a rotation (9.4.5).

        Subtract the translation, and then multiply by the transpose of the 3x3 part, which is
        faster than inverting the matrix.
        """
        instance_of("v", v, Vector3)
        return self.transform_inverse_direction(v - _translation(self))

    def transform_direction(self, v: Vector3) -> Vector3:
        """Multiply the direction ``v`` by the 3x3 part only, without the translation (9.4.5)."""
        return _linear(self).transform(v)

    def transform_inverse_direction(self, v: Vector3) -> Vector3:
        """Multiply the direction ``v`` by the transpose of the 3x3 part (9.4.5)."""
        return _linear(self).transpose().transform(v)


def change_basis(m: M, basis: M) -> M:
    """Express the transformation ``m`` in a new basis, as the product basis * m * basis^-1 (9.4.6).

    The arguments are both a Matrix3 or both a Matrix4, whose translations count too. ``basis``
    converts old coordinates to new ones. The result performs the transformation on vectors given in
    the new basis. It converts them to the old basis, applies ``m``, and converts them back.
    """
    return basis.product(m).product(basis.inverse())


def _linear(m: Matrix4) -> Matrix3:
    """Return the 3x3 part of a matrix, without the translation."""
    return Matrix3(*(m[row, column] for row in range(3) for column in range(3)))


def _translation(m: Matrix4) -> Vector3:
    """Return the translation of a matrix as a vector."""
    return Vector3(m[0, 3], m[1, 3], m[2, 3])


def _joined(linear: Matrix3, translation: Vector3) -> Matrix4:
    """Create a Matrix4 from its 3x3 part and its translation."""
    rows = linear.entries[:3], linear.entries[3:6], linear.entries[6:]
    x, y, z = translation
    return Matrix4(*rows[0], x, *rows[1], y, *rows[2], z)
