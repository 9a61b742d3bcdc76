"""Slow a shot down until it can be seen, without changing its energy or its arc.

``factor`` says how many times slower the shot of the game flies than the real one.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass: float, speed: float) -> float:
    """Half the momentum times the speed, in J."""
    momentum = positive("mass", mass) * not_negative("speed", speed)
    return momentum * speed / 2


def slowed_mass(mass: float, factor: float) -> float:
    """The mass in kg: once the factor keeps the momentum, twice the factor keeps the energy."""
    keeps_momentum = positive("mass", mass) * positive("factor", factor)
    return keeps_momentum * factor


def slowed_gravity(gravity: float, factor: float) -> float:
    """The gravity in m/s^2, seen by a clock that runs slower by the factor: per second twice."""
    seconds = 1.0
    for _ in range(2):
        seconds *= positive("factor", factor)
    return finite("gravity", gravity) / seconds
