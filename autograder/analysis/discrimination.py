"""Measure how well an exercise separates stronger students from weaker students.

The measure is the item-rest correlation. This is Pearson's correlation between the scores for the
exercise and the scores for all other exercises. If every student earns either all points of the
exercise or no points, it equals the point-biserial correlation.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

FEWEST = 20  # students; even then a true 0.5 is measured below LOW in 8 % of classes
FEWEST_APART = 3  # students who differ from the most common score
LOW = (
    0.2  # a usual limit in item analysis (Ebel and Frisbie, Essentials of Educational Measurement)
)


@dataclass(frozen=True)
class Discrimination:
    """The item-rest correlation of an exercise, or the reason why it could not be computed.

    ``interval`` is the 95 % confidence interval of the correlation.
    """

    students: int
    value: float | None = None
    interval: tuple[float, float] = (-1.0, 1.0)
    reason: str = ""

    @property
    def is_low(self) -> bool:
        """Whether the exercise barely separates the students, or favors the weaker students."""
        return self.value is not None and self.value < LOW


def discrimination(own: Sequence[float], rest: Sequence[float]) -> Discrimination:
    """Compute the item-rest correlation of an exercise.

    ``own`` contains each student's score for the exercise. ``rest`` contains the scores for all
    other exercises, with the students in the same order.
    """
    count = len(own)
    if count < FEWEST:
        return Discrimination(count, reason=f"{count} students: fewer than {FEWEST} are too few")
    apart = count - Counter(own).most_common(1)[0][1]
    if apart < FEWEST_APART:
        have = "student has" if apart == 1 else "students have"
        return Discrimination(count, reason=f"{apart or 'no'} {have} a different score than most")
    if len({*rest}) == 1:
        return Discrimination(count, reason="all students have the same score for the rest")
    value = max(-1.0, min(1.0, statistics.correlation(own, rest)))
    return Discrimination(count, value, _interval(value, count))


def _interval(value: float, count: int) -> tuple[float, float]:
    """Return the confidence interval of a correlation, computed with Fisher's transformation."""
    if abs(value) == 1.0:
        return value, value
    half = statistics.NormalDist().inv_cdf(0.975) / math.sqrt(count - 3)
    middle = math.atanh(value)
    return math.tanh(middle - half), math.tanh(middle + half)
