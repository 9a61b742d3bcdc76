"""Going further: use springs to keep particles out of the ground, and see why this fails (E-36)."""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import spring_force


class PenaltyGround:
    """Level ground that pushes particles out as a spring would, but never pulls them.

    ``height`` is in m, ``stiffness`` in N/m and ``damping`` in N s/m. They raise ValueError and
    TypeError as in springs.py. If the ground is soft, a body of mass m that rests on it sinks in by
    m g / k. If it is hard, it throws bodies back higher than they fell from.
    """

    def __init__(self, height: float, stiffness: float, damping: float = 0.0) -> None:
        self.height = finite("height", height)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Push a particle upward if it is below the ground, with the force k depth - c v_y.

        Here k is ``stiffness``, c is ``damping``, and v_y is the upward velocity of the particle.
        Add the force only if it is positive. The ground must never pull.
        """
        offset = Vector3(0.0, particle.position.y - self.height, 0.0)  # from the surface
        if offset.y < 0.0:
            push = spring_force(offset, particle.velocity, self.stiffness, 0.0, self.damping)
            particle.add_force(Vector3(0.0, max(push.y, 0.0), 0.0))
