"""Where a particle is at any time, without a step.

Under a constant acceleration a, with damping d as the drag dv/dt = a - k v at every instant,
k = -ln d, position and velocity have a formula. Whatever moves like that, such as a spark, needs
no frames: one evaluation gives the state at any time, exactly. Model no more than a scene needs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


def drag_factors(damping: float, time: float) -> tuple[float, float, float]:
    """Return the three factors of the closed form: kept, gone and fallen.

    v(t) = v kept + a gone, and p(t) = p + v gone + a fallen, with

    - kept = d^t, which has no unit,
    - gone = (1 - d^t) / k in s: how far a speed of 1 m/s carries,
    - fallen = (t - gone) / k in s^2: how far an acceleration of 1 m/s^2 carries.

    As the damping goes to 1 they go to 1, t and t^2 / 2. They are right to 9 digits or more for a
    damping as near to 1 as a float can be, where the formulas divide almost 0 by almost 0. A
    damping of 0 stops everything at once: 0, 0, 0, if any time passes.

    Raises ValueError where the damping or the time is negative or not finite, OverflowError where a
    factor does not fit in a float.
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
    """Return where a particle will be and how fast, after a time in s, as new vectors.

    The particle stays as it is. An immovable one is found where it is now, with its velocity.

    Raises ValueError where the time is negative or not finite, OverflowError as drag_factors does.

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
    """Return where the sparks of one burst are along one axis, in m, after a time in s.

    All start at one place at one time, under one acceleration and damping; only their speeds along
    the axis, in m/s, differ. So the factors, and where a spark without a speed would be, are worked
    out once for all. A screen shows two axes: nobody has to work out the third.

    The speeds are taken as they are. Raises ValueError where the start or the acceleration is not
    finite, or the damping or the time is negative or not finite, and OverflowError as drag_factors.

    >>> burst_positions(9.0, [-2.0, 0.0, 3.0], -10.0, damping=1.0, time=1.0)
    [2.0, 4.0, 7.0]
    """
    finite("start", start)
    finite("acceleration", acceleration)
    _, gone, fallen = drag_factors(damping, time)
    middle = start + acceleration * fallen
    return [middle + speed * gone for speed in speeds]
