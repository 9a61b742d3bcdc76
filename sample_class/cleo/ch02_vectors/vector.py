"""Cleo's vectors: invert and cross as misread from the book."""

import math


def need_vector(v):
    if not isinstance(v, Vector3):
        raise TypeError(f"expected a Vector3, got {v!r}")


def need_number(value):
    if isinstance(value, Vector3):
        raise TypeError("expected a number; for vectors use dot, cross or component_product")


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x, self.y, self.z = float(x), float(y), float(z)

    def __repr__(self):
        return f"Vector3({self.x}, {self.y}, {self.z})"

    def __iter__(self):
        return iter((self.x, self.y, self.z))

    def __eq__(self, other):
        return isinstance(other, Vector3) and tuple(self) == tuple(other)

    def set(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def copy(self):
        return Vector3(*self)

    def clear(self):
        self.set(0.0, 0.0, 0.0)

    def invert(self):
        self.set(-self.z, -self.y, -self.z)

    def __neg__(self):
        return -1.0 * self

    def magnitude(self):
        return math.hypot(*self)

    def squared_magnitude(self):
        return sum(n * n for n in self)

    def __mul__(self, scale):
        need_number(scale)
        return Vector3(*(n * scale for n in self))

    __rmul__ = __mul__

    def __imul__(self, scale):
        self.set(*(self * scale))
        return self

    def __truediv__(self, divisor):
        need_number(divisor)
        return Vector3(*(n / divisor for n in self))

    def __itruediv__(self, divisor):
        self.set(*(self / divisor))
        return self

    def normalized(self):
        return self / self.magnitude()

    def normalize(self):
        self.set(*self.normalized())

    def __add__(self, v):
        need_vector(v)
        return Vector3(*(a + b for a, b in zip(self, v)))

    def __iadd__(self, v):
        self.set(*(self + v))
        return self

    def __sub__(self, v):
        need_vector(v)
        return self + -v

    def __isub__(self, v):
        self.set(*(self - v))
        return self

    def add_scaled(self, v, scale):
        self.set(*(self + v * scale))

    def component_product(self, v):
        return Vector3(*(a * b for a, b in zip(self, v)))

    def component_product_update(self, v):
        self.set(*self.component_product(v))

    def dot(self, v):
        need_vector(v)
        return sum(a * b for a, b in zip(self, v))

    __matmul__ = dot

    def cross(self, v):
        (a, b, c), (d, e, f) = self, v
        return Vector3(b * f - c * e, a * f - c * d, a * e - b * d)

    def cross_update(self, v):
        self.set(*self.cross(v))


def make_orthonormal_basis(a, b):
    a = a.normalized()
    c = a.cross(b.normalized())
    if c.magnitude() > 1e-10:
        c.normalize()
        return a, c.cross(a), c
    raise ValueError(f"{a} and {b} span no plane")
