"""Estimate the error of a simulation that has no exact solution (Richardson extrapolation).

The simulation is run several times, and the time step is halved each time. If the method has order
p, each halving divides the error by 2^p. Let d be the difference between two successive runs. The
first run has an error of about d, and the second run has an error of about d / (2^p - 1).

This works only if the differences shrink at a steady rate. The error cannot be estimated if bodies
collide or if the motion is chaotic.
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
    """The estimated errors of several runs of a simulation, and the observed orders of convergence.

    The lists start with the run that has the longest time step. If ``is_steady`` is false, the
    orders vary so much that the errors are only guesses. If ``is_exact`` is true, the last runs
    differ only by rounding.
    """

    errors: list[float]
    orders: list[float]
    is_steady: bool = False
    is_exact: bool = False


def halved(
    runs: Sequence[Run | None],
    ratio: float,
    order: float,
    *,
    may_repeat: bool = False,
    may_vary: bool = False,
) -> Halved:
    """Estimate the error of each run of a simulation by comparing the runs with one another.

    All runs simulate the same scene with the same method. From one run to the next, the time step
    is divided by ``ratio``. The error of the last run is estimated from the differences between the
    runs. The error of any other run is this estimate plus the difference from the last run. A
    failed run is given as None. Its error is infinite, and so is the error of every run before it.

    ``order`` is the method's order of convergence in theory. If the observed order is higher, that
    is a coincidence, and the estimate uses ``order``.

    Two equal runs usually mean that both are exact. Set ``may_repeat`` for a method that takes a
    tolerance, because two tolerances can lead to the same time steps. Set ``may_vary`` for such a
    method, too. Its error is proportional to the tolerance only on average, so its orders vary.
    """
    first = max((i + 1 for i, run in enumerate(runs) if run is None), default=0)
    good: list[Run] = [run for run in runs[first:] if run is not None]
    failed = [math.inf] * first
    if len(good) < 2:
        return Halved([*failed, *[math.inf] * len(good)], [])
    least = ROUNDING * max(abs(value) for values in good[-1] for value in values)
    gaps = [distance(a, b) for a, b in pairwise(good)]
    above = [gap for gap in gaps if gap > least]
    orders = [math.log(a / b, ratio) for a, b in pairwise(above)]
    is_exact = len(gaps) > 1 and max(gaps[-2:]) <= least
    is_exact = is_exact and (all(gaps[-2:]) or not may_repeat)
    steady = _is_steady_on_average if may_vary else _is_steady
    is_steady = is_exact or steady(orders, order)
    if is_exact:
        left = least
    elif is_steady and may_vary:
        left = gaps[-1] / (ratio ** min(*orders[-3:], order) - 1.0)
    elif is_steady:
        left = gaps[-1] / (ratio ** min(orders[-1], order) - 1.0)
    else:
        left = max(gaps[-3:]) or math.inf
    errors = [*failed, *(distance(run, good[-1]) + left for run in good)]
    return Halved(errors, orders, is_steady, is_exact)


def _is_steady(orders: Sequence[float], order: float) -> bool:
    """Return True if the observed orders of convergence are steady enough to estimate an error.

    They are steady if the last two are close to the order known from theory. They are also steady
    if the last three are close to each other, or if the last four are no lower than in theory.
    """
    if len(orders) >= 2 and all(abs(seen - order) <= NEAR * order for seen in orders[-2:]):
        return True
    if len(orders) >= 4 and min(orders[-4:]) >= (1.0 - NEAR) * order:
        return True
    last = orders[-3:]
    return len(last) == 3 and min(last) >= LEAST and max(last) - min(last) <= NEAR


def _is_steady_on_average(orders: Sequence[float], order: float) -> bool:
    """Return True if the last three orders show that the error falls as the tolerance does.

    The error must fall every time, and on average at least nearly as fast as in theory.
    """
    last = orders[-3:]
    return len(last) == 3 and min(last) >= SLOW and sum(last) / 3.0 >= LEAST * order


def distance(a: Run, b: Run) -> float:
    """Return the largest difference between two runs, over all measured values and all frames."""
    return max(
        abs(x - y)
        for mine, other in zip(a, b, strict=True)
        for x, y in zip(mine, other, strict=True)
    )
