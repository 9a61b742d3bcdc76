"""Going further: soft constraints with small steps, known as XPBD.

Instead of applying impulses, this solver corrects positions, and then computes the velocities from
the distances that the particles have moved. Each constraint has a compliance, which is the inverse
of a stiffness. A rope with a compliance of 0.001 m/N becomes 1 mm longer for each newton of pull,
and a compliance of 0 makes a constraint hard. The solver stays stable at any stiffness, because its
corrections are those of an implicit step.

Each constraint is corrected once per step. If that is not accurate enough, use shorter steps
instead of more iterations. For the same work they give a much smaller error (Macklin and others,
"Small Steps in Physics Simulation", 2019). The solver does not store anything from one step to the
next.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.arguments import not_negative, positive
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator


class SmallSteps:
    """A solver that steps particles, and enforces their contacts and links by moving them.

    ``generators`` are contact generators of this chapter. ``compliance`` is in m/N, and is the same
    for all of them. Call ``step`` several times per frame, each time with a fraction of the frame's
    duration.

    Raises:
        ValueError: if ``compliance`` is negative or not finite.
    """

    def __init__(
        self,
        particles: Iterable[Particle],
        generators: Iterable[ContactGenerator],
        compliance: float = 0.0,
    ) -> None:
        self.particles = [*particles]
        self.generators = [*generators]
        self.compliance = not_negative("compliance", compliance)

    def step(self, duration: float) -> None:
        """Move the particles by one step of ``duration`` s under the forces in the accumulators.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        starts = [particle.position.copy() for particle in self.particles]
        for particle in self.particles:
            particle.kick(duration)
            particle.drift(duration)
        bounces = self._correct(duration)
        for particle, start in zip(self.particles, starts, strict=True):
            if particle.inverse_mass:
                particle.velocity = (particle.position - start) / duration
        for contact, wanted in bounces:
            bounce(contact, wanted)

    def _correct(self, duration: float) -> list[tuple[Contact, float]]:
        """Correct all contacts, and return those that bounce, with the velocities they must get."""
        softness = self.compliance / duration**2  # 1/kg, like an inverse mass
        bounces = []
        for generator in self.generators:
            for contact in generator.contacts():
                if contact.restitution and contact.separating_velocity() < 0.0:
                    bounces.append((contact, contact.velocity_after(duration)))
                correct(contact, softness)
        return bounces


def correct(contact: Contact, softness: float) -> None:
    """Move the two particles apart by the full depth, or by less if the contact is soft.

    The depth is divided into three parts. The first two are the displacements of the particles, in
    proportion to their inverse masses. The third part is proportional to ``softness``, and remains
    as an overlap.
    """
    movable = contact.total_inverse_mass()
    if movable:
        contact.penetration *= movable / (movable + softness)
        contact.resolve_penetration()


def bounce(contact: Contact, wanted: float) -> None:
    """Apply the impulse that gives the two particles the separating velocity ``wanted``, in m/s."""
    a, b = contact.particle, contact.other
    change = wanted - contact.separating_velocity()
    impulse = contact.normal * (change / contact.total_inverse_mass())
    a.velocity += impulse * a.inverse_mass
    if b is not None:
        b.velocity -= impulse * b.inverse_mass
