"""Where a damped spring takes its end, at any time and without steps (book 6.3)."""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    """Return position in m and velocity in m/s after a time in s: m x'' = -k x - c x' (6.3.2).

    The spring starts at x0 with the velocity v0, and rests at 0; ``stiffness`` k is in N/m,
    ``damping`` c in N s/m, ``mass`` m in kg. Its end swings through 0 while c^2 < 4 k m
    (under-damped); it comes to rest the soonest where they are equal (critical); beyond that it
    creeps (over-damped). The book has the first of these alone (E-23). Without stiffness it is a
    body that coasts.

    Raises ValueError where the mass is not positive, stiffness, damping or time is negative, or one
    of the arguments, k / m, c / m, the angle through which it swings, or the result, is not finite.
    What is no number is a TypeError.
    """
    finite("x0", x0)
    finite("v0", v0)
    positive("mass", mass)
    not_negative("time", time)
    half = finite("damping / mass", not_negative("damping", damping) / mass) / 2.0
    chi = math.sqrt(finite("stiffness / mass", not_negative("stiffness", stiffness) / mass))
    gamma = math.sqrt(abs(half - chi)) * math.sqrt(half + chi)  # root of |(c / 2 m)^2 - k / m|
    # swing is what becomes of a velocity of 1 m/s; stay and slow are those of x0 and of v0.
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
