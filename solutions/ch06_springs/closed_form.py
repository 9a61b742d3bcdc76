"""The exact state of a damped spring at any time, without time steps (book 6.3.2)."""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    """Return the position and velocity of a damped spring after ``time`` s, as a tuple.

    The spring pulls a body toward position 0, so m x'' = -k x - c x'. Here k is ``stiffness`` in
    N/m, c is ``damping`` in N s/m and m is ``mass`` in kg. The body starts at ``x0`` in m with the
    velocity ``v0`` in m/s. With s = c / (2 m) and g = sqrt(|s^2 - k / m|), its position is

        x = e^(-s t) (x0 C + (v0 + s x0) S)

    - where C = cos(g t) and S = sin(g t) / g if c^2 < 4 k m, so that it oscillates,
    - C = 1 and S = t if c^2 = 4 k m (critically damped),
    - C = cosh(g t) and S = sinh(g t) / g if c^2 > 4 k m, so that it creeps back to 0.

    The velocity is the derivative of this position. Tell the cases apart without a tolerance,
    because even a very soft spring oscillates. The result must be accurate to 1e-8 even if the
    damping is almost critical, and also at late times and for strong damping, where cosh(g t) is
    too large for a float. If the stiffness is 0, the body feels no spring force.
    """
    finite("x0", x0)
    finite("v0", v0)
    positive("mass", mass)
    not_negative("time", time)
    k = finite("stiffness / mass", not_negative("stiffness", stiffness) / mass)
    half = finite("damping / mass", not_negative("damping", damping) / mass) / 2.0
    chi = math.sqrt(k)
    gamma = math.sqrt(abs(half - chi)) * math.sqrt(half + chi)
    fast = slow = half  # the two rates at which the motion fades
    if half < chi:
        angle = finite("the angle of the swing", gamma * time)
        stay = math.exp(-half * time) * math.cos(angle)
        swing = math.exp(-half * time) * math.sin(angle) / gamma
    elif half == chi:
        stay = math.exp(-half * time)
        swing = stay * time
    else:
        fast, slow = half + gamma, chi * (chi / (half + gamma))  # half - gamma loses its digits
        stay = math.exp(-fast * time)
        swing = math.exp(-slow * time) * -math.expm1(-2.0 * gamma * time) / (2.0 * gamma)
    x = x0 * (stay + fast * swing) + v0 * swing
    v = v0 * (stay - slow * swing) - x0 * (k * swing)
    return finite("the position", x), finite("the velocity", v)
