"""Ada's formulas."""

import math

from ch02_vectors.arguments import not_negative, positive


def terminal_speed(weight, k1, k2):
    positive("weight", weight)
    not_negative("k1", k1)
    not_negative("k2", k2)
    root = math.sqrt(k1**2 + 4 * k2 * weight)
    if root == 0:
        raise ValueError("there is no drag")
    return 2 * weight / (k1 + root)


def quadratic_fall(mass, gravity, k2, time):
    positive("mass", mass)
    positive("gravity", gravity)
    positive("k2", k2)
    not_negative("time", time)
    u = math.sqrt(mass * gravity / k2)
    x = gravity * time / u
    if x > 100:
        log_cosh = x - math.log(2)
    else:
        log_cosh = math.log1p(2 * math.sinh(x / 2) ** 2)
    return u * math.tanh(x), mass / k2 * log_cosh


def coasting_speed(speed, k1, k2, mass, time):
    for name, value in (("speed", speed), ("k1", k1), ("k2", k2), ("time", time)):
        not_negative(name, value)
    positive("mass", mass)
    s = k1 * time / mass
    share = -math.expm1(-s) / s if s > 0 else 1
    return speed * math.exp(-s) / (1 + k2 * speed * time / mass * share)


def drag_limits(k1, k2, mass, speed):
    for name, value in (("k1", k1), ("k2", k2), ("speed", speed)):
        not_negative(name, value)
    positive("mass", mass)
    drag = k1 + k2 * speed
    if drag == 0:
        return math.inf, math.inf
    return mass / drag, 2 * mass / drag
