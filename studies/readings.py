"""Read numbers and vectors from an engine that may be wrong or unfinished.

Vectors come back as tuples of plain numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

Numbers = tuple[float, float, float]
Key = TypeVar("Key")
Found = TypeVar("Found")


def is_written(call: Callable[[], object]) -> bool:
    """Return whether the student has written all the engine code that ``call`` runs."""
    try:
        call()
    except NotImplementedError:
        return False
    return True


def stopped(act: Callable[[], object]) -> str:
    """Run ``act``, and return the text of the error that stopped it.

    If the engine raised no error, return an empty string.
    """
    try:
        act()
    except (ArithmeticError, ValueError) as error:
        return f"{type(error).__name__}: {error}"
    return ""


def written(scenes: dict[Key, Callable[[], Found]]) -> dict[Key, Found]:
    """Run the scenes whose engine code has been written, and return their results by key.

    Raises:
        NotImplementedError: Every scene needs code that is not written yet.
    """
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
    """Return the components of an engine's vector, with NaN for any that is not a number.

    A component that is not a number then leaves a gap in a plot, and the plot is still drawn.
    """
    return (
        number(getattr(v, "x", None)),
        number(getattr(v, "y", None)),
        number(getattr(v, "z", None)),
    )


def number(value: Any) -> float:
    """Convert ``value`` to a float, or to NaN if it is not a number."""
    try:
        return float(value)
    except (TypeError, ValueError):
        return math.nan


def dot(a: Numbers, b: Numbers) -> float:
    """Return the scalar product of plain numbers, computed without the engine."""
    return math.fsum(p * q for p, q in zip(a, b, strict=True))


def cross(a: Numbers, b: Numbers) -> Numbers:
    """Return the vector product of plain numbers, computed without the engine."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def angle_between(a: Numbers, b: Numbers) -> float:
    """Return the angle between ``a`` and ``b`` in degrees, or NaN if either of them is zero."""
    if not math.hypot(*a) * math.hypot(*b) > 0.0:
        return math.nan
    return math.degrees(math.atan2(math.hypot(*cross(a, b)), dot(a, b)))


def is_drawable(*vectors: Numbers) -> bool:
    """Return whether all components of these vectors are finite numbers."""
    return all(math.isfinite(value) for vector in vectors for value in vector)
