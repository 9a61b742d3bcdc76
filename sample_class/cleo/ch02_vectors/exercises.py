"""Cleo's exercises: angles in degrees, and a sign lost in 2.4."""

import math


def split(v):
    direction = v.copy()
    direction.normalize()
    return v.magnitude(), direction


def scalar_product_and_angle(a, b):
    product = a.dot(b)
    if product >= 0:
        return product, "acute"
    return product, "obtuse"


def make_perpendicular(a, x, y):
    if a.z == 0:
        raise ValueError("no z will do")
    return (a.x * x + a.y * y) / a.z


def angle_by_scalar_product(a, b):
    return math.degrees(math.acos(a.dot(b) / (a.magnitude() * b.magnitude())))


def angles_by_vector_product(a, b):
    angle = math.asin(a.cross(b).magnitude() / (a.magnitude() * b.magnitude()))
    return angle, math.pi - angle


def remove_projection(a, b):
    c = a.dot(b)
    d = b - a * c
    return c, d, math.pi / 2


def position_after(position, velocity, duration):
    return position + duration * velocity
