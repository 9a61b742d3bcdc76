"""The particle world of chapter 8, which clears the sums of forces itself."""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.arguments import positive
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from ch07_constraints.detectors import some_particles


class ParticleWorld:
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
            raise ValueError("particles must all be different, got one of them twice")
        self.contact_generators = [*contact_generators]
        for i, generator in enumerate(self.contact_generators):
            if not callable(getattr(generator, "contacts", None)):
                wanted = f"contact_generators[{i}] must have contacts()"
                raise TypeError(f"{wanted}, got {generator!r}")
        if not callable(integrator):
            wanted = "integrator must be a callable such as semi_implicit_euler"
            raise TypeError(f"{wanted}, got {integrator!r}")
        self.registry = ForceRegistry()
        self.resolver = ContactResolver(iterations)
        self.integrator = integrator

    def start_frame(self) -> None:
        for particle in self.particles:
            particle._forces[0] = None

    def contacts(self) -> list[Contact]:
        found: list[Contact] = []
        for generator in self.contact_generators:
            found += generator.contacts()
        return found

    def run_physics(self, duration: float) -> None:
        positive("duration", duration)
        self.integrator(self.particles, self.registry.update_forces, duration)
        contacts = self.contacts()
        if contacts:
            self.resolver.resolve_contacts(contacts, duration)

    def step(self, duration: float) -> None:
        self.start_frame()
        self.run_physics(duration)


def mechanical_energy(particles: Iterable[Particle]) -> float:
    return sum(
        particle.kinetic_energy() - particle.mass * particle.acceleration.dot(particle.position)
        for particle in particles
        if particle.inverse_mass
    )
