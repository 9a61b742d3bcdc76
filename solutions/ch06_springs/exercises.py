"""Measure how stiff a spring may be before its oscillations grow (exercise 6.5)."""

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
STIFFEST = 16.0  # times m / h^2: twice the limit of runge_kutta_4 at d = 1
SOFTEST = 1e-7  # times m / h^2: softer springs count as no spring


def swings_wider(integrator: Integrator, stiffness: float, damping: float, duration: float) -> bool:
    """Exercise 6.5: return True if the oscillations of a particle on a spring grow.

    Oscillations of constant amplitude do not count as growing. The steps seldom meet the end of a
    swing exactly, so the largest distances differ by about 0.1 %, which you should tolerate.

    Simulate a particle of 1 kg with the given ``damping``, without gravity, on a spring to an
    anchor, with rest length 0 and the given ``stiffness`` in N/m. Release the particle at rest,
    ``START`` m away. Make ``FRAMES`` steps of ``duration`` s each, but stop as soon as the distance
    is huge. The answer must be correct if the stiffness differs from the limit by at least 1 % and
    an oscillation takes at most FRAMES / 6 steps. Only without damping (``damping`` is 1) it may be
    wrong if an oscillation takes nearly 3 or 4 steps, which miss its extremes for a long time.

    >>> from ch06_springs.integrators import semi_implicit_euler
    >>> swings_wider(semi_implicit_euler, 14_000.0, 1.0, 1.0 / 60.0)
    False
    >>> swings_wider(semi_implicit_euler, 15_000.0, 1.0, 1.0 / 60.0)
    True
    """
    positive("duration", duration)
    particle = Particle(Vector3(START), damping=damping)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), stiffness, 0.0))
    quarters = [0.0, 0.0, 0.0, 0.0]  # the largest distance in each quarter of the time
    for frame in range(FRAMES):
        integrator([particle], registry.update_forces, duration)
        distance = abs(particle.position.x)
        if distance > 1e6 * START:
            return True
        quarter = 4 * frame // FRAMES
        quarters[quarter] = max(quarters[quarter], distance)
    return quarters[3] > 1.001 * quarters[1]  # steps may miss the end of a swing by that much


def largest_stable_stiffness(integrator: Integrator, damping: float, duration: float) -> float:
    """Exercise 6.5: measure the largest stiffness in N/m at which the oscillations do not grow.

    Search from SOFTEST / h^2 to STIFFEST / h^2, where h is ``duration`` in s. If even the softest
    spring is unstable, return 0 or almost 0. If even the stiffest spring is stable, return STIFFEST
    / h^2. The result must be within 1 % of the true limit for a damping from 0.3 to 0.9 and a
    duration from 1/120 to 1/20 s. Closer to 1, the growth is too slow for ``FRAMES`` steps.
    """
    not_negative("damping", damping)
    unit = 1.0 / positive("duration", duration) ** 2
    low, high = SOFTEST * unit, STIFFEST * unit
    if swings_wider(integrator, low, damping, duration):
        return 0.0
    if not swings_wider(integrator, high, damping, duration):
        return high
    while high > 1.005 * low:
        middle = math.sqrt(low * high)
        if swings_wider(integrator, middle, damping, duration):
            high = middle
        else:
            low = middle
    return low
