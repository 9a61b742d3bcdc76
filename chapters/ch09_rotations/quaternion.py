"""Orientations in space as quaternions (book 9.2.4 and 9.4.7 to 9.4.11).

A quaternion of length 1 stands for an orientation: a turn by ``angle`` about ``axis`` is
(cos(angle/2), axis sin(angle/2)), and q and -q are the same one. Turns are right-handed and, as the
book has them, about axes of the world: ``b * a`` is a first and then b.

Raises TypeError for what is no number, no Vector3 or no Quaternion where one is wanted. Of a vector
that is turned only the type is looked at: any components will do.
"""

from __future__ import annotations

from collections.abc import Iterator

from ch02_vectors.vector import Vector3

# How far a length may be from 1 for a quaternion that must be of length 1: rounding stays far below
# that, steps of Eq. 9.5 that are not normalised do not for long.
UNIT_TOLERANCE = 1e-6


class Quaternion:
    """Four components: the scalar r, and i, j and k along X, Y and Z (Eq. 9.4).

    Any float will do: a quaternion is only numbers, until it is asked to turn something. That of no
    arguments is the reference orientation, the one that turns nothing.

    Components are what float() takes, and raise what it raises.
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
        """Exact, component by component: q and -q differ, though they are one orientation."""
        if not isinstance(other, Quaternion):
            return NotImplemented
        return [*self] == [*other]

    def copy(self) -> Quaternion:
        """Return a new quaternion with the same components."""
        return Quaternion(self.r, self.i, self.j, self.k)

    def magnitude(self) -> float:
        """Return the length, the root of the sum of the four squares: 1 for an orientation."""
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def is_unit(self) -> bool:
        """Say whether the length is 1 to within UNIT_TOLERANCE; NaN is not."""
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def normalize(self) -> None:
        """Make the length 1 and keep the proportions, in place; zero becomes (1, 0, 0, 0) (9.4.8).

        Right for components as large as 1e200 and as small as 1e-200 too.
        """
        raise NotImplementedError("Exercise B9.7: The length of a quaternion")

    def conjugate(self) -> Quaternion:
        """Return (r, -i, -j, -k) as new: the opposite turn, where the length is 1."""
        raise NotImplementedError("Exercise B9.8: The product of quaternions")

    def __mul__(self, q: Quaternion) -> Quaternion:
        """Return the product, as new: the turn of q and then this one (9.4.9)."""
        raise NotImplementedError("Exercise B9.8: The product of quaternions")

    @staticmethod
    def from_axis_angle(axis: Vector3, angle: float) -> Quaternion:
        """Return the turn by an angle in radians about an axis of any length but zero (Eq. 9.4).

        Raises ValueError where the axis is zero, or where a number is not finite.
        """
        raise NotImplementedError("Exercise B9.9: Axis and angle, there and back")

    def to_axis_angle(self) -> tuple[Vector3, float]:
        """Return the axis, a new unit vector, and the angle in radians, from 0 to pi.

        q and -q give the same turn. A half-turn may have its axis either way; a turn of 0 has X for
        want of one. Right for angles of 1e-200 too.

        Raises ValueError where the length is not 1 (is_unit).
        """
        raise NotImplementedError("Exercise B9.9: Axis and angle, there and back")

    def rotate(self, v: Vector3) -> Vector3:
        """Return the vector turned, as new: q (0, v) q*, which keeps its length.

        Raises ValueError where the quaternion's length is not 1 (is_unit): it would scale v too.
        """
        raise NotImplementedError("Exercise B9.10: Turn a vector")

    def rotate_by(self, vector: Vector3) -> None:
        """Turn on by a scaled axis, in place: about its direction, by its length in radians.

        The axis is one of the world. This is exp((0, vector)/2) times q, of which Eq. 9.9 is the
        first order. The listing multiplies by (0, vector) itself, which is no turn, on the wrong
        side (E-12). Zero leaves the quaternion as it was.

        Raises ValueError where the vector is not finite.
        """
        raise NotImplementedError("Exercise B9.11: Turn on by a vector: exactly, and by Eq. 9.5")

    def add_scaled(self, vector: Vector3, scale: float) -> None:
        """Add scale/2 times (0, vector) times q, in place (Eq. 9.5).

        With an angular velocity and a duration it is the book's step: right to the first order, and
        the length grows by it (E-31), so it does not normalise: measure that first.

        Raises ValueError where the vector or the scale is not finite.
        """
        raise NotImplementedError("Exercise B9.11: Turn on by a vector: exactly, and by Eq. 9.5")
