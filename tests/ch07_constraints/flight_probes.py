"""Steps by time division. The autograder runs this file beside the student's code."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ch07_constraints.probes import Components, moving, number_of
from ch07_constraints.time_division import TooManyImpacts, time_division_step

Impacts = list[tuple[int, int, float]]


class Watched:
    """A detector that records the durations it gets, and the ends and time of each impact."""

    def __init__(self, detector: Any, particles: Sequence[Any]) -> None:
        self.detector, self.particles = detector, particles
        self.asked: list[float] = []
        self.found: Impacts = []

    def next_impact(self, duration: float) -> Any:
        if len(self.asked) == 1400:  # a step without a limit would never end
            return None
        self.asked.append(duration)
        impact = self.detector.next_impact(duration)
        if impact is not None:
            ends = (impact[1].particle, impact[1].other)
            a, b = (number_of(end, self.particles) for end in ends)
            self.found.append((a, b, impact[0]))
        return impact


def flown(
    spheres: Sequence[Any], detector: Any, duration: float, steps: int, most: int = 1000
) -> tuple[
    list[list[tuple[Components, Components]]], Impacts, list[float], tuple[int, float] | None
]:
    """Return positions and velocities after each step, and what the detector found and was asked.

    The fourth result is the impacts and the time of the error that ended the steps, or None.
    """
    watched = Watched(detector, spheres)
    seen, ended = [], None
    for _ in range(steps):
        try:
            time_division_step(spheres, watched, duration, most)
        except TooManyImpacts as error:
            ended = error.impacts, error.time
        seen.append(moving(spheres))
        if ended:
            break
    return seen, watched.found, watched.asked, ended
