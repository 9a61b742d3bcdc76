"""Damped spring."""

import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(x0, v0, stiffness, damping, mass, time):
    finite("x0", x0)
    finite("v0", v0)
    not_negative("stiffness", stiffness)
    not_negative("damping", damping)
    positive("mass", mass)
    not_negative("time", time)
    half = damping / (2 * mass)
    gamma = math.sqrt(stiffness / mass - half**2)
    if gamma == 0:
        return 0.0, 0.0
    c = (half * x0 + v0) / gamma
    fade = math.exp(-half * time)
    cos, sin = math.cos(gamma * time), math.sin(gamma * time)
    x = (x0 * cos + c * sin) * fade
    v = (c * cos - x0 * sin) * gamma * fade - half * x
    return x, v
