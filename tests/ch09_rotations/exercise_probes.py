"""Helpers that must run beside the student's code: numbers that count, and lists."""

from __future__ import annotations

from ch09_rotations import exercises
from ch09_rotations.quaternion import Quaternion

Stones = list[tuple[str, float, float, float]]


class Counted(float):
    """A number that counts the multiplications of all numbers of this class."""

    made = 0

    def __mul__(self, other: float) -> float:
        Counted.made += 1
        return float(self) * float(other)

    __rmul__ = __mul__


def multiplications(a: tuple[float, float], b: tuple[float, float]) -> int:
    """Return the number of multiplications in product_without_j_and_k."""
    first, second = Quaternion(), Quaternion()
    for q, (r, i) in ((first, a), (second, b)):
        q.r, q.i, q.j, q.k = (Counted(part) for part in (r, i, 0.0, 0.0))
    Counted.made = 0
    exercises.product_without_j_and_k(first, second)
    return Counted.made


def stones_after(name: str, stones: Stones) -> tuple[object, Stones]:
    """Return the result of a function of exercise 9.7, and its list after the call."""
    stones = [*stones]
    angle = () if name == "center_of_stones" else (0.3,)
    return getattr(exercises, name)(stones, *angle), stones
