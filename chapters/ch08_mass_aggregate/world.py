"""The particle world, which runs a whole simulation step by step (book 8.1).

In each time step it applies the forces, integrates the motion and resolves the contacts. All units
are SI units. The constructor raises TypeError or ValueError for an invalid argument.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from ch07_constraints.detectors import some_particles


class ParticleWorld:
    """A set of particles, with the forces, the integrator and the contacts that move them.

    ``particles``, which must all be different, and ``contact_generators`` are copied into new
    lists, to which you may add later. ``registry`` is a ForceRegistry that starts empty.
    ``integrator`` is an integrator of chapter 6, and ``iterations`` limits the ContactResolver. A
    step can have any number of contacts, while the book's world ignores those beyond a maximum.
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
            wanted = "integrator must be a callable such as semi_implicit_euler"
            raise TypeError(f"{wanted}, got {integrator!r}")
        self.registry = ForceRegistry()
        self.resolver = ContactResolver(iterations)
        self.integrator = integrator

    def start_frame(self) -> None:
        """Clear the force accumulators of all particles, at the start of each frame.

        Call it before you add forces by hand, so that those of the last frame don't act twice.
        """
        raise NotImplementedError("Exercise B8.2: One time step of the world")

    def contacts(self) -> list[Contact]:
        """Collect the current contacts of all generators in one list.

        They are in the order of the generators, and no contact is left out.
        """
        raise NotImplementedError("Exercise B8.2: One time step of the world")

    def run_physics(self, duration: float) -> None:
        """Move the world forward by one time step of ``duration`` s.

        First let the integrator move the particles, by the forces of the registry and those that
        were added by hand. Then call ``contacts()`` once, to find the contacts at the new
        positions. If there are any, resolve all contacts with one call to the resolver.
        """
        raise NotImplementedError("Exercise B8.2: One time step of the world")

    def step(self, duration: float) -> None:
        """Clear all forces, and move the world forward by one time step of ``duration`` s.

        Call ``start_frame`` and then ``run_physics``, which a subclass may replace.
        """
        raise NotImplementedError("Exercise B8.2: One time step of the world")


def mechanical_energy(particles: Iterable[Particle]) -> float:
    """Add up the kinetic and potential energy of the particles, in J.

    The result is the sum of m v^2 / 2 - m a . p, where a is the particle's own acceleration and p
    is its position. For a = (0, -g, 0) this is m v^2 / 2 + m g y. Springs and other generators do
    not contribute, and neither do immovable particles, among them those that sleep.
    """
    raise NotImplementedError("Exercise B8.1: Mechanical energy")
