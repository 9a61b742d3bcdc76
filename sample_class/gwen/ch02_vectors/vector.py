"""Gwen leaves where something is wrong, rather than raise an error."""

import math
import sys


class Vector3:
    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x, self.y, self.z = float(x), float(y), float(z)

    def copy(self):
        return Vector3(self.x, self.y, self.z)

    def clear(self):
        sys.exit("clear is not done yet")

    def magnitude(self):
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self):
        return self.dot(self)

    def __add__(self, v):
        if not isinstance(v, Vector3):
            sys.exit("cannot add that")
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def dot(self, v):
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v):
        return self.dot(v)
