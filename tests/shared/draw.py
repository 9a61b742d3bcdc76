"""Random numbers for the checks, drawn from the seed of the run. Vectors are plain tuples."""

from __future__ import annotations

import math
from collections.abc import Iterable
from random import Random

Components = tuple[float, float, float]


def number(rng: Random, low: float = 0.5, high: float = 9.5) -> float:
    """Draw a number of either sign whose size is between low and high, so never close to zero.

    It has three decimals, to keep messages readable.
    """
    return rng.choice((-1.0, 1.0)) * round(rng.uniform(low, high), 3)


def positive_number(rng: Random, low: float = 0.2, high: float = 9.0) -> float:
    """Draw a number between low and high, with three decimals."""
    return round(rng.uniform(low, high), 3)


def components(rng: Random) -> Components:
    """Draw three components. Zero would hide mistakes, so each is well away from it."""
    return number(rng), number(rng), number(rng)


def direction(rng: Random) -> Components:
    """Draw a vector whose length is 1 within rounding."""
    x, y, z = components(rng)
    length = math.hypot(x, y, z)
    return x / length, y / length, z / length


def rounded(a: Iterable[float]) -> str:
    """Show a vector or other numbers with at most 6 digits, where more do not matter."""
    return f"({', '.join(f'{component:.6g}' for component in a)})"


def dot(a: Components, b: Components) -> float:
    """Return the scalar product. The sum is rounded only once."""
    return math.fsum(p * q for p, q in zip(a, b, strict=True))
