"""Exercise 6.5: how stiff may a spring be? This module measures it."""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator
from ch06_springs.springs import AnchoredSpring

START = 10.0  # m, how far from its anchor the particle is released
FRAMES = 2000
STIFFEST = 16.0  # times m / h^2: twice what runge_kutta_4 can bear at d = 1
SOFTEST = 1e-7  # times m / h^2: softer springs need not be told from none


def swings_wider(integrator: Integrator, stiffness: float, damping: float, duration: float) -> bool:
    """Exercise 6.5: say whether a spring of a stiffness in N/m makes a particle swing ever wider.

    The particle has 1 kg and this damping, and is released at rest START m away from the anchor of
    a spring whose rest length is 0. There is no gravity. It makes FRAMES steps by the integrator,
    each of a duration in s. A swing whose size stays is not wider. Asked for is a stiffness that is
    1 % off the limit or more, and whose swings take FRAMES / 6 frames or less: others are not told
    for sure. Nor are swings of nearly 3 or nearly 4 frames, where the damping is 1: their ends are
    missed for long.

    >>> from ch06_springs.integrators import semi_implicit_euler
    >>> swings_wider(semi_implicit_euler, 14_000.0, 1.0, 1.0 / 60.0)
    False
    >>> swings_wider(semi_implicit_euler, 15_000.0, 1.0, 1.0 / 60.0)
    True

    Raises ValueError where stiffness or damping is negative, the duration is not positive, or one
    of them is not finite.
    """
    positive("duration", duration)
    particle = Particle(Vector3(START), damping=damping)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), stiffness, 0.0))
    quarters = [0.0, 0.0, 0.0, 0.0]  # how far it has been away in each quarter of the time
    for frame in range(FRAMES):
        integrator([particle], registry.update_forces, duration)
        distance = abs(particle.position.x)
        if distance > 1e6 * START:
            return True
        quarter = 4 * frame // FRAMES
        quarters[quarter] = max(quarters[quarter], distance)
    return quarters[3] > 1.001 * quarters[1]  # a step may miss a swing's end by as little as that


def largest_stable_stiffness(integrator: Integrator, damping: float, duration: float) -> float:
    """Exercise 6.5: measure the stiffness in N/m above which the particle swings ever wider.

    What is measured is 1 % off at most where the damping is between 0.3 and 0.95 and the duration
    between 1/120 and 1/20 s; nearer to 1 the book's step grows so slowly that FRAMES are too few.
    Where no spring is safe it is 0, or next to it: nothing below SOFTEST / h^2 is looked at. Where
    STIFFEST / h^2 is safe, it is that.

    Raises ValueError where the damping is negative, the duration is not positive, or one of them is
    not finite.
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
