"""World."""

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
        for particle in self.particles:
            particle.clear_forces()

    def contacts(self):
        result = []
        for generator in self.contact_generators:
            result.extend(generator.contacts())
        return result

    def run_physics(self, duration):
        positive("duration", duration)
        self.integrator(self.particles, self.registry.update_forces, duration)
        contacts = self.contacts()
        if len(contacts) > 0:
            self.resolver.resolve_contacts(contacts, duration)

    def step(self, duration):
        positive("duration", duration)
        self.start_frame()
        self.run_physics(duration)


def mechanical_energy(particles):
    energy = 0.0
    for particle in particles:
        if particle.inverse_mass == 0:
            continue
        kinetic = particle.mass * particle.velocity.squared_magnitude() / 2
        potential = -particle.mass * particle.acceleration.dot(particle.position)
        energy += kinetic + potential
    return energy
