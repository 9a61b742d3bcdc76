"""Where a damped spring takes its end, at any time and without steps: by its two complex rates."""

from __future__ import annotations

import cmath
import math

from ch02_vectors.arguments import finite, not_negative, positive


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    x0, v0, time = finite("x0", x0), finite("v0", v0), not_negative("time", time)
    chi = math.sqrt(not_negative("stiffness", stiffness)) / math.sqrt(positive("mass", mass))
    half = not_negative("damping", damping) / mass / 2.0
    if math.isinf(half):  # no float is that fast: the velocity is gone at once, and the end creeps
        rate = stiffness / damping
        left = x0 * math.exp(-rate * time)
        return (left, -rate * left) if time else (x0, v0)
    gamma = cmath.sqrt(half - chi) * math.sqrt(half + chi)  # two roots: a square could overflow
    if abs(gamma) * time < 1.0:
        return _by_the_middle(x0, v0, chi, half, gamma, time)
    # fast * slow = chi^2, and this quotient keeps the digits that half - gamma would lose.
    fast = half + gamma
    slow = chi * (chi / fast)
    late, soon = cmath.exp(-slow * time), cmath.exp(-fast * time)
    width = 2.0 * gamma
    x = x0 * (fast / width * late - slow / width * soon) + v0 * ((late - soon) / width)
    v = v0 * (fast / width * soon - slow / width * late) + x0 * (slow * fast / width) * (
        soon - late
    )
    return x.real, v.real


def _by_the_middle(
    x0: float, v0: float, chi: float, half: float, gamma: complex, time: float
) -> tuple[float, float]:
    """Return the state where the two rates are (nearly) one: critical damping, or a short time."""
    turn = gamma * time
    decay = math.exp(-half * time)
    even = decay * cmath.cosh(turn).real
    odd = decay * time * (cmath.sinh(turn) / turn if turn else 1.0 + 0j).real
    x = x0 * (even + half * odd) + v0 * odd
    v = v0 * (even - half * odd) - x0 * chi * (chi * odd)
    return x, v
