"""What must run beside the student's code: lists that cross as copies, and numbers that count."""

from __future__ import annotations

from ch09_rotations.exercises import (
    balance_offset,
    center_of_stones,
    masses_beside,
    product_without_j_and_k,
)
from ch09_rotations.quaternion import Quaternion

Stones = list[tuple[str, float, float, float]]


class Counted(float):
    """A number that counts how often one like it is multiplied."""

    made = 0

    def __mul__(self, other: float) -> float:
        Counted.made += 1
        return float(self) * float(other)

    __rmul__ = __mul__


def multiplications(a: tuple[float, float], b: tuple[float, float]) -> int:
    """Return how many multiplications product_without_j_and_k makes of two numbers each."""
    first, second = Quaternion(), Quaternion()
    for q, (r, i) in ((first, a), (second, b)):
        q.r, q.i, q.j, q.k = (Counted(part) for part in (r, i, 0.0, 0.0))
    Counted.made = 0
    product_without_j_and_k(first, second)
    return Counted.made


def stones_after(name: str, stones: Stones) -> tuple[object, Stones]:
    """Return what a function of exercise 9.7 returns, and has left of the list it was given."""
    stones = [*stones]
    if name == "center_of_stones":
        return center_of_stones(stones), stones
    if name == "balance_offset":
        return balance_offset(stones, 0.3), stones
    return masses_beside(stones, 0.3), stones
