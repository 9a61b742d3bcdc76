"""Which particles hold on to each other in a world. It is complete."""

from __future__ import annotations

from collections.abc import Iterable

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact

Pair = tuple[Particle, Particle]


def touching(contacts: Iterable[Contact]) -> list[Pair]:
    """Return the pairs of particles that are in contact, and both can move."""
    return [
        (contact.particle, contact.other)
        for contact in contacts
        if contact.other is not None
        and contact.particle.inverse_mass
        and contact.other.inverse_mass
    ]


def joined(registry: ForceRegistry) -> list[Pair]:
    """Return the pairs of particles that a generator joins, and that both can move.

    It joins the particle that it is registered for to those that it keeps as attributes, as a
    spring does its other end.
    """
    return [
        (particle, value)
        for particle, generator in registry.pairs()
        for value in getattr(generator, "__dict__", {}).values()
        if isinstance(value, Particle) and value is not particle
        if particle.inverse_mass and value.inverse_mass
    ]
