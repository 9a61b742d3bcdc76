"""Estimate the error of a simulation that has no exact solution (Richardson extrapolation).

If the method has order p, halving the time step divides the error by 2^p. Let d be the difference
between two successive runs. Then the second one has an error of about d / (2^p - 1). This works
only if the differences shrink at a steady rate.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

Run = Sequence[Sequence[float]]  # what is measured, for each frame

ROUNDING = 1e-12  # fraction of the measured values below which a difference is rounding
NEAR = 0.3  # orders agree if they differ by at most this (for the expected order, as a fraction)
LEAST = 0.7  # below this order, a model does not converge
SLOW = 0.25  # the same for a single order of a method that takes a tolerance


@dataclass(frozen=True)
class Halved:
    """The estimated errors and observed orders of several runs, from the longest time step on."""

    errors: list[float]
    orders: list[float]
    is_steady: bool = False  # otherwise, the errors are only guesses
    is_exact: bool = False  # the last runs differ only by rounding


def halved(
    runs: Sequence[Run | None],
    ratio: float,
    order: float,
    *,
    may_repeat: bool = False,  # two tolerances can lead to the same steps
    may_vary: bool = False,  # the error is proportional to a tolerance only on average
) -> Halved:
    """Estimate the error of each run by comparing it with runs of the same scene and method.

    The time step is divided by ``ratio`` from run to run. A failed run is None, and its error and
    those of all earlier runs are infinite. An observed order above ``order`` is a coincidence.
    """
    first = max((i + 1 for i, run in enumerate(runs) if run is None), default=0)
    good: list[Run] = [run for run in runs[first:] if run is not None]
    failed = [math.inf] * first
    if len(good) < 2:
        return Halved([math.inf] * len(runs), [])
    least = ROUNDING * max(abs(value) for values in good[-1] for value in values)
    gaps = [distance(a, b) for a, b in pairwise(good)]
    above = [gap for gap in gaps if gap > least]
    orders = [math.log(a / b, ratio) for a, b in pairwise(above)]
    is_exact = len(gaps) > 1 and max(gaps[-2:]) <= least and (all(gaps[-2:]) or not may_repeat)
    steady = _is_steady_on_average if may_vary else _is_steady
    is_steady = is_exact or steady(orders, order)
    if is_exact:
        left = least
    elif is_steady:
        left = gaps[-1] / (ratio ** min(*orders[-3 if may_vary else -1 :], order) - 1.0)
    else:
        left = max(gaps[-3:]) or math.inf
    errors = [*failed, *(distance(run, good[-1]) + left for run in good)]
    return Halved(errors, orders, is_steady, is_exact)


def _is_steady(orders: Sequence[float], order: float) -> bool:
    """Check the last two orders against theory, and the last three or four with each other."""
    if len(orders) >= 2 and all(abs(seen - order) <= NEAR * order for seen in orders[-2:]):
        return True
    if len(orders) >= 4 and min(orders[-4:]) >= (1.0 - NEAR) * order:
        return True
    last = orders[-3:]
    return len(last) == 3 and min(last) >= LEAST and max(last) - min(last) <= NEAR


def _is_steady_on_average(orders: Sequence[float], order: float) -> bool:
    """Check that the last three orders show an error that falls as the tolerance does."""
    last = orders[-3:]
    return len(last) == 3 and min(last) >= SLOW and sum(last) / 3.0 >= LEAST * order


def distance(a: Run, b: Run) -> float:
    """Return the largest difference between two runs, over all measured values and all frames."""
    return max(
        abs(x - y)
        for mine, other in zip(a, b, strict=True)
        for x, y in zip(mine, other, strict=True)
    )
