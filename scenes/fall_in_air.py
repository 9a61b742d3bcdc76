"""Bodies that fall from rest, with drag from the air."""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.particle import Particle
from scenes.setup import Setup

G = 9.81  # m/s^2


def falling(bodies: Iterable[tuple[float, float, float]], height: float = 0.0) -> Setup:
    """Create bodies at rest at a height in m, from a mass in kg and the k1 and k2 of its drag."""
    particles, forces = [], []
    for mass, k1, k2 in bodies:
        body = Particle(Vector3(0.0, height), acceleration=Vector3(0.0, -G), mass=mass)
        particles.append(body)
        if k1 or k2:
            forces.append((body, Drag(k1, k2)))
    return Setup(particles, forces)
