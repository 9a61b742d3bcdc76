"""Matrices that rotate and scale vectors (book 9.2.3, 9.4.1 to 9.4.4).

A vector is a column, so it is on the right of a matrix: ``m @ v``. The product ``a @ b`` therefore
applies b first and then a. Every method returns a new object. An argument of the wrong type raises
TypeError.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

# A determinant up to this fraction of the product of the rows' lengths, its largest possible value,
# counts as zero.
SINGULAR = 1e-13

# How far the products of a rotation's rows may be from 1 and 0. For a quaternion whose length
# is_unit just accepts, the errors are up to 8e-6.
ROTATION_TOLERANCE = 1e-5


class Matrix3:
    """A 3x3 matrix, which can rotate, scale and shear vectors but not move the origin.

    ``entries`` is the tuple of its nine numbers, row by row.
    """

    __slots__ = ("entries",)

    entries: tuple[float, ...]

    def __init__(self, *entries: float) -> None:
        if len(entries) != 9:
            raise TypeError(
                f"Matrix3 takes nine numbers, row by row, got {len(entries)} "
                "(if they are in a list, write Matrix3(*numbers))"
            )
        self.entries = tuple(map(float, entries))

    def __repr__(self) -> str:
        return f"Matrix3({', '.join(map(repr, self.entries))})"

    def __iter__(self) -> Iterator[float]:
        return iter(self.entries)

    def __eq__(self, other: object) -> bool:
        """Return True if all numbers of the two matrices are exactly equal."""
        return self.entries == other.entries if isinstance(other, Matrix3) else NotImplemented

    def __getitem__(self, place: tuple[int, int]) -> float:
        """Return the number at a given row and column, as in ``m[0, 2]``."""
        row, column = place
        if row not in range(3) or column not in range(3):
            raise IndexError(f"row and column must be from 0 to 2, got {place!r}")
        return self.entries[3 * row + column]

    @overload
    def __matmul__(self, other: Vector3) -> Vector3: ...
    @overload
    def __matmul__(self, other: Matrix3) -> Matrix3: ...
    def __matmul__(self, other: Vector3 | Matrix3) -> Vector3 | Matrix3:
        """Return ``transform(other)`` for a vector, or ``product(other)`` for a matrix."""
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix3) else NotImplemented

    def transform(self, v: Vector3) -> Vector3:
        """Multiply the matrix by the vector ``v``, as ``m @ v`` does (9.4.2)."""
        raise NotImplementedError("Exercise B9.4: A matrix times a vector, and times a matrix")

    def product(self, m: Matrix3) -> Matrix3:
        """Return the product ``self @ m``, a new matrix that applies ``m`` first (9.4.2)."""
        raise NotImplementedError("Exercise B9.4: A matrix times a vector, and times a matrix")

    def transpose(self) -> Matrix3:
        """Swap the rows and columns of the matrix. For a rotation, this is its inverse (9.4.3)."""
        raise NotImplementedError("Exercise B9.4: A matrix times a vector, and times a matrix")

    def determinant(self) -> float:
        """Compute the determinant, the factor by which the matrix scales volumes (9.4.3).

        It is negative if the matrix contains a reflection.
        """
        raise NotImplementedError("Exercise B9.5: Determinant and inverse")

    def inverse(self) -> Matrix3:
        """Compute the inverse: a new matrix that undoes the effect of this one (9.4.3).

        Raises:
            ValueError: if |determinant| is at most ``SINGULAR`` (1e-13) times the product of the
                rows' lengths. Rounding errors then make the inverse useless, at any scale.
        """
        raise NotImplementedError("Exercise B9.5: Determinant and inverse")

    def is_rotation(self) -> bool:
        """Return True if the matrix only rotates, without scaling, shear or reflection.

        The scalar product of each row with itself must be 1, and with each other row 0, both within
        ``ROTATION_TOLERANCE``, and the determinant must be positive. Otherwise, or if an entry is
        NaN, infinite or as large as 1e200, return False.
        """
        raise NotImplementedError("Exercise B9.6: Is it a rotation?")

    @staticmethod
    def from_quaternion(q: Quaternion) -> Matrix3:
        """Create the matrix that rotates vectors in the same way as the quaternion ``q``.

        The columns of the matrix are the axes X, Y and Z after the rotation. The book prints the
        transpose (erratum E-11).
        """
        raise NotImplementedError("Exercise B9.12: From a quaternion to a matrix")

    def to_quaternion(self) -> Quaternion:
        """Convert a rotation matrix to a unit quaternion q. You may return either q or -q.

        The diagonal determines 4 r^2, 4 i^2, 4 j^2 and 4 k^2. Start with the component whose number
        is the largest, because a small one may be only rounding error, and compute the others from
        it. The matrix may differ slightly from a rotation, so normalize the quaternion at the end.
        """
        raise NotImplementedError("Exercise B9.13: From a matrix to a quaternion")
