"""Quaternions."""

import math

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3

UNIT_TOLERANCE = 1e-6


class Quaternion:
    __slots__ = ("i", "j", "k", "r")

    def __init__(self, r=1.0, i=0.0, j=0.0, k=0.0):
        self.r = float(r)
        self.i = float(i)
        self.j = float(j)
        self.k = float(k)

    def __repr__(self):
        return f"Quaternion({self.r!r}, {self.i!r}, {self.j!r}, {self.k!r})"

    def __iter__(self):
        yield self.r
        yield self.i
        yield self.j
        yield self.k

    def __eq__(self, other):
        if not isinstance(other, Quaternion):
            return NotImplemented
        return [*self] == [*other]

    def copy(self):
        return Quaternion(self.r, self.i, self.j, self.k)

    def magnitude(self):
        return math.sqrt(self.r**2 + self.i**2 + self.j**2 + self.k**2)

    def is_unit(self):
        return abs(self.magnitude() - 1) < UNIT_TOLERANCE

    def normalize(self):
        d = self.magnitude()
        if d == 0:
            self.r = 1.0
            return
        self.r /= d
        self.i /= d
        self.j /= d
        self.k /= d

    def conjugate(self):
        return Quaternion(self.r, -self.i, -self.j, -self.k)

    def __mul__(self, q):
        if not isinstance(q, Quaternion):
            return NotImplemented
        return Quaternion(
            self.r * q.r - self.i * q.i - self.j * q.j - self.k * q.k,
            self.r * q.i + self.i * q.r + self.j * q.k - self.k * q.j,
            self.r * q.j + self.j * q.r + self.k * q.i - self.i * q.k,
            self.r * q.k + self.k * q.r + self.i * q.j - self.j * q.i,
        )

    @staticmethod
    def from_axis_angle(axis, angle):
        finite("angle", angle)
        finite_vector("axis", axis)
        if axis.magnitude() == 0:
            raise ValueError("axis is zero")
        axis = axis.normalized()
        s = math.sin(angle / 2)
        return Quaternion(math.cos(angle / 2), axis.x * s, axis.y * s, axis.z * s)

    def to_axis_angle(self):
        if not self.is_unit():
            raise ValueError("length must be 1")
        angle = 2 * math.acos(self.r)
        s = math.sqrt(1 - self.r**2)
        if s == 0:
            return Vector3(1, 0, 0), 0.0
        return Vector3(self.i / s, self.j / s, self.k / s), angle

    def rotate(self, v):
        q = self * Quaternion(0, v.x, v.y, v.z) * self.conjugate()
        return Vector3(q.i, q.j, q.k)

    def rotate_by(self, vector):
        # the book: (*this) *= q
        finite_vector("vector", vector)
        q = self * Quaternion(0, vector.x, vector.y, vector.z)
        self.r, self.i, self.j, self.k = q

    def add_scaled(self, vector, scale):
        finite_vector("vector", vector)
        finite("scale", scale)
        q = Quaternion(0, vector.x * scale, vector.y * scale, vector.z * scale)
        q = q * self
        self.r += q.r * 0.5
        self.i += q.i * 0.5
        self.j += q.j * 0.5
        self.k += q.k * 0.5
