"""Exact orientations, and measures of what an engine makes of them, without its functions.

They are quaternions r, i, j and k, or three arrows: a body's axes in world coordinates.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion
from scenes.readings import Numbers, angle_between, cross, dot, is_drawable, number, numbers

Components = tuple[float, float, float, float]
Arrows = tuple[Numbers, Numbers, Numbers]
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def components(q: Any) -> Components:
    """Convert an engine's quaternion to four floats. Anything that is not a number becomes NaN."""
    r, i, j, k = (number(getattr(q, name, None)) for name in "rijk")
    return r, i, j, k


def turn(axis: Numbers, angle: float) -> Components:
    """Compute the quaternion of a rotation by ``angle`` about ``axis``, which must not be zero."""
    factor = math.sin(0.5 * angle) / math.hypot(*axis)
    return math.cos(0.5 * angle), axis[0] * factor, axis[1] * factor, axis[2] * factor


def product(b: Components, a: Components) -> Components:
    """Compute the quaternion of the rotation that applies ``a`` first and then ``b``."""
    u, v = b[1:], a[1:]
    i, j, k = (b[0] * q + a[0] * p + c for p, q, c in zip(u, v, cross(u, v), strict=True))
    return b[0] * a[0] - dot(u, v), i, j, k


def inverse(q: Components) -> Components:
    """Compute the inverse of a unit quaternion."""
    return q[0], -q[1], -q[2], -q[3]


def rotated(q: Components, v: Numbers) -> Numbers:
    """Rotate the vector ``v`` by the unit quaternion ``q``."""
    return product(product(q, (0.0, *v)), inverse(q))[1:]


def arrows(q: Components) -> Arrows:
    """Compute where a body's axes X, Y and Z point after the unit quaternion ``q`` rotates it."""
    return rotated(q, X), rotated(q, Y), rotated(q, Z)


def arrows_by_engine(q: Quaternion) -> Arrows:
    """Let the engine rotate the directions of the axes X, Y and Z by ``q``."""
    x, y, z = (numbers(q.rotate(Vector3(*axis))) for axis in (X, Y, Z))
    return x, y, z


def entries(matrix: Any) -> list[float]:
    """Return the entries of an engine's Matrix3 row by row, or nine NaNs if there are not nine."""
    found = [number(entry) for entry in getattr(matrix, "entries", ())]
    return found if len(found) == 9 else [math.nan] * 9


def degrees_apart(a: Components, b: Components) -> float:
    """Compute the angle between two orientations, or NaN if a length is 0 or not finite."""
    if not (0.0 < math.hypot(*a) < math.inf and 0.0 < math.hypot(*b) < math.inf):
        return math.nan
    r, *axis = product(b, inverse(a))
    return math.degrees(2.0 * math.atan2(math.hypot(*axis), abs(r)))


def degrees_between_arrows(a: Arrows, b: Arrows) -> float:
    """Compute the angle between two orientations, or NaN if they are not finite."""
    if not is_drawable(*a, *b):
        return math.nan
    cosine = 0.5 * (math.fsum(dot(p, q) for p, q in zip(a, b, strict=True)) - 1.0)
    return math.degrees(math.acos(min(max(cosine, -1.0), 1.0)))


def off_right_angles(found: Arrows) -> float:
    """Find the largest deviation of the angle between two rotated axes from 90 degrees."""
    x, y, z = found
    return largest([abs(angle_between(a, b) - 90.0) for a, b in ((x, y), (y, z), (z, x))])


def off_unit_length(found: Arrows) -> float:
    """Find the largest difference between the length of a rotated axis and 1."""
    return largest([abs(math.hypot(*v) - 1.0) for v in found])


def off_directions(found: Arrows, wanted: Arrows) -> float:
    """Return the largest angle in degrees between a rotated axis and its correct direction."""
    return largest([angle_between(a, b) for a, b in zip(found, wanted, strict=True)])


def largest(values: Sequence[float]) -> float:
    """Return the largest of several errors, or NaN if there are none or if one of them is NaN."""
    return max(values, default=math.nan) if not any(map(math.isnan, values)) else math.nan
