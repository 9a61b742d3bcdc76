"""Going further: collisions by springs, and how they fail (E-36; the book has no such exercise)."""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class PenaltyGround:
    """A level ground that pushes out by a spring what has sunk into it, and never pulls.

    ``height`` is in m, ``stiffness`` in N/m, ``damping`` in N s/m. A soft ground is a sponge: what
    lies on it has sunk in by m g / k. A hard one needs short frames: it begins to push only when a
    frame ends below it, and pushes for all of the next one. So without damping it may throw bodies
    higher than they fell from, unless k h^2 / m is far below 1; beyond 4 it throws even what lies.

    Raises ValueError where the height is not finite, or another one is negative or not finite.
    """

    def __init__(self, height: float, stiffness: float, damping: float = 0.0) -> None:
        self.height = finite("height", height)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add k depth - c v_y upwards where that pushes, for a particle below the ground.

        v_y is the particle's velocity upwards, so a damped ground pushes less on what is on its way
        out; it does not hold it back.
        """
        depth = self.height - particle.position.y
        if depth > 0.0:
            push = self.stiffness * depth - self.damping * particle.velocity.y
            particle.add_force(Vector3(0.0, max(push, 0.0), 0.0))
