"""The clock of a simulation: how a scene is stepped, and which time its state belongs to.

Pictures are drawn at a fixed rate, and time steps may be longer or shorter than a frame. Each frame
makes all steps that end by the end of the frame. If the steps are longer than a frame, the state
lags behind the frame. An error must therefore be taken at the simulated time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

RATE = 60.0  # frames per second
FRAME = 1.0 / RATE  # s per frame
ROUNDING = 1e-9  # s, far more than the rounding errors of adding up frames and steps


class Clock:
    """Counts the frames and steps of a simulation.

    ``time`` is the total length of all frames in s, and ``simulated`` that of all steps. The state
    of the simulation belongs to the simulated time.
    """

    def __init__(self) -> None:
        self.time = 0.0
        self.simulated = 0.0

    def advance(self, step: Callable[[float], object], rate: float, frame: float = FRAME) -> None:
        """Advance a simulation by one frame, in steps of 1 / ``rate`` s.

        ``step`` makes a step of the given length in s. A frame may need several steps, or none.
        """
        self.time += frame
        length = 1.0 / rate
        for _ in range(math.floor((self.time - self.simulated + ROUNDING) * rate)):
            self.simulated += length
            step(length)


def deviation(found: Sequence[float], exact: Sequence[float]) -> float:
    """Return the largest difference between a coordinate and its exact value.

    If a coordinate is not finite, the deviation is infinite.
    """
    differences = [abs(a - b) for a, b in zip(found, exact, strict=True)]
    return max(differences, default=0.0) if all(map(math.isfinite, differences)) else math.inf
