"""What drag does to a particle, without steps; and the frames that are too long for the steps.

Everything here moves along one line, and its numbers are in SI units. k1 and k2 are Eq. 5.1's.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import not_negative, positive


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    positive("weight", weight)
    if not_negative("k1", k1) + not_negative("k2", k2) == 0.0:
        raise ValueError("k1 and k2 must not both be 0")
    # The usual root (-k1 + q) / (2 k2), multiplied above and below by k1 + q: good for k2 = 0 too.
    q = math.hypot(k1, 2.0 * math.sqrt(k2) * math.sqrt(weight))
    return 2.0 * (weight / (k1 + q))


def quadratic_fall(mass: float, gravity: float, k2: float, time: float) -> tuple[float, float]:
    positive("mass", mass)
    positive("gravity", gravity)
    positive("k2", k2)
    not_negative("time", time)
    x = time * math.sqrt(gravity) * math.sqrt(k2) / math.sqrt(mass)  # g t / u
    if x < 1e-4:  # hardly any drag yet: the series of tanh x and ln cosh x
        speed = gravity * time
        return speed * (1.0 - x * x / 3.0), speed * time / 2.0 * (1.0 - x * x / 6.0)
    terminal = math.sqrt(mass) * math.sqrt(gravity) / math.sqrt(k2)
    return terminal * math.tanh(x), mass / k2 * _ln_cosh(x)


def _ln_cosh(x: float) -> float:
    if x < 1.0:
        return math.log1p(2.0 * math.sinh(x / 2.0) ** 2)  # cosh x = 1 + 2 sinh^2 (x / 2)
    return x - math.log(2.0) + math.log1p(math.exp(-2.0 * x))  # cosh x = e^x (1 + e^-2x) / 2


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    not_negative("speed", speed)
    not_negative("k1", k1)
    not_negative("k2", k2)
    positive("mass", mass)
    if not_negative("time", time) == 0.0:
        return speed
    s = k1 * time / mass
    left = speed * math.exp(-s)
    if left == 0.0:
        return 0.0
    share = -math.expm1(-s) / s if s > 0.0 else 1.0
    return left / (1.0 + k2 * speed / mass * time * share)


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    not_negative("k1", k1)
    not_negative("k2", k2)
    positive("mass", mass)
    not_negative("speed", speed)
    # v' = v (1 - c h / m) with c = k1 + k2 v: it is 0 for h = m / c, and -v for twice that.
    c = k1 + k2 * speed
    if c == 0.0:
        return math.inf, math.inf
    stop = mass / c
    return stop, 2.0 * stop
