"""The world: particles, forces and contacts, put together frame by frame (book 8.1).

Lengths are in m, masses in kg, times in s, energies in J.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.arguments import positive
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from ch07_constraints.detectors import some_particles


class ParticleWorld:
    """Particles that a frame moves on: by forces, an integrator, and the contacts that follow."""

    def __init__(
        self,
        particles: Iterable[Particle] = (),
        contact_generators: Iterable[ContactGenerator] = (),
        *,
        iterations: int | None = None,
        integrator: Integrator = semi_implicit_euler,
    ) -> None:
        self.particles = [*some_particles([*particles])]
        if len(set(map(id, self.particles))) < len(self.particles):
            raise ValueError("particles must be different ones, got one of them twice")
        self.contact_generators = [*contact_generators]
        for i, generator in enumerate(self.contact_generators):
            if not callable(getattr(generator, "contacts", None)):
                wanted = f"contact_generators[{i}] must have contacts()"
                raise TypeError(f"{wanted}, got {generator!r}")
        if not callable(integrator):
            raise TypeError(f"integrator must be a step of chapter 6, got {integrator!r}")
        self.registry = ForceRegistry()
        self.resolver = ContactResolver(iterations)
        self.integrator = integrator

    def start_frame(self) -> None:
        for one in self.particles:
            one.clear_forces()

    def contacts(self) -> list[Contact]:
        found: list[Contact] = []
        for generator in self.contact_generators:
            found.extend(generator.contacts())
        return found

    def run_physics(self, duration: float) -> None:
        positive("duration", duration)
        self.integrator(self.particles, self.registry.update_forces, duration)
        touching = self.contacts()
        if touching:
            self.resolver.resolve_contacts(touching, duration)

    def step(self, duration: float) -> None:
        positive("duration", duration)  # before the forces are cleared
        self.start_frame()
        self.run_physics(duration)


def mechanical_energy(particles: Iterable[Particle]) -> float:
    total = 0.0
    for one in particles:
        if one.has_finite_mass:
            total += one.kinetic_energy() - one.mass * one.acceleration.dot(one.position)
    return total
