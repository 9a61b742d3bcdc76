"""Cleo's vectors, with invert as the book prints it and a sign lost in the vector product."""

import math


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x = float(x)
        self.y = float(y)
        self.z = float(z)

    def copy(self):
        return Vector3(self.x, self.y, self.z)

    def clear(self):
        self *= 0.0

    def invert(self):
        self.x = -self.x
        self.y = -self.y
        self.x = -self.z

    def __neg__(self):
        v = self.copy()
        v.invert()
        return v

    def squared_magnitude(self):
        return self.dot(self)

    def magnitude(self):
        return self.squared_magnitude() ** 0.5

    def __imul__(self, scale):
        if isinstance(scale, Vector3):
            raise TypeError("*= is for numbers")
        self.x *= scale
        self.y *= scale
        self.z *= scale
        return self

    def __mul__(self, scale):
        v = self.copy()
        v *= scale
        return v

    __rmul__ = __mul__

    def __itruediv__(self, divisor):
        self *= 1.0 / divisor
        return self

    def __truediv__(self, divisor):
        return self * (1.0 / divisor)

    def normalize(self):
        self /= self.magnitude()

    def normalized(self):
        v = self.copy()
        v.normalize()
        return v

    def add_scaled(self, v, scale):
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def __iadd__(self, v):
        self.add_scaled(v, 1.0)
        return self

    def __isub__(self, v):
        self.add_scaled(v, -1.0)
        return self

    def __add__(self, v):
        w = self.copy()
        w += v
        return w

    def __sub__(self, v):
        w = self.copy()
        w -= v
        return w

    def component_product_update(self, v):
        self.x *= v.x
        self.y *= v.y
        self.z *= v.z

    def component_product(self, v):
        w = self.copy()
        w.component_product_update(v)
        return w

    def dot(self, v):
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v):
        return self.dot(v)

    def cross(self, v):
        x = self.y * v.z - self.z * v.y
        y = self.x * v.z - self.z * v.x
        z = self.x * v.y - self.y * v.x
        return Vector3(x, y, z)

    def cross_update(self, v):
        w = self.cross(v)
        self.x, self.y, self.z = w.x, w.y, w.z


def make_orthonormal_basis(a, b):
    a.normalize()
    c = a.cross(b)
    if c.magnitude() == 0:
        raise ValueError("a and b are parallel")
    c.normalize()
    return a, c.cross(a), c
