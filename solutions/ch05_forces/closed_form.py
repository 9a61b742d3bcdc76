"""Exact solutions for motion with drag, and the longest safe time steps (book 5.3).

An exact solution gives a speed or a distance at any time, without time steps, so you can use it to
check a simulation. All motion here is along one line, and all numbers are in SI units. The
coefficients of Eq. 5.1 are k1 in N s/m and k2 in N s^2/m^2.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Compute the terminal speed in m/s, at which the drag on a falling body balances its weight.

    As a body falls faster, its drag grows, so its speed approaches a limit. This terminal speed is
    the positive solution v of k1 v + k2 v^2 = weight, where ``weight`` is in N.

    The result must be correct to about 12 digits for any combination of the two kinds of drag, even
    if one coefficient is 0 or tiny.

    Raises:
        ValueError: if both coefficients are 0, because without drag the speed grows without limit.
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
    """Compute how fast and how far a body falls from rest in a given time, with quadratic drag.

    The drag is k2 v^2, with no linear term. Let u be the terminal speed, g the ``gravity`` in
    m/s^2, t the ``time`` in s, which may be 0, and x = g t / u. Return the speed in m/s, which is
    u tanh x, and the distance in m, which is (u^2 / g) ln cosh x. Both must be correct to about 12
    digits, even if x is very small or very large.
    """
    positive("gravity", gravity)
    u = terminal_speed(positive("mass", mass) * gravity, 0.0, positive("k2", k2))
    x = gravity * not_negative("time", time) / u
    # cosh x is 1 + 2 sinh^2(x / 2), which keeps the digits of a small x; e^x / 2 for a large one.
    ln_cosh = math.log1p(2.0 * math.sinh(x / 2.0) ** 2) if x < 40.0 else x - math.log(2.0)
    return u * math.tanh(x), u * (u / gravity * ln_cosh)


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Compute the speed in m/s of a body after drag alone has acted on it for ``time`` s.

    Let v be the ``speed`` at the start, and s = k1 t / m. The result is

        v e^-s / (1 + k2 v (1 - e^-s) / k1)

    If k1 is 0, this formula divides by 0, so replace (1 - e^-s) / k1 by its limit, which is t / m.
    The result must be correct to about 12 digits, even if k1 is tiny or the time is very long.
    """
    not_negative("speed", speed)
    not_negative("time", time)
    s = not_negative("k1", k1) * time / positive("mass", mass)
    gone = -math.expm1(-s) / k1 if s else time / mass
    rate = not_negative("k2", k2) * speed
    return speed * math.exp(-s) / (1.0 + rate * gone if rate else 1.0)


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Compute how long a time step may be before drag reverses the motion or even speeds it up.

    A time step computes the drag f only once, from the ``speed`` before the step. It then applies
    this force for the whole duration h: v' = v + (f / m) h. Return two limits in s for a step in
    which only drag acts. In a step longer than the first limit, the drag reverses the motion
    instead of only slowing it down. In a step longer than the second limit, the particle moves
    backward even faster than it moved forward. Without drag, both limits are ``math.inf``. If only
    the speed is 0, return the limits for a very low speed, which are finite if ``k1`` is not 0.
    """
    rate = (not_negative("k1", k1) + not_negative("k2", k2) * not_negative("speed", speed)) / (
        positive("mass", mass)
    )
    if rate == 0.0:
        return math.inf, math.inf
    return 1.0 / rate, 2.0 / rate
