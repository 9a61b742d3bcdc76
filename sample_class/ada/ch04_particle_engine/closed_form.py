"""The state of a particle at any time at once, under a constant acceleration and a steady drag."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import reduce

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

_SHORT = 2.0**-6  # of the time that the drag takes to wear a speed down to 1 / e


def drag_factors(damping: float, time: float) -> tuple[float, float, float]:
    not_negative("damping", damping)
    seconds = not_negative("time", time)
    kept = math.pow(damping, seconds)
    if damping == 0:
        return kept, 0.0, 0.0
    drag = -math.log(damping)
    if kept == 0:  # all that the start had is gone
        return kept, 1 / drag, (seconds - 1 / drag) / drag
    gone, fallen = _carried(damping, drag, seconds)
    return kept, gone, fallen


def state_after(particle: Particle, time: float) -> tuple[Vector3, Vector3]:
    kept, gone, fallen = drag_factors(particle.damping, time)
    if not particle.has_finite_mass:
        kept, gone, fallen = 1.0, 0.0, 0.0
    position, velocity = particle.position.copy(), particle.velocity * kept
    position.add_scaled(particle.velocity, gone)
    position.add_scaled(particle.acceleration, fallen)
    velocity.add_scaled(particle.acceleration, gone)
    return position, velocity


def burst_positions(
    start: float, speeds: Sequence[float], acceleration: float, damping: float, time: float
) -> list[float]:
    _, gone, fallen = drag_factors(damping, time)
    middle = finite("start", start) + finite("acceleration", acceleration) * fallen
    return [middle + gone * speed for speed in speeds]


def _carried(damping: float, drag: float, time: float) -> tuple[float, float]:
    """Return gone and fallen after a time.

    A time is its two halves: the second one goes on with the speed that the first one left. All
    that is added up has one sign, so no digits are lost.
    """
    if abs(drag * time) < _SHORT:
        return time * _series(1, -drag * time), time * time * _series(2, -drag * time)
    gone, fallen = _carried(damping, drag, time / 2)
    return gone * (1 + math.pow(damping, time / 2)), 2 * fallen + gone * gone


def _series(first: int, x: float) -> float:
    """Return 1 / n! + x / (n + 1)! + x^2 / (n + 2)! + ... from n = first, for a small x."""
    factors = range(first + 8, first, -1)
    return reduce(lambda rest, n: 1 + x / n * rest, factors, 1.0) / math.factorial(first)
