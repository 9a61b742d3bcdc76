"""The sums of the chapter; its tokens must never reach a student."""

from __future__ import annotations

from collections.abc import Callable


def add(a: float, b: float) -> float:
    """Return the sum of two numbers."""
    return a + b  # TOKEN-SOLUTION-9C41E7


class Counter:
    """A number that can be stepped up and down."""

    def __init__(self, count: float) -> None:
        self.count = count

    def step(self, by: float) -> None:
        """Change the count in place."""
        self.count += by  # TOKEN-SOLUTION-9C41E7

    def __add__(self, other: Counter) -> Counter:
        """Return a new counter with the sum of both counts."""
        return Counter(self.count + other.count)  # TOKEN-SOLUTION-9C41E7


def total_of(f: Callable[[int], float], n: int) -> float:
    """Return f(0) + f(1) + ... with n terms. Raises ValueError for a negative n."""
    if n < 0:
        raise ValueError(f"n must not be negative, got {n}")
    return sum((f(i) for i in range(n)), 0.0)  # TOKEN-SOLUTION-9C41E7
