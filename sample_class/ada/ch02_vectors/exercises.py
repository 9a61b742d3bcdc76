"""A second right solution of the chapter's exercises, in another style than the first.

It uses the public names of Vector3 alone, so it runs with any right vector module.
"""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3

_TOLERANCE = 1e-6
_ANGLE_WORDS = {-1: "obtuse", 0: "right", 1: "acute"}


def split(v: Vector3) -> tuple[float, Vector3]:
    direction = v.copy()
    direction.normalize()
    return v.magnitude(), direction


def scalar_product_and_angle(a: Vector3, b: Vector3) -> tuple[float, str]:
    product = a @ b
    if math.isnan(product):
        raise ValueError("the scalar product of a and b is NaN, and says nothing of their angle")
    sign = (product > 0) - (product < 0)
    return product, _ANGLE_WORDS[sign]


def make_perpendicular(a: Vector3, x: float, y: float) -> float:
    if not a.z:
        raise ValueError("a.z must not be zero: no z changes the scalar product")
    return (a.y * y + a.x * x) / -a.z


def angle_by_scalar_product(a: Vector3, b: Vector3) -> float:
    _require_direction("a", a)
    _require_direction("b", b)
    cosine = max(min(a.normalized() @ b.normalized(), 1.0), -1.0)  # in this order NaN stays NaN
    return math.atan2(_other_leg(cosine), cosine)


def angles_by_vector_product(a: Vector3, b: Vector3) -> tuple[float, float]:
    _require_direction("a", a)
    _require_direction("b", b)
    sine = min(a.normalized().cross(b.normalized()).magnitude(), 1.0)  # NaN stays NaN
    acute = math.atan2(sine, _other_leg(sine))
    return acute, math.pi - acute


def remove_projection(a: Vector3, b: Vector3) -> tuple[float, Vector3, float]:
    for name, v in (("a", a), ("b", b)):
        if not math.isclose(v.magnitude(), 1.0, rel_tol=0.0, abs_tol=_TOLERANCE):
            raise ValueError(f"{name} must be a unit vector, not {v}")
    c = a @ b
    d = b - c * a
    if d.magnitude() < _TOLERANCE:
        raise ValueError("a and b are parallel: nothing is left of b")
    return c, d, math.atan2(a.cross(d).magnitude(), a @ d)


def checked_duration(duration: float) -> float:
    if isinstance(duration, str) or not hasattr(duration, "__float__"):
        raise TypeError(f"duration should be a number, not {duration!r}")
    seconds = float(duration)
    if not math.isfinite(seconds) or seconds <= 0:
        raise ValueError(f"duration is {duration!r} s, but has to be finite and above 0")
    return seconds


def position_after(position: Vector3, velocity: Vector3, duration: float) -> Vector3:
    if not 0 < duration < math.inf:
        raise ValueError(f"duration must be positive and finite, not {duration}")
    return duration * velocity + position


def _other_leg(leg: float) -> float:
    """Return the other leg of a right triangle with hypotenuse 1: a cosine's sine, or back."""
    return math.sqrt((1.0 - leg) * (1.0 + leg))


def _require_direction(name: str, v: Vector3) -> None:
    """Raise ValueError where the argument of that name is zero."""
    if not any(v):
        raise ValueError(f"{name} is zero and has no direction")
