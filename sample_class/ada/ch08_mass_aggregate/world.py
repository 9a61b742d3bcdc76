"""Ada's world."""

from itertools import chain

from ch02_vectors.arguments import positive
from ch05_forces.forces import ForceRegistry
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import some_particles


class ParticleWorld:
    def __init__(
        self,
        particles=(),
        contact_generators=(),
        *,
        iterations=None,
        integrator=semi_implicit_euler,
    ):
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

    def start_frame(self):
        for p in self.particles:
            p.clear_forces()

    def contacts(self):
        return list(chain.from_iterable(g.contacts() for g in self.contact_generators))

    def run_physics(self, duration):
        h = positive("duration", duration)
        self.integrator(self.particles, self.registry.update_forces, h)
        if found := self.contacts():
            self.resolver.resolve_contacts(found, h)

    def step(self, duration):
        h = positive("duration", duration)  # before the forces are gone
        self.start_frame()
        self.run_physics(h)


def mechanical_energy(particles):
    movable = (p for p in particles if p.has_finite_mass)
    return sum(
        (p.mass * (p.velocity @ p.velocity / 2 - p.acceleration @ p.position) for p in movable),
        start=0.0,
    )
