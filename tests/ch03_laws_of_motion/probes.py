"""What must run beside the student's code: loops of steps.

Each function takes and returns plain numbers.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

Components = tuple[float, float, float]


def velocity_after(velocity: Components, damping: float, frames: Sequence[float]) -> Components:
    """Integrate a particle without acceleration over these frames and return its velocity."""
    particle = Particle(velocity=Vector3(*velocity), damping=damping)
    for duration in frames:
        particle.integrate(duration)
    return particle.velocity.x, particle.velocity.y, particle.velocity.z


def position_after_fall(gravity: float, duration: float, steps: int) -> Components:
    """Let a particle fall from rest at the origin and return its position."""
    particle = Particle(acceleration=Vector3(0.0, -gravity, 0.0))
    for _ in range(steps):
        particle.integrate(duration)
    return particle.position.x, particle.position.y, particle.position.z


def kicks_of_a_step(
    position: Components, velocity: Components, duration: float
) -> list[tuple[float, Components]]:
    """Integrate a particle with a kick of its own; return the duration and position of each."""
    kicks: list[tuple[float, Components]] = []

    class Kicked(Particle):
        def kick(self, duration: float) -> None:
            kicks.append((duration, (self.position.x, self.position.y, self.position.z)))

    Kicked(Vector3(*position), Vector3(*velocity)).integrate(duration)
    return kicks
