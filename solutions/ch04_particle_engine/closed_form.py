"""Compute the state of a particle at any time with a formula, without time steps.

If you treat the damping d as a continuous drag, the equation of motion is dv/dt = a - k v. Here a
is a constant acceleration and k = -ln d. This equation has an exact solution, which gives the
position and the velocity at any time. A body that moves in this way, such as a spark, therefore
needs no time steps. You can evaluate the solution once, for the time that you want.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


def drag_factors(damping: float, time: float) -> tuple[float, float, float]:
    """Compute three factors that give the exact motion of a particle with drag.

    A particle starts at the position p with the velocity v and a constant acceleration a. After t
    seconds, its velocity is v * kept + a * gone, and its position is p + v * gone + a * fallen.
    Here kept, gone and fallen are the three factors:

    - kept = d^t, which has no unit, is the fraction of the velocity that remains.
    - gone = (1 - d^t) / k, in s, is how far an initial speed of 1 m/s takes the particle.
    - fallen = (t - gone) / k, in s^2, is how far an acceleration of 1 m/s^2 takes it from rest.

    Here d is the damping, k = -ln d, and t is the time in s. The formulas also hold for a damping
    above 1. As the damping approaches 1, the factors approach 1, t and t^2 / 2. Close to this
    limit, and for very short times, the formulas divide almost 0 by almost 0, which loses digits.
    The result must still have at least 9 correct digits, even for a damping as close to 1 as a
    float can be. At the other extreme, a damping of 0 stops everything at once, so all three
    factors are 0 for any time above 0. At time 0 they are 1, 0 and 0, whatever the damping is.
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
    # The series of fallen / t^2, 1/2 - kt/6 + (kt)^2/24 - ..., from which the others follow. At
    # 0.5 its 15th term is below the last digit.
    total, term = 0.0, 0.5
    for n in range(3, 17):
        total += term
        term *= -k * time / n
    share = total * time  # of the time: fallen / t
    gone = time * (1.0 - k * share)
    fallen = share * time
    if math.isinf(fallen):
        raise OverflowError(f"fallen does not fit in a float for the time {time!r}")
    return 1.0 - k * gone, gone, fallen


def state_after(particle: Particle, time: float) -> tuple[Vector3, Vector3]:
    """Predict the position and velocity of ``particle`` after ``time`` s, without moving it.

    Use this function, for example, to predict where a shell will land. Both results are new
    vectors. For an immovable particle, return copies of its current position and velocity.

    >>> shell = Particle(Vector3(0, 1.5, 0), Vector3(0, 30, 40), Vector3(0, -20, 0), damping=0.99)
    >>> position, _ = state_after(shell, 3.0347583)
    >>> round(position.y, 5), round(position.z, 5)
    (0.0, 119.55779)
    """
    kept, gone, fallen = drag_factors(particle.damping, time)
    position, velocity = particle.position, particle.velocity
    if not particle.has_finite_mass:
        return position.copy(), velocity.copy()
    acceleration = particle.acceleration
    return (
        position + velocity * gone + acceleration * fallen,
        velocity * kept + acceleration * gone,
    )


def burst_positions(
    start: float, speeds: Sequence[float], acceleration: float, damping: float, time: float
) -> list[float]:
    """Compute the position of each spark of a burst along one axis, in m, after ``time`` s.

    All sparks start at the same position and time, with the same acceleration and damping. They
    differ only in their ``speeds`` along the axis, in m/s. Everything else needs to be computed
    only once per call: the factors, and the position of a spark with a speed of 0. Each call
    handles only one axis, because a picture on the screen needs just two of the three. Return a new
    list in the order of the speeds, and leave ``speeds`` unchanged. It may be empty.

    >>> burst_positions(9.0, [-2.0, 0.0, 3.0], -10.0, damping=1.0, time=1.0)
    [2.0, 4.0, 7.0]
    """
    finite("start", start)
    finite("acceleration", acceleration)
    _, gone, fallen = drag_factors(damping, time)
    middle = start + acceleration * fallen
    return [middle + speed * gone for speed in speeds]
