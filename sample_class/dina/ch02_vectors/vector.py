"""Dina lost a bracket in the length."""

import math


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x, self.y, self.z = float(x), float(y), float(z)

    def magnitude(self):
        return math.sqrt((self.x * self.x + self.y * self.y + self.z * self.z)

    def dot(self, v):
        return self.x * v.x + self.y * v.y + self.z * v.z
