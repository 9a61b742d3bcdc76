"""The particle world, which runs a whole simulation step by step (book 8.1).

In each time step it applies the forces, integrates the motion and resolves the contacts, in this
order. Lengths are in m, masses in kg, times in s, and energies in J. Arguments of the wrong type
raise TypeError.
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
    """A set of particles, with the forces, the integrator and the contacts that move them.

    ``particles`` and ``contact_generators`` are copied into new lists, to which you may add later.
    A particle may be listed only once. ``registry`` is a ForceRegistry that starts empty, and
    ``integrator`` can be any integrator of chapter 6. ``resolver`` is a ContactResolver, to which
    ``iterations`` is passed.

    A step can have any number of contacts. The book's world limits this number, and silently
    ignores all contacts beyond the limit.

    Raises:
        ValueError: if a particle is listed twice, or the resolver rejects ``iterations``.
        TypeError: if one of the particles is not a Particle, a generator has no ``contacts()``, or
            the integrator is not callable.
    """

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
            raise TypeError(
                f"integrator must be a callable such as semi_implicit_euler, got {integrator!r}"
            )
        self.registry = ForceRegistry()
        self.resolver = ContactResolver(iterations)
        self.integrator = integrator

    def start_frame(self) -> None:
        """Clear the force accumulators of all particles, at the start of each frame.

        Call this method before you add forces by hand, so that the forces of the previous frame do
        not act twice. Book: section 8.1.
        """
        for particle in self.particles:
            particle.clear_forces()

    def contacts(self) -> list[Contact]:
        """Collect the current contacts of all generators in one list.

        The contacts are in the order of the generators, and no contact is left out.
        """
        return [contact for some in self.contact_generators for contact in some.contacts()]

    def run_physics(self, duration: float) -> None:
        """Move the world forward by one time step of ``duration`` s.

        First let the integrator move the particles. The forces on the particles come from the
        registry, and from calls to ``add_force`` since ``start_frame``. Then call ``contacts()`` on
        each generator once, to find the contacts at the new positions. Finally, resolve all
        contacts with one call to the resolver. If there are no contacts, do not call the resolver.

        Book: section 8.1.
        """
        positive("duration", duration)  # a user's integrator may not check it
        self.integrator(self.particles, self.registry.update_forces, duration)
        contacts = self.contacts()
        if contacts:
            self.resolver.resolve_contacts(contacts, duration)

    def step(self, duration: float) -> None:
        """Clear all forces, and move the world forward by one time step of ``duration`` s.

        Call ``start_frame`` and then ``run_physics``, which a subclass may replace. Forces that you
        added before the call therefore have no effect. If you want to add forces by hand, call
        ``start_frame``, add them, and then call ``run_physics``.
        """
        positive("duration", duration)  # before the forces are cleared
        self.start_frame()
        self.run_physics(duration)


def mechanical_energy(particles: Iterable[Particle]) -> float:
    """Add up the kinetic and potential energy of the particles, in J, to check a simulation.

    The result is the sum of m v^2 / 2 - m a . p, where a is the particle's own acceleration and p
    is its position. For a = (0, -g, 0) this is m v^2 / 2 + m g y. Springs and other generators do
    not contribute, and neither do immovable particles. The energy should stay constant as long as
    there is no damping, no generator adds a force, and no contact is resolved. If there are
    springs, add k x^2 / 2 for each of them, where x is its extension. Particles that are asleep are
    immovable too, so for a SleepingWorld call its own method ``mechanical_energy``.
    """
    return sum(
        particle.kinetic_energy() - particle.mass * particle.acceleration.dot(particle.position)
        for particle in particles
        if particle.inverse_mass
    )
