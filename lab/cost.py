"""Measure the time that a scene takes per frame, even if the clock is coarse.

Some browsers round their clocks to a millisecond, and most frames take less. The sum over many
frames is still right on average if they start at random moments. A page asks for them in a steady
rhythm, so each measurement begins with a random delay of less than one tick of the clock.
"""

from __future__ import annotations

import random
import statistics
import time
from collections import deque
from collections.abc import Callable
from functools import lru_cache

LEAST_TICKS = 25  # per mean; the sum over short frames then has a standard deviation of a fifth
LEAST_FRAMES = 60  # per mean: one second, because some frames do not contain a step
MEANS = 9  # the number of recent means of which the median is shown

clock = time.perf_counter


@lru_cache(maxsize=1)
def tick() -> tuple[float, int]:
    """Return the smallest step of the clock in s, and how often the clock can be read meanwhile."""
    steps, readings = [], []
    for _ in range(3):
        count, start = 1, clock()
        while (now := clock()) == start:
            count += 1
        steps.append(now - start)
        readings.append(count)
    return min(steps), max(readings)


class Cost:
    def __init__(self) -> None:
        self.random = random.Random()
        self.forget()

    def forget(self) -> None:
        """Start over, because the scene or one of its parameters has changed."""
        self.spent = 0.0  # s, since the last mean
        self.frames = 0
        self.means: deque[float] = deque(maxlen=MEANS)

    def measure(self, frame: Callable[[], object]) -> None:
        """Call ``frame``, which computes one frame of the scene, and measure the time it takes."""
        step, readings = tick()
        for _ in range(self.random.randrange(readings)):
            clock()
        start = clock()
        frame()
        self.spent += clock() - start
        self.frames += 1
        if self.frames >= LEAST_FRAMES and self.spent >= LEAST_TICKS * step:
            self.means.append(1e6 * self.spent / self.frames)
            self.spent, self.frames = 0.0, 0

    def known(self) -> float | None:
        """Return the time per frame in microseconds, or None if it is not known yet."""
        return statistics.median(self.means) if self.means else None
