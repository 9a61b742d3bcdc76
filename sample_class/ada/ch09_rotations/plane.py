"""Angles, directions and points in the plane, by complex numbers, and the center of mass (9.1)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle: float) -> float:
    wrapped = cmath.phase(_direction(angle))
    return math.pi if wrapped == -math.pi else wrapped


def angle_to_vector(angle: float) -> Point:
    return _pair(_direction(angle))


def rotate_point(point: Point, angle: float, origin: Point) -> Point:
    return _pair(_number("point", point) * _direction(angle) + _number("origin", origin))


def center_of_mass(masses: Sequence[float], positions: Sequence[Point]) -> Point:
    if len(masses) == 0 or len(masses) != len(positions):
        raise ValueError(f"got {len(masses)} masses and {len(positions)} positions")
    weights = [positive("masses", mass) for mass in masses]
    places = [_number("positions", position) for position in positions]
    largest = max(weights)  # a sum of masses might fit in no float
    shares = [weight / largest for weight in weights]
    whole = sum(shares)
    return _pair(
        sum((place * (share / whole) for place, share in zip(places, shares, strict=True)), 0j)
    )


def _direction(angle: float) -> complex:
    return cmath.rect(1.0, finite("angle", angle))


def _number(name: str, point: Point) -> complex:
    x, y = point
    return complex(finite(name, x), finite(name, y))


def _pair(number: complex) -> Point:
    return number.real, number.imag
