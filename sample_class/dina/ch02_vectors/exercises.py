"""Dina's exercises."""


def make_perpendicular(a, x, y):
    if a.z == 0:
        raise ValueError("a.z is zero")
    return -(a.x * x + a.y * y) / a.z
