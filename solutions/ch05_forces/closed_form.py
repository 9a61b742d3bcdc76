"""Exact motion with drag along one line, and the longest safe time steps (book 5.3).

k1 and k2 are the coefficients of Eq. 5.1. The results must be correct to about 12 digits, even if
one coefficient is 0 or tiny, even for a very short or very long time. The time may be 0.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Compute the speed at which the drag balances the weight: k1 v + k2 v^2 = ``weight``.

    Raises ValueError if both coefficients are 0, because then the speed grows without limit.
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
    """Compute the speed and the distance of a fall from rest for ``time`` s, with drag k2 v^2.

    They are u tanh x and (u^2 / g) ln cosh x, where u is the terminal speed, g the ``gravity``, and
    x = g t / u.
    """
    positive("gravity", gravity)
    u = terminal_speed(positive("mass", mass) * gravity, 0.0, positive("k2", k2))
    x = gravity * not_negative("time", time) / u
    # cosh x is 1 + 2 sinh^2(x / 2), which keeps the digits of a small x; e^x / 2 for a large one.
    ln_cosh = math.log1p(2.0 * math.sinh(x / 2.0) ** 2) if x < 40.0 else x - math.log(2.0)
    return u * math.tanh(x), u * (u / gravity * ln_cosh)


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Compute the speed of a body after drag alone has acted on it for ``time`` s.

    It is v e^-s / (1 + k2 v (1 - e^-s) / k1), where v is the ``speed`` at the start and s is k1 t /
    m. If k1 is 0, replace (1 - e^-s) / k1 by its limit, t / m.
    """
    not_negative("speed", speed)
    not_negative("time", time)
    s = not_negative("k1", k1) * time / positive("mass", mass)
    gone = -math.expm1(-s) / k1 if s else time / mass
    rate = not_negative("k2", k2) * speed
    return speed * math.exp(-s) / (1.0 + rate * gone if rate else 1.0)


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Return the durations in s above which a step reverses the motion, and speeds it up.

    Only drag acts: v' = v + (f / m) h, with the f of ``speed``. Both are ``math.inf`` without drag.
    """
    rate = (not_negative("k1", k1) + not_negative("k2", k2) * not_negative("speed", speed)) / (
        positive("mass", mass)
    )
    if rate == 0.0:
        return math.inf, math.inf
    return 1.0 / rate, 2.0 / rate
