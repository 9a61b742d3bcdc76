"""A body of 1 kg that swings on an undamped spring. Its motion has no closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from scenes.setup import Setup, alone

STIFFNESS = 200.0  # N/m
LENGTH = 1.0  # m, of the relaxed spring; errors are given as fractions of it
GRAVITY = 9.81  # m/s^2
PLACE, VELOCITY = (1.2, 0.0), (0.0, 1.5)  # m from the anchor, and m/s, at the start


def setup() -> Setup:
    """Create the body and its spring, which is anchored at the origin."""
    body = Particle(Vector3(*PLACE), Vector3(*VELOCITY), Vector3(0.0, -GRAVITY))
    return alone(body, AnchoredSpring(Vector3(), STIFFNESS, LENGTH))


def acceleration(position: complex, _: complex) -> complex:
    """Return the acceleration in m/s^2 at a position x + i y in m. It ignores the velocity."""
    return -STIFFNESS * (1.0 - LENGTH / abs(position)) * position - 1j * GRAVITY


def rates(_: float, state: Sequence[float]) -> list[float]:
    """Return the rates of x, y and of the velocities, the equations that SciPy solves."""
    x, y, vx, vy = state
    length = math.hypot(x, y)
    tension = STIFFNESS * (length - LENGTH)
    return [vx, vy, -tension * x / length, -tension * y / length - GRAVITY]
