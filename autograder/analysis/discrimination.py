"""Measure how well an exercise separates stronger students from weaker ones.

The usual measure is the item-rest correlation. This is Pearson's correlation between the scores on
one exercise and the total scores on all the others.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

FEWEST = 20  # students; even in so large a class, a true 0.5 comes out below LOW in 8 % of cases
FEWEST_APART = 3  # at least this many students must have another score than most
MOST = 1.0 - 1e-12  # the transform of 1 is infinite
LOW = 0.2  # a usual limit (Ebel and Frisbie, Essentials of Educational Measurement)


@dataclass(frozen=True)
class Discrimination:
    """The item-rest correlation of an exercise, or the reason why it is undefined."""

    value: float | None = None
    interval: tuple[float, float] = (-1.0, 1.0)  # contains it with a probability of 95 %
    reason: str = ""

    @property
    def is_low(self) -> bool:
        """True if students who do well elsewhere score little better here than the others."""
        return self.value is not None and self.value < LOW


def discrimination(own: Sequence[float], rest: Sequence[float]) -> Discrimination:
    """Correlate the students' scores on an exercise with their totals on all other exercises."""
    count = len(own)
    if count < FEWEST:
        reason = f"{count} students, which is fewer than the {FEWEST} needed"
        return Discrimination(reason=reason)
    apart = count - Counter(own).most_common(1)[0][1]
    if apart < FEWEST_APART:
        have = "student has" if apart == 1 else "students have"
        return Discrimination(reason=f"{apart or 'no'} {have} a different score than most")
    if len({*rest}) == 1:
        return Discrimination(reason="all students have the same score on the other exercises")
    value = statistics.correlation(own, rest)
    half = statistics.NormalDist().inv_cdf(0.975) / math.sqrt(count - 3)  # Fisher's z-transform
    middle = math.atanh(max(-MOST, min(MOST, value)))
    return Discrimination(value, (math.tanh(middle - half), math.tanh(middle + half)))
