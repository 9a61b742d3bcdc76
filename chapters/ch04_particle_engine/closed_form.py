"""Compute the state of a particle at any time with a formula, without time steps.

If you treat the damping d as a continuous drag, the equation of motion is dv/dt = a - k v. Here a
is a constant acceleration and k = -ln d. This equation has an exact solution.
"""

from __future__ import annotations

from collections.abc import Sequence

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
    raise NotImplementedError("Exercise B4.8: A state without steps")


def state_after(particle: Particle, time: float) -> tuple[Vector3, Vector3]:
    """Predict the position and velocity of ``particle`` after ``time`` s, without moving it.

    Both results are new vectors. For an immovable particle, return copies of its current ones.

    >>> shell = Particle(Vector3(0, 1.5, 0), Vector3(0, 30, 40), Vector3(0, -20, 0), damping=0.99)
    >>> position, _ = state_after(shell, 3.0347583)
    >>> round(position.y, 5), round(position.z, 5)
    (0.0, 119.55779)
    """
    raise NotImplementedError("Exercise B4.8: A state without steps")


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
    raise NotImplementedError("Exercise B4.9: All sparks of a burst at once")
