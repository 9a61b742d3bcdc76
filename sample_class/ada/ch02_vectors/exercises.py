"""Ada's exercises."""

import math

from ch02_vectors.vector import Vector3


def split(v):
    return v.magnitude(), v.normalized()


def scalar_product_and_angle(a, b):
    product = a @ b
    if product != product:
        raise ValueError("the product is NaN")
    word = "right" if product == 0 else "acute" if product > 0 else "obtuse"
    return product, word


def make_perpendicular(a, x, y):
    if a.z == 0:
        raise ValueError(f"a.z is zero in {a}")
    return -(a.x * x + a.y * y) / a.z


def unit(v):
    if v == Vector3():
        raise ValueError("a zero vector has no direction")
    return v.normalized()


def angle_by_scalar_product(a, b):
    return math.acos(max(min(unit(a) @ unit(b), 1.0), -1.0))


def angles_by_vector_product(a, b):
    angle = math.asin(min(unit(a).cross(unit(b)).magnitude(), 1.0))
    return angle, math.pi - angle


def remove_projection(a, b):
    if not math.isclose(a.magnitude(), 1, rel_tol=1e-6):
        raise ValueError(f"a is not a unit vector: {a}")
    if not math.isclose(b.magnitude(), 1, rel_tol=1e-6):
        raise ValueError(f"b is not a unit vector: {b}")
    c = a @ b
    d = b - c * a
    if d.magnitude() < 1e-6:
        raise ValueError("nothing is left")
    return c, d, angle_by_scalar_product(a, d)


def checked_duration(duration):
    if not isinstance(duration, (int, float)):
        raise TypeError(f"duration must be a number: {duration!r}")
    if duration > 0 and duration != math.inf:
        return float(duration)
    raise ValueError(f"duration must be above 0 and finite: {duration!r}")


def position_after(position, velocity, duration):
    return position + velocity * checked_duration(duration)
