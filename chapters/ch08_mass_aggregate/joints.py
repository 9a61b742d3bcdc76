"""Which particles hold on to each other in a world. It is complete.

Contacts name their particles. A force generator names the particles that its force depends on by
public attributes, and those of chapters 6 and 8 do so already: they keep them under the names of
their arguments.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact

Pair = tuple[Particle, Particle]

# A Spring has an other, a Connection or a Bond has a and b, a HomingBullet has a target, a RimDrive
# has a hub, and an Overcrowding has particles.
PARTNERS = ("other", "a", "b", "target", "hub", "particles")


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
    """Return the pairs of particles that a force generator joins, and that both can move.

    A generator joins the particle that it is registered for to each of its partners.
    """
    return [
        (particle, partner)
        for particle, generator in registry.pairs()
        for partner in partners(generator)
        if partner is not particle and particle.inverse_mass and partner.inverse_mass
    ]


def partners(generator: object) -> list[Particle]:
    """Return the particles that a generator names by its attributes in PARTNERS.

    Such an attribute is a particle, or a list or tuple of particles; anything else is no partner.
    A generator of your own takes part if it has one of them. A property `particles` will do, where
    the particles are kept in some other way. A generator without them joins nothing. What it pushes
    then sleeps without regard to other particles, and wakes when the push changes.
    """
    found: list[Particle] = []
    for name in PARTNERS:
        value = getattr(generator, name, None)
        several = value if isinstance(value, (list, tuple)) else [value]
        found += [one for one in several if isinstance(one, Particle)]
    return found
