"""Loops of steps, which must run beside the student's code. They take and return plain numbers."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

Components = tuple[float, float, float]


def position_after_fall(gravity: float, duration: float, steps: int) -> Components:
    """Let a particle fall from rest at the origin and return its position."""
    particle = Particle(acceleration=Vector3(0.0, -gravity, 0.0))
    for _ in range(steps):
        particle.integrate(duration)
    return particle.position.x, particle.position.y, particle.position.z


def kicks_of_a_step(
    position: Components, velocity: Components, duration: float
) -> list[tuple[float, Components]]:
    """Integrate a particle that overrides kick; return duration and position at each call."""
    kicks: list[tuple[float, Components]] = []

    class Kicked(Particle):
        def kick(self, duration: float) -> None:
            kicks.append((duration, (self.position.x, self.position.y, self.position.z)))

    Kicked(Vector3(*position), Vector3(*velocity)).integrate(duration)
    return kicks
