"""Going further: collisions by springs, and how they fail."""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class PenaltyGround:
    """A level ground that pushes out by a spring what has sunk into it, and never pulls."""

    def __init__(self, height: float, stiffness: float, damping: float = 0.0) -> None:
        self.height = finite("height", height)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        if (depth := self.height - particle.position.y) > 0.0:
            push = self.stiffness * depth - self.damping * particle.velocity.y
            particle.add_force(Vector3(0.0, max(push, 0.0), 0.0))
