"""Compute the state of a particle at any time with a formula, without time steps.

If you treat the damping d as a continuous drag, the equation of motion is dv/dt = a - k v. Here a
is a constant acceleration and k = -ln d. This equation has an exact solution.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


def drag_factors(damping: float, time: float) -> tuple[float, float, float]:
    """Compute three factors that give the exact motion of a particle with drag.

    After t seconds, its velocity is v * kept + a * gone, and its position is p + v * gone + a *
    fallen. The factors are kept = d^t, gone = (1 - d^t) / k in s, and fallen = (t - gone) / k in
    s^2, with k = -ln d.

    The formulas also hold for a damping d above 1. As d approaches 1, the factors approach 1, t and
    t^2 / 2. Close to this limit, and for very short times, they must still have at least 9 correct
    digits. A damping of 0 stops everything at once, so all three factors are 0 for any time above
    0. At time 0 they are 1, 0 and 0, whatever the damping is.
    """
    not_negative("damping", damping)
    not_negative("time", time)
    if time == 0.0:
        return 1.0, 0.0, 0.0
    if damping == 0.0:
        return 0.0, 0.0, 0.0
    k = -math.log(damping)
    if abs(k * time) > 0.5:
        kept = damping**time
        gone = (1.0 - kept) / k
        return kept, gone, (time - gone) / k
    # The formulas would divide almost 0 by almost 0. Their series, t^2 (1/2! - kt/3! + (kt)^2/4! -
    # ...), loses no digits. For |kt| up to 0.5, 12 terms are enough.
    fallen = time**2 * sum((-k * time) ** n / math.factorial(n + 2) for n in range(12))
    gone = time - k * fallen
    return 1.0 - k * gone, gone, fallen


def state_after(particle: Particle, time: float) -> tuple[Vector3, Vector3]:
    """Predict the position and velocity of ``particle`` after ``time`` s, without moving it.

    Both results are new vectors. For an immovable particle, return copies of its current ones.

    >>> shell = Particle(Vector3(0, 1.5, 0), Vector3(0, 30, 40), Vector3(0, -20, 0), damping=0.99)
    >>> position, _ = state_after(shell, 3.0347583)
    >>> round(position.y, 5), round(position.z, 5)
    (0.0, 119.55779)
    """
    kept, gone, fallen = drag_factors(particle.damping, time)
    p, v, a = particle.position, particle.velocity, particle.acceleration
    if not particle.has_finite_mass:
        return p.copy(), v.copy()
    return p + v * gone + a * fallen, v * kept + a * gone


def burst_positions(
    start: float, speeds: Sequence[float], acceleration: float, damping: float, time: float
) -> list[float]:
    """Compute the position of each spark of a burst along one axis, in m, after ``time`` s.

    All sparks start at the same position and time, with the same acceleration and damping. They
    differ only in their ``speeds`` along the axis, in m/s, and everything else needs to be computed
    only once per call. Return a new list in the order of the speeds, which do not change.

    >>> burst_positions(9.0, [-2.0, 0.0, 3.0], -10.0, damping=1.0, time=1.0)
    [2.0, 4.0, 7.0]
    """
    finite("start", start)
    finite("acceleration", acceleration)
    _, gone, fallen = drag_factors(damping, time)
    middle = start + acceleration * fallen
    return [middle + speed * gone for speed in speeds]
