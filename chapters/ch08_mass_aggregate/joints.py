"""Find out which particles of a world are connected to each other. This file is complete.

Two particles are connected if they touch, or if the force on one of them depends on the other. To
find such pairs, this file reads the attributes of contacts and force generators. A contact stores
its two particles in attributes. A force generator must likewise store the particles on which its
force depends in public attributes. The generators of chapters 6 and 8 already do so, because they
store every argument of this kind under its own name.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact

Pair = tuple[Particle, Particle]

# A Spring has other, a Connection and a Bond have a and b, a HomingBullet has target, a RimDrive
# has hub, and an Overcrowding has particles.
PARTNERS = ("other", "a", "b", "target", "hub", "particles")


def touching(contacts: Iterable[Contact]) -> list[Pair]:
    """Return the pairs of movable particles that are in contact."""
    return [
        (contact.particle, contact.other)
        for contact in contacts
        if contact.other is not None
        and contact.particle.inverse_mass
        and contact.other.inverse_mass
    ]


def joined(registry: ForceRegistry) -> list[Pair]:
    """Return the pairs of movable particles that a force generator joins.

    A generator joins the particle for which it is registered to each particle that
    ``partners(generator)`` returns.
    """
    return [
        (particle, partner)
        for particle, generator in registry.pairs()
        for partner in partners(generator)
        if partner is not particle and particle.inverse_mass and partner.inverse_mass
    ]


def partners(generator: object) -> list[Particle]:
    """Return the particles that ``generator`` stores in the attributes listed in PARTNERS.

    The value of such an attribute is a particle, or a list or tuple of particles. Any other value
    is ignored.

    If you write a generator whose force depends on other particles, give it one of these
    attributes. If it stores the particles in some other way, give it a property called
    ``particles``. A generator without such an attribute joins nothing. The particles that it pushes
    then sleep independently of each other, and wake when the push changes.
    """
    found: list[Particle] = []
    for name in PARTNERS:
        value = getattr(generator, name, None)
        several = value if isinstance(value, (list, tuple)) else [value]
        found += [one for one in several if isinstance(one, Particle)]
    return found
