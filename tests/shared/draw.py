"""Random numbers for the checks, drawn from the seed of the run. Vectors are plain tuples."""

from __future__ import annotations

import math
from collections.abc import Iterable
from random import Random

Components = tuple[float, float, float]


class Triple(tuple[float, float, float]):
    """Three numbers with the arithmetic of vectors, for the values that a check expects.

    ``a @ b`` is the scalar product, whose sum is rounded only once, and abs(a) is the length.
    """

    __slots__ = ()

    def __add__(self, other: Components) -> Triple:  # type: ignore[override]
        return Triple(p + q for p, q in zip(self, other, strict=True))

    def __sub__(self, other: Components) -> Triple:
        return Triple(p - q for p, q in zip(self, other, strict=True))

    def __mul__(self, factor: float) -> Triple:  # type: ignore[override]
        return Triple(factor * p for p in self)

    __rmul__ = __mul__  # type: ignore[assignment]

    def __truediv__(self, divisor: float) -> Triple:
        return Triple(p / divisor for p in self)

    def __neg__(self) -> Triple:
        return -1.0 * self

    def __matmul__(self, other: Components) -> float:
        return dot(self, other)

    def __abs__(self) -> float:
        return math.hypot(*self)

    def cross(self, other: Components) -> Triple:
        """Return the vector product."""
        (a, b, c), (d, e, f) = self, other
        return Triple((b * f - c * e, c * d - a * f, a * e - b * d))


def number(rng: Random, low: float = 0.5, high: float = 9.5) -> float:
    """Draw a number of either sign whose size is between low and high, so never close to zero.

    It has three decimals, to keep messages readable.
    """
    return rng.choice((-1.0, 1.0)) * round(rng.uniform(low, high), 3)


def positive_number(rng: Random, low: float = 0.2, high: float = 9.0) -> float:
    """Draw a number between low and high, with three decimals."""
    return round(rng.uniform(low, high), 3)


def vector(rng: Random) -> Triple:
    """Draw three components. Zero would hide mistakes, so each is well away from it."""
    return Triple((number(rng), number(rng), number(rng)))


def unit_vector(rng: Random) -> Triple:
    """Draw a vector whose length is 1 within rounding."""
    drawn = vector(rng)
    return drawn / abs(drawn)


def rounded(a: Iterable[float]) -> str:
    """Show a vector or other numbers with at most 6 digits, where more do not matter."""
    return f"({', '.join(f'{component:.6g}' for component in a)})"


def dot(a: Components, b: Components) -> float:
    """Return the scalar product. The sum is rounded only once."""
    return math.fsum(p * q for p, q in zip(a, b, strict=True))
