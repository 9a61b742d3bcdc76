"""What a simulation starts with: particles, the forces that act on them, and their contacts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ch05_forces.forces import ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle
from scenes.clock import Move

if TYPE_CHECKING:  # a handout for chapter 5 does not have these
    from ch06_springs.integrators import Integrator
    from ch07_constraints.contacts import ContactGenerator


@dataclass(frozen=True)
class Setup:
    """The particles of a scene, the forces that act on them, and what finds their contacts."""

    particles: Sequence[Particle]
    forces: Sequence[tuple[Particle, ForceGenerator]] = ()
    contacts: Sequence[ContactGenerator] = ()

    def registry(self) -> ForceRegistry:
        """Return a new registry with the scene's forces."""
        registry = ForceRegistry()
        for particle, generator in self.forces:
            registry.add(particle, generator)
        return registry

    def moved_by(self, integrator: Integrator) -> Move:
        """Return a function that makes a step with an integrator, without resolving contacts."""
        particles, apply_forces = [*self.particles], self.registry().update_forces
        return lambda duration: integrator(particles, apply_forces, duration)


def alone(particle: Particle, *generators: ForceGenerator) -> Setup:
    """Return the setup of a scene with a single particle, on which all generators act."""
    return Setup([particle], [(particle, generator) for generator in generators])
