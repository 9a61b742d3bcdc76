"""Slow a shot down until it can be seen, without changing its energy or its arc.

``factor`` says how many times slower the shot of the game flies than the real one.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass: float, speed: float) -> float:
    momentum = positive("mass", mass) * not_negative("speed", speed)
    return momentum * speed / 2


def slowed_mass(mass: float, factor: float) -> float:
    keeps_momentum = positive("mass", mass) * positive("factor", factor)
    return keeps_momentum * factor


def slowed_gravity(gravity: float, factor: float) -> float:
    seconds = 1.0
    for _ in range(2):
        seconds *= positive("factor", factor)
    return finite("gravity", gravity) / seconds
