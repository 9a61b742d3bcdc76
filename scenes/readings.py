"""Read floats and vectors from a student's engine, which may be wrong or unfinished."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

Numbers = tuple[float, float, float]
Key = TypeVar("Key")
Found = TypeVar("Found")
Other = TypeVar("Other")


def is_written(call: Callable[[], object]) -> bool:
    """Return False if ``call`` needs a function that a student has not written yet."""
    try:
        call()
    except NotImplementedError:
        return False
    return True


def tried(call: Callable[[], Found], failed: Other) -> tuple[Found | Other, str]:
    """Return a result and "", or ``failed`` and the message of any arithmetic or value error."""
    try:
        return call(), ""
    except (ArithmeticError, ValueError) as error:
        return failed, f"{type(error).__name__}: {error}"


def stopped(act: Callable[[], object]) -> str:
    """Run part of a simulation, and return the message of any arithmetic or value error, or ""."""
    return tried(act, None)[1]


def written(scenes: dict[Key, Callable[[], Found]]) -> dict[Key, Found]:
    """Run the simulations that are written. Raise NotImplementedError if all of them are stubs."""
    found: dict[Key, Found] = {}
    stub: NotImplementedError | None = None
    for key, scene in scenes.items():
        try:
            found[key] = scene()
        except NotImplementedError as error:
            stub = stub or error
    if stub is not None and not found:
        raise stub
    return found


def numbers(v: Any) -> Numbers:
    """Convert a vector of a student's engine to floats. What is not a number becomes NaN."""
    x, y, z = (number(getattr(v, axis, None)) for axis in "xyz")
    return x, y, z


def number(value: Any) -> float:
    """Convert ``value`` to a float, or to NaN if it is not a number."""
    try:
        return float(value)
    except (TypeError, ValueError):
        return math.nan


def dot(a: Numbers, b: Numbers) -> float:
    """Compute the scalar product of two tuples of floats."""
    return math.fsum(p * q for p, q in zip(a, b, strict=True))


def cross(a: Numbers, b: Numbers) -> Numbers:
    """Compute the vector product of two tuples of floats."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def angle_between(a: Numbers, b: Numbers) -> float:
    """Compute the angle between two vectors in degrees, or NaN if one of them is zero."""
    if not math.hypot(*a) * math.hypot(*b) > 0.0:
        return math.nan
    return math.degrees(math.atan2(math.hypot(*cross(a, b)), dot(a, b)))


def is_drawable(*vectors: Numbers) -> bool:
    """Return True if all components of the vectors are finite, so that matplotlib can draw them."""
    return all(math.isfinite(value) for vector in vectors for value in vector)
