"""Check arguments, and reject invalid values with an error that names the argument.

Each function returns the value if it is valid. Most numbers are converted to floats, and vectors
are copied. If the value is invalid, the function raises ValueError, or TypeError if the type is
wrong. The message contains the name and the value of the argument.

NaN needs special care, because every comparison with it is False. That is why each function tests
for valid values and rejects everything else.

This file is complete, and you do not hand it in. If you need more functions, write them in the
files that you edit.
"""

from __future__ import annotations

import math
import sys
from typing import TYPE_CHECKING, TypeVar

# Only editors and type checkers run this import, so vector.py itself can import this file.
if TYPE_CHECKING:
    from ch02_vectors.vector import Vector3

Value = TypeVar("Value")
LARGEST = sys.float_info.max  # a larger int does not fit in a float


def finite(name: str, value: float) -> float:
    """Return ``value`` as a float, or raise an error if it is infinite or NaN."""
    if not (isinstance(value, (int, float)) and -LARGEST <= value <= LARGEST):
        raise _refusal(name, value, "finite")
    return float(value)


def not_negative(name: str, value: float) -> float:
    """Return ``value`` as a float, or raise an error unless it is finite and at least 0."""
    if not (isinstance(value, (int, float)) and 0.0 <= value <= LARGEST):
        raise _refusal(name, value, "finite and not negative")
    return float(value)


def positive(name: str, value: float) -> float:
    """Return ``value`` as a float, or raise an error unless it is finite and greater than 0."""
    if not (isinstance(value, (int, float)) and 0.0 < value <= LARGEST):
        raise _refusal(name, value, "positive and finite")
    return float(value)


def positive_or_infinite(name: str, value: float) -> float:
    """Return ``value`` as a float, or raise an error unless it is positive. Infinity is allowed."""
    if not (isinstance(value, (int, float)) and (0.0 < value <= LARGEST or value == math.inf)):
        raise _refusal(name, value, "positive")
    return float(value)


def whole(name: str, value: int) -> int:
    """Return ``value``, or raise an error unless it is an int of at least 1.

    True and False are rejected.
    """
    if not isinstance(value, int) or isinstance(value, bool):
        raise TypeError(f"{name} must be a whole number, got {value!r}")
    if value < 1:
        raise ValueError(f"{name} must be 1 or more, got {value!r}")
    return value


def finite_vector(name: str, v: Vector3) -> Vector3:
    """Return a copy of ``v``, or raise an error unless all of its components are finite."""
    if not all(hasattr(v, component) for component in ("x", "y", "z")):
        raise TypeError(f"{name} must be a Vector3, got {v!r}")
    if not (math.isfinite(v.x) and math.isfinite(v.y) and math.isfinite(v.z)):
        raise ValueError(f"{name} must have finite components, got {v!r}")
    return v.copy()


def instance_of(name: str, value: Value, kind: type) -> Value:
    """Return ``value``, or raise TypeError unless it is an instance of the class ``kind``."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a {kind.__name__}, got {value!r}")
    return value


def _refusal(name: str, value: object, wanted: str) -> Exception:
    if not isinstance(value, (int, float)):
        return TypeError(f"{name} must be a number, got {value!r}")
    return ValueError(f"{name} must be {wanted}, got {value!r}")
