"""Orientations in space as quaternions (book 9.2.4 and 9.4.7 to 9.4.11).

A quaternion of length 1 represents an orientation, and also the rotation from the reference to this
orientation. The rotation by ``angle`` about the unit vector ``axis`` is (cos(angle/2), axis
sin(angle/2)). The quaternions q and -q represent the same orientation. As in the book, rotations
are right-handed and about world axes, so ``b * a`` rotates by a first and then by b.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from ch02_vectors.arguments import finite, finite_vector, instance_of
from ch02_vectors.vector import Vector3

# How far the length of an orientation may be from 1. Rounding errors stay far below this. Steps of
# Eq. 9.5 exceed it soon unless they are normalized.
UNIT_TOLERANCE = 1e-6


class Quaternion:
    """A quaternion with four components: the scalar r, and i, j and k along X, Y and Z (Eq. 9.4).

    The components are converted by float(), and they may have any values. Only ``to_axis_angle``
    checks that the length is 1. Quaternion() is the reference orientation, which represents no
    rotation.
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
        """Return True if all components are exactly equal.

        The quaternions q and -q are therefore unequal, although they represent the same
        orientation.
        """
        if not isinstance(other, Quaternion):
            return NotImplemented
        return [*self] == [*other]

    def copy(self) -> Quaternion:
        """Return a new quaternion with the same components."""
        return Quaternion(self.r, self.i, self.j, self.k)

    def magnitude(self) -> float:
        """Compute the length, sqrt(r^2 + i^2 + j^2 + k^2), which is 1 for an orientation.

        The result must also be correct for components as large as 1e200 and as small as 1e-200.
        """
        return math.hypot(self.r, self.i, self.j, self.k)

    def is_unit(self) -> bool:
        """Return True if the length is 1 to within ``UNIT_TOLERANCE``, as an orientation requires.

        If a component is NaN, infinite or as large as 1e200, the result is False.
        """
        return abs(self.magnitude() - 1.0) <= UNIT_TOLERANCE

    def normalize(self) -> None:
        """Scale the quaternion to length 1, in place, by dividing each component by the length.

        A zero quaternion cannot be divided by its length, so it becomes (1, 0, 0, 0), the
        reference. The result must also be correct for components as large as 1e200 and as small as
        1e-200. Book: section 9.4.8.
        """
        length = self.magnitude()
        if length == 0.0:
            self.r = 1.0
            return
        self.r /= length
        self.i /= length
        self.j /= length
        self.k /= length

    def conjugate(self) -> Quaternion:
        """Return the new quaternion (r, -i, -j, -k).

        For a unit quaternion, the conjugate is the inverse, so it undoes the rotation.
        """
        return Quaternion(self.r, -self.i, -self.j, -self.k)

    def __mul__(self, q: Quaternion) -> Quaternion:
        """Return the new quaternion ``self * q``, which rotates by ``q`` and then by ``self``.

        Book: section 9.4.9.
        """
        instance_of("q", q, Quaternion)
        return Quaternion(
            self.r * q.r - self.i * q.i - self.j * q.j - self.k * q.k,
            self.r * q.i + self.i * q.r + self.j * q.k - self.k * q.j,
            self.r * q.j + self.j * q.r + self.k * q.i - self.i * q.k,
            self.r * q.k + self.k * q.r + self.i * q.j - self.j * q.i,
        )

    @staticmethod
    def from_axis_angle(axis: Vector3, angle: float) -> Quaternion:
        """Create the quaternion of a rotation by ``angle`` in radians about ``axis``.

        Only the direction of the axis matters, so the axis may have any length except 0. The result
        is a new unit quaternion.

        Raises:
            ValueError: if the axis is zero or a number is not finite.
            TypeError: if the axis is not a Vector3 or the angle is not a number.

        Book: Eq. 9.4.
        """
        direction = finite_vector("axis", axis).normalized()
        if direction.squared_magnitude() == 0.0:
            raise ValueError(f"axis must not be zero, got {axis!r}")
        half = 0.5 * finite("angle", angle)
        sine = math.sin(half)
        return Quaternion(
            math.cos(half), direction.x * sine, direction.y * sine, direction.z * sine
        )

    def to_axis_angle(self) -> tuple[Vector3, float]:
        """Convert the rotation to an axis, which is a new unit vector, and an angle from 0 to pi.

        The angle is in radians. The quaternions q and -q represent the same rotation, so they give
        the same result. For a half-turn, you may return either the axis or its opposite. For an
        angle of 0, any axis would be correct, so return X. The result must also be correct for
        angles as small as 1e-200, and for every length that ``is_unit`` accepts.

        Raises:
            ValueError: if the length is not 1 (``is_unit``).
        """
        if not self.is_unit():
            raise ValueError(f"the quaternion must have length 1, got {self!r}")
        axis = Vector3(self.i, self.j, self.k)
        angle = 2.0 * math.atan2(axis.magnitude(), abs(self.r))
        if self.r < 0.0:
            axis.invert()
        axis.normalize()
        return (axis, angle) if angle > 0.0 else (Vector3(1.0, 0.0, 0.0), 0.0)

    def rotate(self, v: Vector3) -> Vector3:
        """Rotate the vector ``v`` by this quaternion, and return the result as a new vector.

        The result is q (0, v) q*, where q* is the conjugate of this quaternion q.
        """
        instance_of("v", v, Vector3)
        # The same product without the terms that are zero: v + 2 r (u x v) + 2 u x (u x v).
        u = Vector3(self.i, self.j, self.k)
        across = u.cross(v)
        turned = v + across * (2.0 * self.r)
        turned.add_scaled(u.cross(across), 2.0)
        return turned

    def rotate_by(self, vector: Vector3) -> None:
        """Rotate the orientation in place by the rotation vector ``vector``.

        The direction of ``vector`` is the axis of the rotation, in world axes. Its length is the
        angle in radians, so a zero vector changes nothing. The result must also be correct for
        vectors as short as 1e-200. The new orientation is exp((0, vector)/2) q, where q is the old
        one. Eq. 9.9 is only a first-order approximation of this product. The book's listing
        contains two errors: it multiplies by (0, vector), which is not a rotation, and it does so
        on the wrong side (erratum E-12).
        """
        angle = finite_vector("vector", vector).magnitude()
        if angle > 0.0:
            turned = Quaternion.from_axis_angle(vector, angle) * self
            self.r, self.i, self.j, self.k = turned

    def add_scaled(self, vector: Vector3, scale: float) -> None:
        """Add scale/2 times (0, vector) q to this quaternion q, in place (Eq. 9.5).

        If ``vector`` is an angular velocity and ``scale`` is a duration, this sum is the book's
        time step for an orientation. It is only a first-order approximation of the rotation, and it
        makes the quaternion longer (erratum E-31). Do not normalize the result, because the
        exercises measure this error.
        """
        half = 0.5 * finite("scale", scale)
        rate = Quaternion(0.0, *finite_vector("vector", vector)) * self
        self.r += rate.r * half
        self.i += rate.i * half
        self.j += rate.j * half
        self.k += rate.k * half
