"""Matrices that rotate, scale and move points, and a change of basis (book 9.4.2 to 9.4.6).

The conventions are the same as in matrix3.py. Vectors are columns, and a product applies its
right factor first. You can also import Matrix3 from here.
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
    """A 3x4 matrix, which can rotate, scale and shear a point and then move it.

    Its first three columns are a Matrix3, and the fourth column is the translation. Pass its twelve
    numbers row by row. ``entries`` is the tuple of all twelve, and ``m[row, column]`` reads one of
    them, with rows from 0 to 2 and columns from 0 to 3.
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
        """Return the number at a given row and column, as in ``m[0, 3]``."""
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
        """Multiply the 3x3 part by the point ``v``, add the translation, and return a new vector.

        You can also write ``m @ v``. Book: section 9.4.2.
        """
        raise NotImplementedError("Exercise B9.14: A matrix that rotates and moves")

    def product(self, m: Matrix4) -> Matrix4:
        """Return the product ``self @ m``, a new matrix that applies ``m`` first.

        Book: section 9.4.2.
        """
        raise NotImplementedError("Exercise B9.14: A matrix that rotates and moves")

    def determinant(self) -> float:
        """Compute the determinant of the 3x3 part, the factor by which the matrix scales volumes.

        The determinant is negative if the matrix contains a reflection. The book's listing has a
        sign error (erratum E-28).
        """
        raise NotImplementedError("Exercise B9.14: A matrix that rotates and moves")

    def inverse(self) -> Matrix4:
        """Compute the inverse: a new matrix that undoes the effect of this one.

        First invert the 3x3 part. Then multiply the result by the negative of the translation,
        which gives the translation of the inverse. Do not copy the book's listings, because they
        contain errors (errata E-13, E-29 and E-30).

        Raises:
            ValueError: if ``Matrix3.inverse`` rejects the 3x3 part.

        Book: section 9.4.3.
        """
        raise NotImplementedError("Exercise B9.14: A matrix that rotates and moves")

    @staticmethod
    def from_orientation_and_position(q: Quaternion, p: Vector3) -> Matrix4:
        """Create the matrix that converts the coordinates of an object to world coordinates.

        ``q`` is the orientation of the object and ``p`` its position, so the matrix rotates by
        ``q`` and then adds ``p``.
        """
        raise NotImplementedError("Exercise B9.15: Between an object and the world")

    def transform_inverse(self, v: Vector3) -> Vector3:
        """Find the point that ``transform`` maps to ``v``, and return it as a new vector.

        For the matrix of an object, this converts world coordinates to the coordinates of the
        object. Subtract the translation from ``v``, and then multiply by the transpose of the 3x3
        part. This is faster than inverting the matrix. However, it is correct only if the 3x3 part
        is a rotation, whose transpose is its inverse. Book: section 9.4.5.
        """
        raise NotImplementedError("Exercise B9.15: Between an object and the world")

    def transform_direction(self, v: Vector3) -> Vector3:
        """Multiply the direction ``v`` by the 3x3 part only, and return a new vector.

        The translation moves points, but it does not change directions, such as a normal. Book:
        section 9.4.5.
        """
        raise NotImplementedError("Exercise B9.15: Between an object and the world")

    def transform_inverse_direction(self, v: Vector3) -> Vector3:
        """Find the direction that ``transform_direction`` maps to ``v``, as a new vector.

        Multiply ``v`` by the transpose of the 3x3 part, which for a rotation is also the inverse.
        Book: section 9.4.5.
        """
        raise NotImplementedError("Exercise B9.15: Between an object and the world")


def change_basis(m: M, basis: M) -> M:
    """Express the transformation ``m`` in a new basis, as the product basis * m * basis^-1.

    The two arguments are both a Matrix3 or both a Matrix4, whose translations count too. ``m``
    transforms vectors given in the old basis, and ``basis`` converts old coordinates to new
    coordinates. The returned matrix performs the same transformation on vectors given in the new
    basis. It converts them to the old basis, applies ``m``, and converts them back. Book: section
    9.4.6.
    """
    raise NotImplementedError("Exercise B9.16: A change of basis")
