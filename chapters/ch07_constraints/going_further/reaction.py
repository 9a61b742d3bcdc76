"""The reaction force of the ground, another way to keep a resting particle at rest (book 7.2.3).

This file is complete, so there is nothing to fill in. Impulses let gravity accelerate a resting
particle in every step, and then take the velocity away again. A reaction force cancels the
acceleration itself, so there is nothing to take away.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import DEPTH_TOLERANCE, VELOCITY_TOLERANCE


class ReactionForce:
    """A force generator that holds up spheres on level ground at ``height`` m.

    If a sphere of ``radius`` m touches the ground and does not move up, the force cancels the part
    of its acceleration that points into the ground. Some things it cannot do:

    - It knows only the forces that were added before. Register it after all other generators of a
      particle, and add forces by hand before you update the registry.
    - It does not stop a sphere that already moves into the ground. Resolve the contacts as usual.
    - It knows nothing of the weight of spheres that lie on top. Contacts have to carry them.

    Raises:
        ValueError: if the height is not finite, or the radius is negative or not finite.
    """

    def __init__(self, height: float = 0.0, radius: float = 0.0) -> None:
        self.height = finite("height", height)
        self.radius = not_negative("radius", radius)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force that the ground needs to hold ``particle``, unless it is moving up."""
        gap = particle.position.y - self.radius - self.height
        if gap > DEPTH_TOLERANCE or particle.velocity.y > VELOCITY_TOLERANCE:
            return
        if particle.inverse_mass:
            push = particle.force_accumulator.y + particle.mass * particle.acceleration.y
            particle.add_force(Vector3(0.0, max(0.0, -push), 0.0))
