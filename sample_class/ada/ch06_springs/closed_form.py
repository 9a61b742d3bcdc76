"""Ada's damped spring, without steps."""

import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(x0, v0, stiffness, damping, mass, time):
    x0, v0 = finite("x0", x0), finite("v0", v0)
    k = not_negative("stiffness", stiffness)
    c = not_negative("damping", damping)
    m = positive("mass", mass)
    t = not_negative("time", time)

    half = c / m / 2
    chi = math.sqrt(k / m)
    gamma = math.sqrt(abs(half - chi)) * math.sqrt(half + chi)

    if half < chi:  # it swings
        angle = finite("the angle of the swing", gamma * t)
        fade = math.exp(-half * t)
        s = fade * math.sin(angle) / gamma
        p = fade * math.cos(angle)
        return x0 * (p + half * s) + v0 * s, v0 * (p - half * s) - chi * s * chi * x0

    # it creeps: e^(-slow t) and e^(-fast t), and slow is fast at the critical damping
    fast = half + gamma
    slow = chi * (chi / fast) if fast else 0.0
    s = math.exp(-slow * t)
    s *= -math.expm1(-2 * gamma * t) / (2 * gamma) if gamma else t
    x = x0 * (math.exp(-slow * t) + slow * s) + v0 * s
    v = v0 * (math.exp(-fast * t) - slow * s) - chi * s * chi * x0
    return x, v
