"""The clock of a simulation, whose time steps may be shorter or longer than a frame.

With longer steps, the state lags behind the frame. Take errors at the simulated time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

RATE = 60.0  # frames per second
FRAME = 1.0 / RATE  # s per frame
ROUNDING = 1e-9  # s, far more than the rounding errors of adding up frames and steps


class Clock:
    """Counts the frames and steps of a simulation."""

    def __init__(self) -> None:
        self.time = 0.0  # s, of all frames
        self.simulated = 0.0  # s, of all steps; the time of the state

    def advance(self, step: Callable[[float], object], rate: float, frame: float = FRAME) -> None:
        """Advance a simulation by one frame, in several steps of 1 / ``rate`` s, or in none."""
        self.time += frame
        length = 1.0 / rate
        for _ in range(math.floor((self.time - self.simulated + ROUNDING) * rate)):
            self.simulated += length
            step(length)


def deviation(found: Sequence[float], exact: Sequence[float]) -> float:
    """Return the largest error of a coordinate, which is infinite if one of them is not finite."""
    differences = [abs(a - b) for a, b in zip(found, exact, strict=True)]
    return max(differences, default=0.0) if all(map(math.isfinite, differences)) else math.inf
