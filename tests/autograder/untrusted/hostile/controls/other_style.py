"""An honest submission with type hints, a dataclass, a loop and an error of its own.

earns: all
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


class NegativeError(ValueError):
    """There is no sum of a negative number of terms."""


@dataclass
class Counter:
    count: float = 0.0

    def step(self, by: float) -> None:
        self.count = self.count + by

    def __add__(self, other: Counter) -> Counter:
        if not isinstance(other, Counter):
            return NotImplemented
        return Counter(self.count + other.count)


def add(a: float, b: float) -> float:
    result = a
    result += b
    return result


def total_of(f: Callable[[int], float], n: int) -> float:
    if n < 0:
        raise NegativeError(f"n is {n}")
    total = 0.0
    i = 0
    while i < n:
        total += f(i)
        i += 1
    return total
