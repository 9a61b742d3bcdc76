"""Record the values of a quantity over the course of a simulation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from scenes.clock import FRAME
from scenes.readings import number, stopped

Measure = Callable[[], float]
Move = Callable[[float], object]  # advances a simulation by a duration in s


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
