"""Two things timed in turn, shuffled, in one run on one machine, as a ratio.

A ratio holds on any machine; seconds do not. It is the median of the rounds' ratios, and the spread
is between their quartiles.
"""

from __future__ import annotations

import random
import statistics
import sys
import timeit
from collections.abc import Callable
from dataclasses import dataclass

from rich.progress import track

Timer = Callable[[], float]


@dataclass(frozen=True)
class Line:
    """A line of the report: how much faster, or slower, one thing is than another."""

    what: str
    ratio: float
    low: float
    high: float
    target: str


def timer(run: Callable[[], object], times: int = 1) -> Timer:
    """Return what times so many runs, in seconds."""
    return lambda: timeit.timeit(run, number=times)


def ratio(first: Timer, second: Timer, rounds: int, title: str) -> tuple[float, float, float]:
    """Return the median of first / second and its quartiles, timed in turn in shuffled order."""
    pairs = []
    for _ in track(range(rounds), title, transient=True, disable=not sys.stdout.isatty()):
        order = [0, 1]
        random.shuffle(order)
        times = [0.0, 0.0]
        for which in order:
            times[which] = (first, second)[which]()
        pairs.append(times)
    ratios = sorted(a / b for a, b in pairs)
    return statistics.median(ratios), ratios[len(ratios) // 4], ratios[(3 * len(ratios)) // 4]
