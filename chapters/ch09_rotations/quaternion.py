"""Orientations in space as quaternions (book 9.2.4 and 9.4.7 to 9.4.11).

A quaternion of length 1 represents an orientation, and also the rotation from the reference to it.
The rotation by ``angle`` about the unit vector ``axis`` is (cos(angle/2), axis sin(angle/2)). The
quaternions q and -q represent the same orientation. Rotations are right-handed and about world
axes, so ``b * a`` rotates by a first and then by b.

A number that is not finite raises ValueError, and an argument of the wrong type raises TypeError.
Lengths must also be correct for components as large as 1e200 and as small as 1e-200.
"""

from __future__ import annotations

from collections.abc import Iterator

from ch02_vectors.vector import Vector3

# How far the length of an orientation may be from 1. Rounding errors stay far below this. Steps of
# Eq. 9.5 exceed it soon unless they are normalized.
UNIT_TOLERANCE = 1e-6


class Quaternion:
    """A quaternion with four components: the scalar r, and i, j and k along X, Y and Z (Eq. 9.4).

    The components may have any values. Quaternion() is the reference, which is no rotation.
    """

    __slots__ = ("i", "j", "k", "r")

    r: float
    i: float
    j: float
    k: float

    def __init__(self, r: float = 1.0, i: float = 0.0, j: float = 0.0, k: float = 0.0) -> None:
        self.r = float(r)
        self.i = float(i)
        self.j = float(j)
        self.k = float(k)

    def __repr__(self) -> str:
        return f"Quaternion({self.r!r}, {self.i!r}, {self.j!r}, {self.k!r})"

    def __iter__(self) -> Iterator[float]:
        yield self.r
        yield self.i
        yield self.j
        yield self.k

    def __eq__(self, other: object) -> bool:
        """Return True if all components are exactly equal, so q and -q are unequal."""
        if not isinstance(other, Quaternion):
            return NotImplemented
        return [*self] == [*other]

    def copy(self) -> Quaternion:
        """Return a new quaternion with the same components."""
        return Quaternion(self.r, self.i, self.j, self.k)

    def magnitude(self) -> float:
        """Compute the length, sqrt(r^2 + i^2 + j^2 + k^2), which is 1 for an orientation."""
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def is_unit(self) -> bool:
        """Return True if the length is 1 to within ``UNIT_TOLERANCE``, and False for NaN."""
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def normalize(self) -> None:
        """Scale the quaternion to length 1, in place, by dividing each component by the length.

        A quaternion of length 0 has no direction, so it becomes (1, 0, 0, 0), the reference.
        """
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def conjugate(self) -> Quaternion:
        """Return the new quaternion (r, -i, -j, -k), which undoes the rotation of a unit one."""
        raise NotImplementedError("Exercise B9.8: The product of quaternions")

    def __mul__(self, q: Quaternion) -> Quaternion:
        """Return the new quaternion ``self * q``, which rotates by q and then by self (9.4.9)."""
        raise NotImplementedError("Exercise B9.8: The product of quaternions")

    @staticmethod
    def from_axis_angle(axis: Vector3, angle: float) -> Quaternion:
        """Create the quaternion of a rotation by ``angle`` in radians about ``axis``.

        Only the direction of the axis matters, so the axis may have any length except 0. Raises
        ValueError if the axis is zero or a number is not finite. Book: Eq. 9.4.
        """
        raise NotImplementedError("Exercise B9.9: Axis and angle, both ways")

    def to_axis_angle(self) -> tuple[Vector3, float]:
        """Convert the rotation to an axis, which is a new unit vector, and an angle from 0 to pi.

        The quaternions q and -q give the same result. For a half-turn, either axis is right. For an
        angle of 0, any axis would be correct, so return X. The result must also be correct for
        angles as small as 1e-200, and for every length that ``is_unit`` accepts. Raises ValueError
        if the length is not 1 (``is_unit``).
        """
        raise NotImplementedError("Exercise B9.9: Axis and angle, both ways")

    def rotate(self, v: Vector3) -> Vector3:
        """Rotate ``v`` by this quaternion q, and return the result as a new vector: q (0, v) q*."""
        raise NotImplementedError("Exercise B9.10: Rotating a vector")

    def rotate_by(self, vector: Vector3) -> None:
        """Rotate the orientation in place by the rotation vector ``vector``.

        The direction of ``vector`` is the axis of the rotation, in world axes. Its length is the
        angle in radians, so a zero vector changes nothing. The result must also be correct for
        vectors as short as 1e-200. The new orientation is exp((0, vector)/2) q (erratum E-12).
        """
        raise NotImplementedError("Exercise B9.11: Rotating by a vector: exactly, and by Eq. 9.5")

    def add_scaled(self, vector: Vector3, scale: float) -> None:
        """Add scale/2 times (0, vector) q to this quaternion q, in place (Eq. 9.5).

        For an angular velocity and a duration, this is the book's time step. It makes the
        quaternion longer (erratum E-31). Do not normalize the result.
        """
        raise NotImplementedError("Exercise B9.11: Rotating by a vector: exactly, and by Eq. 9.5")
