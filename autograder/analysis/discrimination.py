"""Measure how well an exercise separates stronger students from weaker ones.

The usual measure is the item-rest correlation. This is Pearson's correlation between the scores on
one exercise and the total scores on all the others. If all scores on the exercise are either zero
or full, it equals the point-biserial correlation.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

FEWEST = 20  # students; even in so large a class, a true 0.5 comes out below LOW in 8 % of cases
FEWEST_APART = 3  # at least this many students must have another score than most
LOW = (
    0.2  # a usual limit in item analysis (Ebel and Frisbie, Essentials of Educational Measurement)
)


@dataclass(frozen=True)
class Discrimination:
    """How well an exercise separates stronger students from weaker ones.

    Attributes:
        value: The item-rest correlation between the scores on this exercise and those on all the
            others. None if it is undefined.
        interval: The 95 % confidence interval of the correlation.
        reason: Why the correlation is undefined, if it is.
    """

    students: int
    value: float | None = None
    interval: tuple[float, float] = (-1.0, 1.0)
    reason: str = ""

    @property
    def is_low(self) -> bool:
        """True if strong students score little better on this exercise than weak students.

        Students count as strong if they do well on all the other exercises. Such an exercise may be
        unclear, or it may test a different skill.
        """
        return self.value is not None and self.value < LOW


def discrimination(own: Sequence[float], rest: Sequence[float]) -> Discrimination:
    """Compute the item-rest correlation, which shows how well an exercise separates students.

    ``own`` contains the scores of all students on this exercise. ``rest`` contains their total
    scores on all other exercises, in the same order.
    """
    count = len(own)
    if count < FEWEST:
        return Discrimination(
            count, reason=f"{count} students, which is fewer than the {FEWEST} needed"
        )
    apart = count - Counter(own).most_common(1)[0][1]
    if apart < FEWEST_APART:
        have = "student has" if apart == 1 else "students have"
        return Discrimination(count, reason=f"{apart or 'no'} {have} a different score than most")
    if len({*rest}) == 1:
        return Discrimination(
            count, reason="all students have the same score on the other exercises"
        )
    value = max(-1.0, min(1.0, statistics.correlation(own, rest)))
    return Discrimination(count, value, _interval(value, count))


def _interval(value: float, count: int) -> tuple[float, float]:
    """Compute the 95 % confidence interval of a correlation by Fisher's z-transformation.

    ``count`` is the number of students.
    """
    if abs(value) == 1.0:
        return value, value
    half = statistics.NormalDist().inv_cdf(0.975) / math.sqrt(count - 3)
    middle = math.atanh(value)
    return math.tanh(middle - half), math.tanh(middle + half)
