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
"""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.arguments import not_negative, positive
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator


class SmallSteps:
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
        positive("duration", duration)
        starts = []
        for particle in self.particles:
            starts.append(particle.position.copy())
            particle.kick(duration)
            particle.drift(duration)
        softness = self.compliance / (duration * duration)  # 1/kg, like an inverse mass
        bounces = []
        for generator in self.generators:
            for contact in generator.contacts():
                if contact.restitution and contact.separating_velocity() < 0.0:
                    bounces.append((contact, contact.velocity_after(duration)))
                correct(contact, softness)
        for particle, start in zip(self.particles, starts, strict=True):
            if particle.inverse_mass:
                position, velocity = particle.position, particle.velocity
                velocity.x = (position.x - start.x) / duration
                velocity.y = (position.y - start.y) / duration
                velocity.z = (position.z - start.z) / duration
        for contact, wanted in bounces:
            bounce(contact, wanted)


def correct(contact: Contact, softness: float) -> None:
    a, b = contact.particle, contact.other
    inverse_b = 0.0 if b is None else b.inverse_mass
    total = a.inverse_mass + inverse_b + softness
    if contact.penetration > 0.0 and total:
        part = contact.penetration / total
        a.position.add_scaled(contact.normal, part * a.inverse_mass)
        if b is not None:
            b.position.add_scaled(contact.normal, -part * inverse_b)


def bounce(contact: Contact, wanted: float) -> None:
    a, b = contact.particle, contact.other
    inverse_b = 0.0 if b is None else b.inverse_mass
    impulse = (wanted - contact.separating_velocity()) / (a.inverse_mass + inverse_b)
    a.velocity.add_scaled(contact.normal, impulse * a.inverse_mass)
    if b is not None:
        b.velocity.add_scaled(contact.normal, -impulse * inverse_b)
