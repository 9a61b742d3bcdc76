"""Exercise 6.5: how stiff may a spring be? Measured by the area that two states span."""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator
from ch06_springs.springs import AnchoredSpring

START = 10.0  # m, how far from its anchor the particle is released
FRAMES = 800
STIFFEST = 16.0  # times m / h^2: twice what the last of this chapter's steps can bear
SOFTEST = 1e-7

_FAR = 1e6 * START  # m: no swing that stays gets there
_ROUNDING = 1e-6  # what grows by less than this share in FRAMES frames has not grown
_CLOSE = 1.001  # the ratio of two stiffnesses between which nobody looks


def swings_wider(integrator: Integrator, stiffness: float, damping: float, duration: float) -> bool:
    not_negative("stiffness", stiffness)
    positive("duration", duration)
    particle = Particle(Vector3(START), damping=not_negative("damping", damping))
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), stiffness, 0.0))
    states = [(START, 0.0)]
    for _ in range(FRAMES):
        try:
            integrator([particle], registry.update_forces, duration)
        except ValueError:  # a force too large for a float: all else has been looked at
            return True
        states.append((particle.position.x, particle.velocity.x))
        if not abs(particle.position.x) < _FAR:
            return True
    first, last = _area(*states[:2]), _area(*states[-2:])
    if first == 0.0:  # it moves along one line of the plane: without any velocity, say
        first, last = START, abs(particle.position.x)
    return last > first * (1.0 + _ROUNDING)


def _area(one: tuple[float, float], other: tuple[float, float]) -> float:
    return abs(one[0] * other[1] - one[1] * other[0])


def largest_stable_stiffness(integrator: Integrator, damping: float, duration: float) -> float:
    not_negative("damping", damping)
    positive("duration", duration)

    def wide(kappa: float) -> bool:
        return swings_wider(integrator, kappa / duration / duration, damping, duration)

    def between(safe: float, unsafe: float) -> float:
        middle = math.sqrt(safe * unsafe)
        if unsafe < safe * _CLOSE:
            return middle
        return between(safe, middle) if wide(middle) else between(middle, unsafe)

    if wide(SOFTEST):
        return 0.0
    if not wide(STIFFEST):
        return STIFFEST / duration / duration
    return between(SOFTEST, STIFFEST) / duration / duration
