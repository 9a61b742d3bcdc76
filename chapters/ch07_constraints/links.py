"""Links between two particles, or between a particle and an anchor: cables, rods and limits.

A link is a contact generator: ``contacts()`` returns a contact for each limit of its length that is
reached, whose resolution brings the length back. A link that is within its limits has none.

Lengths are in m. What a link is made with is looked at: ValueError names a length that is not
positive, a restitution that is not from 0 to 1, and what is not finite; TypeError what is no
number, no Vector3 or no Particle. Attributes may be changed later, as for a winch, and are then
yours to keep right.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution


class Cable:
    """Holds two particles together: they are never more than ``max_length`` apart (7.4.1).

    ``restitution`` is how much of its speed a cable that snaps taut returns.
    """

    def __init__(
        self, a: Particle, b: Particle, max_length: float, restitution: float = 0.0
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact where the cable is taut: as long as it may be, or longer.

        Its particle is a, its other b, its normal leads from a to b, and its penetration is what
        the cable is too long.
        """
        raise NotImplementedError("Exercise B7.7: Cables")


class AnchoredCable:
    """Holds a particle to an anchor, a place that nothing pulls away; it may be moved (7.4.1)."""

    def __init__(
        self, particle: Particle, anchor: Vector3, max_length: float, restitution: float = 0.0
    ) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact with no other where the cable is taut; its normal is to the anchor."""
        raise NotImplementedError("Exercise B7.7: Cables")


class Rod:
    """Holds two particles at exactly one distance; what pulls or pushes is not returned (7.4.2)."""

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact where the rod is too long or too short, and none where it is neither.

        Its particle is a and its other b. Its normal leads from a to b where the rod is too long,
        and away from b where it is too short; its penetration is how much that is, and its
        restitution 0. Ends at one place have no direction: +Y stands for the one from a to b. The
        book's text has two contacts for each rod, its listing one, which is enough (E-9).
        """
        raise NotImplementedError("Exercise B7.8: Rods")


class AnchoredRod:
    """Holds a particle at exactly one distance from an anchor, which may be moved (7.4.2)."""

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact with no other, as a Rod does: to the anchor where it is too long."""
        raise NotImplementedError("Exercise B7.8: Rods")


class Limits:
    """Exercise 7.6: keeps two particles at least and at most so far apart.

    Raises ValueError where ``min_length`` is negative, or above ``max_length``, as well. At a
    ``min_length`` of 0 there is no lower limit.
    """

    def __init__(
        self,
        a: Particle,
        b: Particle,
        min_length: float,
        max_length: float,
        restitution: float = 0.0,
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.min_length = not_negative("min_length", min_length)
        self.max_length = positive("max_length", max_length)
        if self.min_length > self.max_length:
            wanted = f"min_length must be max_length, {max_length!r}, or less"
            raise ValueError(f"{wanted}, got {min_length!r}")
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Exercise 7.6: return a contact for each limit that is reached or passed.

        At max_length it is a cable's. At min_length its normal leads away from b, and its
        penetration is what the ends are too near. Where both limits are equal, and reached, both
        contacts are there. Ends at one place have no direction: +Y stands for the one from a to b.
        """
        raise NotImplementedError("Exercise 7.6: A link with two limits")


class TwoSidedRod(Rod):
    """Going further, G7.1: a rod that always pulls and pushes, whatever its length is just now.

    A Rod whose length is exact, or a little short, does not see that its ends fly apart, and lets
    them go for a frame. In a chain each rod that is put right makes the next one wrong, so that a
    pull passes on by about a link a frame, however many iterations there are.
    """

    def contacts(self) -> list[Contact]:
        """G7.1: return two contacts, always: one that pulls the ends together, one that pushes.

        The one that pulls comes first; it is a cable's, with the normal from a to b. The one that
        pushes has the opposite normal and the opposite penetration, so one of the two is negative
        unless both are 0. So the velocity phase sees the rod whichever way its ends move.
        """
        raise NotImplementedError("Exercise G7.1: Going further: rods with two sides")


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    """Return both ends; TypeError for what is no Particle, ValueError where they are the same."""
    instance_of("a", a, Particle)
    if instance_of("b", b, Particle) is a:
        raise ValueError(f"b must be another particle than a, got {b!r} twice")
    return a, b
