"""Ada's quaternions: a number r and a vector (i, j, k), and the vectors do the work."""

import math

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3

UNIT_TOLERANCE = 1e-6


def need_unit(name, q):
    if not q.is_unit():
        raise ValueError(f"{name} must be of length 1, got {q!r}")


class Quaternion:
    def __init__(self, r=1.0, i=0.0, j=0.0, k=0.0):
        self.r = float(r)
        self.i, self.j, self.k = float(i), float(j), float(k)

    def __repr__(self):
        return f"Quaternion({self.r!r}, {self.i!r}, {self.j!r}, {self.k!r})"

    def __iter__(self):
        return iter((self.r, self.i, self.j, self.k))

    def __eq__(self, other):
        return tuple(self) == tuple(other) if isinstance(other, Quaternion) else NotImplemented

    @property
    def vector(self):
        """What stands beside r."""
        return Vector3(self.i, self.j, self.k)

    @staticmethod
    def of(r, v):
        """From the two parts."""
        return Quaternion(r, v.x, v.y, v.z)

    def copy(self):
        return Quaternion(*self)

    def magnitude(self):
        return math.hypot(*self)

    def is_unit(self):
        return abs(self.magnitude() - 1) <= UNIT_TOLERANCE

    def normalize(self):
        length = self.magnitude()
        if length == 0:
            self.r = 1.0
            return
        self.r /= length
        self.i /= length
        self.j /= length
        self.k /= length

    def conjugate(self):
        return Quaternion.of(self.r, -self.vector)

    def __mul__(self, q):
        if not isinstance(q, Quaternion):
            return NotImplemented
        v, w = self.vector, q.vector
        return Quaternion.of(self.r * q.r - v.dot(w), self.r * w + q.r * v + v.cross(w))

    @staticmethod
    def from_axis_angle(axis, angle):
        half = finite("angle", angle) / 2
        axis = finite_vector("axis", axis).normalized()
        if axis == Vector3():
            raise ValueError("axis must not be zero")
        return Quaternion.of(math.cos(half), axis * math.sin(half))

    def to_axis_angle(self):
        need_unit("this quaternion", self)
        v = self.vector
        sine = v.magnitude()
        if sine == 0:
            return Vector3(1, 0, 0), 0.0
        if self.r < 0:
            v = -v
        return v / sine, 2 * math.atan2(sine, abs(self.r))

    def rotate(self, v):
        need_unit("this quaternion", self)
        if not isinstance(v, Vector3):
            raise TypeError(f"v must be a Vector3, got {v!r}")
        return (self * Quaternion.of(0, v) * self.conjugate()).vector

    def rotate_by(self, vector):
        angle = finite_vector("vector", vector).magnitude()
        if angle == 0:
            return
        turn = Quaternion.from_axis_angle(vector, angle)
        self.r, self.i, self.j, self.k = turn * self

    def add_scaled(self, vector, scale):
        more = Quaternion.of(0, finite_vector("vector", vector)) * self
        h = finite("scale", scale) / 2
        self.r += more.r * h
        self.i += more.i * h
        self.j += more.j * h
        self.k += more.k * h
