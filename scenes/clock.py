"""The clock of a simulation, and records of quantities over its course.

Time steps may be shorter or longer than a frame. With longer steps, the state lags behind the
frame. Take errors at the simulated time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from scenes.readings import number, stopped

RATE = 60.0  # frames per second
FRAME = 1.0 / RATE  # s per frame
ROUNDING = 1e-9  # s, far more than the rounding errors of adding up frames and steps
Measure = Callable[[], float]
Move = Callable[[float], object]  # advances a simulation by a duration in s


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


@dataclass(frozen=True)
class Track:
    """A quantity at the start and after each time step, until the engine raises an error."""

    times: list[float]
    values: list[float]
    message: str = ""  # of the error

    @property
    def points(self) -> list[tuple[float, float]]:
        """The recorded data as a list of pairs, each with a time and the value at that time."""
        return [*zip(self.times, self.values, strict=True)]


def track(move: Move, measure: Measure, frames: int, duration: float = FRAME) -> Track:
    """Run a simulation step by step, and record a value at the start and after each step."""
    return tracks(move, [measure], frames, duration)[0]


def tracks(
    move: Move, measures: Sequence[Measure], frames: int, duration: float = FRAME
) -> list[Track]:
    """Run a simulation step by step, and record several values at the start and after each step."""
    times, rows = [0.0], [[number(measure()) for measure in measures]]

    def run() -> None:
        for i in range(1, frames + 1):
            move(duration)
            rows.append([number(measure()) for measure in measures])
            times.append(i * duration)

    message = stopped(run)
    found = rows[: len(times)]
    return [Track(times, [*values], message) for values in zip(*found, strict=True)]
