"""What drag does to a particle, without steps; and the frames that are too long for the steps.

Everything here moves along one line, and its numbers are in SI units. k1 and k2 are Eq. 5.1's, in
N s/m and N s^2/m^2. What is no number is a TypeError everywhere.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Return the speed in m/s of a fall at which the drag is as large as the weight in N.

    It solves k1 v + k2 v^2 = weight.

    Raises ValueError where the weight is not positive, a coefficient is negative, one of them is
    not finite, or both coefficients are 0: such a fall gains speed for ever.
    """
    positive("weight", weight)
    not_negative("k1", k1)
    not_negative("k2", k2)
    if k1 == 0.0 and k2 == 0.0:
        raise ValueError("k1 and k2 are both 0: without drag there is no terminal speed")
    # The formula with (-k1 + root) / (2 k2) loses its digits where k2 is small, and divides by 0.
    root = math.hypot(k1, 2.0 * math.sqrt(k2) * math.sqrt(weight))  # the root of k1^2 + 4 k2 weight
    return 2.0 * (weight / (k1 + root))


def quadratic_fall(mass: float, gravity: float, k2: float, time: float) -> tuple[float, float]:
    """Return the speed in m/s and the distance in m of a fall from rest, with quadratic drag alone.

    They are u tanh x and u^2 / g times ln cosh x, where x is g t / u, with the terminal speed u and
    the time t in s.

    Raises ValueError where mass, gravity or k2 is not positive, the time is negative, or one of
    them is not finite.
    """
    positive("gravity", gravity)
    u = terminal_speed(positive("mass", mass) * gravity, 0.0, positive("k2", k2))
    x = gravity * not_negative("time", time) / u
    # cosh x is 1 + 2 sinh^2(x / 2), which keeps the digits of a small x; e^x / 2 for a large one.
    ln_cosh = math.log1p(2.0 * math.sinh(x / 2.0) ** 2) if x < 40.0 else x - math.log(2.0)
    return u * math.tanh(x), u * (u / gravity * ln_cosh)


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Return what is left of a speed in m/s after a time in s in which nothing but drag acts.

    With s = k1 t / m it is v e^-s / (1 + k2 v (1 - e^-s) / k1), where (1 - e^-s) / k1 goes to t / m
    for k1 = 0.

    Raises ValueError where the mass is not positive, another of them is negative, or one of them is
    not finite.
    """
    not_negative("speed", speed)
    not_negative("time", time)
    s = not_negative("k1", k1) * time / positive("mass", mass)
    gone = -math.expm1(-s) / k1 if s else time / mass
    rate = not_negative("k2", k2) * speed
    return speed * math.exp(-s) / (1.0 + rate * gone if rate else 1.0)


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Return two lengths of a frame in s, beyond which a step with drag alone goes wrong.

    In a frame longer than the first, the drag turns the motion round; in one longer than the
    second, the particle is faster afterwards than it was. The step is v' = v + (f / m) h, with the
    f of Eq. 5.1 at the speed at which the frame begins. Without drag both are math.inf.

    Raises ValueError where the mass is not positive, another of them is negative, or one of them is
    not finite.
    """
    rate = (not_negative("k1", k1) + not_negative("k2", k2) * not_negative("speed", speed)) / (
        positive("mass", mass)
    )
    if rate == 0.0:
        return math.inf, math.inf
    return 1.0 / rate, 2.0 / rate
