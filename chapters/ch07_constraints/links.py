"""Links between two particles, or between a particle and an anchor: cables, rods and limits.

A link is a contact generator. ``contacts()`` returns a contact for each limit of its length that is
reached, and resolving the contact restores the length. Within its limits a link has no contact.

Lengths are in m. Constructors raise ValueError for a length that is not positive, a restitution
outside 0 to 1 and anything that is not finite, and TypeError for an argument of the wrong type. You
may change the attributes later, as a winch does, but these changes are not checked.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution


class Cable:
    """Keeps two particles at most ``max_length`` apart (7.4.1).

    ``restitution`` is the ratio of the speed after the cable snaps taut to the speed before.
    """

    def __init__(
        self, a: Particle, b: Particle, max_length: float, restitution: float = 0.0
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact if the cable is taut, that is, ``max_length`` long or longer.

        The contact's ``particle`` is a and its ``other`` is b. Its normal points from a to b, and
        its penetration is the length beyond ``max_length``.
        """
        raise NotImplementedError("Exercise B7.7: Cables")


class AnchoredCable:
    """Keeps a particle at most ``max_length`` from an anchor, which is a fixed position (7.4.1)."""

    def __init__(
        self, particle: Particle, anchor: Vector3, max_length: float, restitution: float = 0.0
    ) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact if the cable is taut.

        The contact's ``other`` is None, and its normal points to the anchor.
        """
        raise NotImplementedError("Exercise B7.7: Cables")


class Rod:
    """Keeps two particles at exactly ``length`` from each other (7.4.2)."""

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact if the rod is too long or too short, and no contact otherwise.

        The contact's ``particle`` is a and its ``other`` is b. Its normal points from a to b if the
        rod is too long, and away from b if the rod is too short. Its penetration is the difference
        from ``length``, always positive, and its restitution is 0. If both ends are at the same
        position, use +Y as the direction from a to b. The book's text uses two contacts per rod,
        but one is enough, as in its listing (E-9).
        """
        raise NotImplementedError("Exercise B7.8: Rods")


class AnchoredRod:
    """Keeps a particle at exactly ``length`` from an anchor (7.4.2)."""

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact if the rod is too long or too short, and no contact otherwise.

        The contact is that of a Rod, with the anchor in place of b and with None as ``other``.
        """
        raise NotImplementedError("Exercise B7.8: Rods")


class Limits:
    """Exercise 7.6: keeps the distance between two particles within two limits.

    The distance may be from ``min_length`` to ``max_length``. A ``min_length`` of 0 means that
    there is no lower limit. The constructor also raises ValueError if ``min_length`` is negative or
    greater than ``max_length``.
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
            wanted = f"min_length must be at most max_length, {max_length!r}"
            raise ValueError(f"{wanted}, got {min_length!r}")
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Exercise 7.6: return a contact for each limit that is reached or passed.

        At ``max_length`` or above, the contact is that of a Cable. At ``min_length`` or below, its
        normal points away from b, and its penetration is ``min_length`` minus the distance. If both
        limits are reached, return both contacts in this order. If both ends are at the same
        position, use +Y as the direction from a to b. Each contact has the link's restitution.
        """
        raise NotImplementedError("Exercise 7.6: A link with two limits")


class TwoSidedRod(Rod):
    """Going further, G7.1: a rod that always has both a contact that pulls and one that pushes.

    A Rod that has the right length, or is a little too short, has no contact that pulls. If its
    ends fly apart, nothing stops them for one step. In a chain, correcting one rod makes the next
    one wrong. So a pull travels only about one link per step, however many iterations there are.
    Two contacts per rod avoid that delay.
    """

    def contacts(self) -> list[Contact]:
        """G7.1: return two contacts in every case: one that pulls, then one that pushes.

        The first is like the contact of a Cable: its normal points from a to b. Its penetration is
        the distance minus ``length`` and may be negative. The second has the opposite normal and
        the opposite penetration. The velocity phase then stops the ends in both directions. If both
        ends are at the same position, use +Y as the direction from a to b.
        """
        raise NotImplementedError("Exercise G7.1: Going further: two-sided rods")


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    """Return both ends. Raise TypeError for a wrong type, ValueError if both are the same."""
    instance_of("a", a, Particle)
    if instance_of("b", b, Particle) is a:
        raise ValueError(f"a and b must be two different particles, got {b!r} twice")
    return a, b
