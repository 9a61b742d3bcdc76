"""Which particles hold on to each other in a world. It is complete."""

from __future__ import annotations

from collections.abc import Iterable

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact

Pair = tuple[Particle, Particle]


def joined(contacts: Iterable[Contact], registry: ForceRegistry) -> list[Pair]:
    """Return pairs of particles that can move, and are in contact or joined by a generator.

    A generator joins the particle that it is registered for to those that it keeps as attributes,
    as a spring does its other end.
    """
    pairs = [(contact.particle, contact.other) for contact in contacts]
    for particle, generator in registry._pairs:
        for value in getattr(generator, "__dict__", {}).values():
            if isinstance(value, Particle) and value is not particle:
                pairs.append((particle, value))
    return [(a, b) for a, b in pairs if b is not None and a.inverse_mass and b.inverse_mass]
