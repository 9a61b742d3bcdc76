"""Take the forces that have been added to a particle."""

from __future__ import annotations

from ch05_forces.particle import Particle


def take_forces(particle: Particle) -> tuple[float, float, float]:
    """Return the sum of the forces on a particle in N, and clear it."""
    force = particle.force_accumulator
    particle.clear_forces()
    return force.x, force.y, force.z
