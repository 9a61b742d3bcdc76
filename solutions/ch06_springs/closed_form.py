"""Compute the exact state of a damped spring at any time, without time steps (book 6.3.2).

Use this module to check an integrator, or to replace a spring that is too stiff for the time steps.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    """Compute the position and velocity of a damped spring after ``time`` s, without time steps.

    A spring pulls a body toward position 0. The body starts at the position ``x0`` in m with the
    velocity ``v0`` in m/s. Its equation of motion is m x'' = -k x - c x'. Here k is ``stiffness``
    in N/m, c is ``damping`` in N s/m and m is ``mass`` in kg. The result is a tuple of the body's
    position in m and velocity in m/s. The kind of motion depends on the damping:

    - If c^2 < 4 k m, it oscillates through 0 (under-damped).
    - If c^2 = 4 k m, it returns to 0 as quickly as it can without oscillating (critically damped).
    - If c^2 > 4 k m, it creeps back to 0 without oscillating (over-damped).

    With s = c / (2 m) and g = sqrt(|s^2 - k / m|), the position is

        x = e^(-s t) (x0 C + (v0 + s x0) S)

    where C = cos(g t) and S = sin(g t) / g if the body is under-damped, C = 1 and S = t if it is
    critically damped, and C = cosh(g t) and S = sinh(g t) / g if it is over-damped. The velocity is
    the derivative of this position.

    Tell the three cases apart without a tolerance, because even a very soft spring oscillates. The
    result must be accurate to 1e-8 even if the damping is almost critical. It must also be accurate
    at late times and for strong damping, although cosh(g t) is too large for a float there.

    If the stiffness is 0, the body feels no spring force. It keeps moving in its direction, and
    only the damping slows it down. The book covers only the under-damped case (erratum E-23),
    and its equation lacks the mass (erratum E-40).

    Book: section 6.3.2.
    """
    finite("x0", x0)
    finite("v0", v0)
    positive("mass", mass)
    not_negative("time", time)
    half = finite("damping / mass", not_negative("damping", damping) / mass) / 2.0
    chi = math.sqrt(finite("stiffness / mass", not_negative("stiffness", stiffness) / mass))
    gamma = math.sqrt(abs(half - chi)) * math.sqrt(half + chi)  # root of |(c / 2 m)^2 - k / m|
    # x = x0 stay + v0 swing, and v0 contributes v0 slow to the velocity.
    if half < chi:
        fade = math.exp(-half * time)
        angle = finite("the angle of the swing", gamma * time)
        swing = fade * math.sin(angle) / gamma
        stay = fade * math.cos(angle) + half * swing
        slow = stay - 2.0 * half * swing
    elif half == chi:
        fade = math.exp(-half * time)
        swing = fade * time
        stay = fade + half * swing
        slow = fade - half * swing
    else:
        fast, creep = half + gamma, chi * (chi / (half + gamma))  # half - gamma loses its digits
        fade = math.exp(-fast * time)
        swing = math.exp(-creep * time) * -math.expm1(-2.0 * gamma * time) / (2.0 * gamma)
        stay = fade + fast * swing
        slow = fade - creep * swing
    x, v = x0 * stay + v0 * swing, v0 * slow - x0 * chi * (chi * swing)
    return finite("the position", x), finite("the velocity", v)
