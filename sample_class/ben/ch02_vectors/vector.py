"""Ben got as far as the component product."""

import math


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x = float(x)
        self.y = float(y)
        self.z = float(z)

    def copy(self):
        return Vector3(self.x, self.y, self.z)

    def clear(self):
        self.x = 0.0
        self.y = 0.0
        self.z = 0.0

    def invert(self):
        self.x *= -1
        self.y *= -1
        self.z *= -1

    def __neg__(self):
        return Vector3(-self.x, -self.y, -self.z)

    def magnitude(self):
        return math.sqrt(self.squared_magnitude())

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

    def __truediv__(self, divisor):
        return self * (1 / divisor)

    def __itruediv__(self, divisor):
        self *= 1 / divisor
        return self

    def normalize(self):
        length = self.magnitude()
        if length > 0:
            self *= 1 / length

    def normalized(self):
        v = self.copy()
        v.normalize()
        return v

    def __add__(self, v):
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __iadd__(self, v):
        return self + v

    def __sub__(self, v):
        return Vector3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __isub__(self, v):
        return self - v

    def add_scaled(self, v, scale):
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def component_product(self, v):
        return Vector3(self.x * v.x, self.y * v.y, self.z * v.z)

    def component_product_update(self, v):
        raise NotImplementedError("Exercise B2.7: The component product")

    def dot(self, v):
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def __matmul__(self, v):
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def cross(self, v):
        raise NotImplementedError("Exercise B2.9: The vector product")

    def cross_update(self, v):
        raise NotImplementedError("Exercise B2.9: The vector product")


def make_orthonormal_basis(a, b):
    raise NotImplementedError("Exercise B2.10: An orthonormal basis")
