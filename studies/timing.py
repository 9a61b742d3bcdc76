"""Two things timed in turn, shuffled, in one run on one machine, as a ratio.

A ratio of two medians holds on any machine; seconds do not. The spread is that of the ratios
between the quartiles of the rounds.
"""

from __future__ import annotations

import random
import statistics
import sys
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


def ratio(first: Timer, second: Timer, rounds: int, title: str) -> tuple[float, float, float]:
    """Time two things in turn, in shuffled order, and return first / second and its quartiles."""
    pairs = []
    for _ in track(range(rounds), title, transient=True, disable=not sys.stdout.isatty()):
        order = [0, 1]
        random.shuffle(order)
        times = [0.0, 0.0]
        for which in order:
            times[which] = (first, second)[which]()
        pairs.append(times)
    ratios = sorted(a / b for a, b in pairs)
    middle = statistics.median(a for a, _ in pairs) / statistics.median(b for _, b in pairs)
    return middle, ratios[len(ratios) // 4], ratios[(3 * len(ratios)) // 4]
