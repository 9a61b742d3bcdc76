"""Hana's vectors: add_scaled forgets to scale z, and a difference comes out the wrong way round."""

import math


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x = float(x)
        self.y = float(y)
        self.z = float(z)

    def __repr__(self):
        return f"Vector3({self.x}, {self.y}, {self.z})"

    def __iter__(self):
        yield from (self.x, self.y, self.z)

    def __eq__(self, other):
        if not isinstance(other, Vector3):
            return NotImplemented
        return (self.x, self.y, self.z) == (other.x, other.y, other.z)

    def copy(self):
        return Vector3(self.x, self.y, self.z)

    def magnitude(self):
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self):
        return self.x**2 + self.y**2 + self.z**2

    def __mul__(self, scale):
        return Vector3(self.x * scale, self.y * scale, self.z * scale)

    __rmul__ = __mul__

    def __imul__(self, scale):
        self.x *= scale
        self.y *= scale
        self.z *= scale
        return self

    def __add__(self, v):
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __sub__(self, v):
        return Vector3(v.x - self.x, v.y - self.y, v.z - self.z)

    def add_scaled(self, v, scale):
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z
