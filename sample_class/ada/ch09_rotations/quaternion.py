"""Orientations in space as quaternions (book 9.2.4 and 9.4.5 to 9.4.10)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3

UNIT_TOLERANCE = 1e-6


class Quaternion:
    """Four components: the scalar r, and i, j and k along X, Y and Z (Eq. 9.4)."""

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
        if not isinstance(other, Quaternion):
            return NotImplemented
        return [*self] == [*other]

    def copy(self) -> Quaternion:
        return Quaternion(self.r, self.i, self.j, self.k)

    def magnitude(self) -> float:
        return math.hypot(math.hypot(self.r, self.i), math.hypot(self.j, self.k))

    def is_unit(self) -> bool:
        return abs(self.magnitude() - 1.0) <= UNIT_TOLERANCE

    def normalize(self) -> None:
        if not any(self):
            self._set(1.0, 0.0, 0.0, 0.0)
            return
        # Powers of two come off first: that is exact, and leaves a length of about 1.
        power = max(math.frexp(part)[1] for part in self if part)
        near = Quaternion(*(math.ldexp(part, -power) for part in self))
        length = near.magnitude()
        self._set(*(part / length for part in near))

    def conjugate(self) -> Quaternion:
        return Quaternion(self.r, -self.i, -self.j, -self.k)

    def __mul__(self, q: Quaternion) -> Quaternion:
        if not isinstance(q, Quaternion):
            return NotImplemented
        a, b = complex(self.r, self.i), complex(self.j, self.k)
        c, d = complex(q.r, q.i), complex(q.j, q.k)
        first = a * c - b * d.conjugate()
        second = a * d + b * c.conjugate()
        return Quaternion(first.real, first.imag, second.real, second.imag)

    @staticmethod
    def from_axis_angle(axis: Vector3, angle: float) -> Quaternion:
        axis, angle = finite_vector("axis", axis), finite("angle", angle)
        if not any(axis):
            raise ValueError(f"axis must not be zero, got {axis!r}")
        return _half_turned(axis, angle / 2.0)

    def to_axis_angle(self) -> tuple[Vector3, float]:
        self._must_be_unit()
        if not (self.i or self.j or self.k):
            return Vector3(1.0, 0.0, 0.0), 0.0
        sine = math.hypot(self.i, self.j, self.k)
        sign = math.copysign(1.0, self.r)
        axis = _unit(Vector3(sign * self.i, sign * self.j, sign * self.k))
        return axis, 2.0 * math.atan2(sine, sign * self.r)

    def rotate(self, v: Vector3) -> Vector3:
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        self._must_be_unit()
        _, *turned = self * Quaternion(0.0, *v) * self.conjugate()
        return Vector3(*turned)

    def rotate_by(self, vector: Vector3) -> None:
        half = finite_vector("vector", vector) * 0.5
        if any(half):
            self._set(*(_half_turned(half, half.magnitude()) * self))

    def add_scaled(self, vector: Vector3, scale: float) -> None:
        rate = Quaternion(0.0, *finite_vector("vector", vector)) * self
        half = finite("scale", scale) / 2.0
        self._set(*(part + half * change for part, change in zip(self, rate, strict=True)))

    def _set(self, r: float, i: float, j: float, k: float) -> None:
        self.r, self.i, self.j, self.k = r, i, j, k

    def _must_be_unit(self) -> None:
        if not self.is_unit():
            raise ValueError(f"the length must be 1, got {self.magnitude()!r} of {self!r}")


def _unit(v: Vector3) -> Vector3:
    """Return the direction of a vector that is not zero, whatever its size."""
    q = Quaternion(0.0, *v)
    q.normalize()
    return Vector3(q.i, q.j, q.k)


def _half_turned(axis: Vector3, half: float) -> Quaternion:
    """Return the turn about an axis that is not zero, by twice the angle."""
    return Quaternion(math.cos(half), *(_unit(axis) * math.sin(half)))
