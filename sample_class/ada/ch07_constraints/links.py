"""Links between two particles, or between a particle and an anchor: cables, rods and limits.

Every link asks one function how far too long it is, and along which way.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_particle, a_restitution, direction_of


class Cable:
    """Holds two particles together: they are never more than ``max_length`` apart."""

    def __init__(
        self, a: Particle, b: Particle, max_length: float, restitution: float = 0.0
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact where the cable is taut: as long as it may be, or longer."""
        return _taut(self.a, self.b, self.b.position, self.max_length, self.restitution)


class AnchoredCable:
    """Holds a particle to an anchor, a place that nothing pulls away; it may be moved."""

    def __init__(
        self, particle: Particle, anchor: Vector3, max_length: float, restitution: float = 0.0
    ) -> None:
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact with no other where the cable is taut; its normal is to the anchor."""
        return _taut(self.particle, None, self.anchor, self.max_length, self.restitution)


class Rod:
    """Holds two particles at exactly one distance; what pulls or pushes is not returned."""

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact where the rod is too long or too short, and none where it is neither."""
        pull, push = _both(self.a, self.b, self.b.position, self.length)
        return [contact for contact in (pull, push) if contact.penetration > 0.0]


class AnchoredRod:
    """Holds a particle at exactly one distance from an anchor, which may be moved."""

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a contact with no other, as a Rod does: to the anchor where it is too long."""
        pull, push = _both(self.particle, None, self.anchor, self.length)
        return [contact for contact in (pull, push) if contact.penetration > 0.0]


class Limits:
    """Exercise 7.6: keeps two particles at least and at most so far apart."""

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
        """Exercise 7.6: return a contact for each limit that is reached or passed."""
        a, b, c = self.a, self.b, self.restitution
        reached = _taut(a, b, b.position, self.max_length, c)
        if self.min_length:
            _, push = _both(a, b, b.position, self.min_length, c)
            reached += [push] * (push.penetration >= 0.0)
        return reached


class TwoSidedRod(Rod):
    """Going further, G7.1: a rod that always pulls and pushes, whatever its length is just now."""

    def contacts(self) -> list[Contact]:
        """G7.1: return two contacts, always: one that pulls the ends together, one that pushes."""
        return [*_both(self.a, self.b, self.b.position, self.length)]


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    """Return both ends; TypeError for what is no Particle, ValueError where they are the same."""
    a_particle("a", a)
    if a_particle("b", b) is a:
        raise ValueError(f"b must be another particle than a, got {b!r} twice")
    return a, b


def _both(
    particle: Particle,
    other: Particle | None,
    end: Vector3,
    length: float,
    restitution: float = 0.0,
) -> tuple[Contact, Contact]:
    """Return what pulls a particle to an end, and what pushes it away, if it is to be so far."""
    offset = end - particle.position
    way = direction_of(offset)
    too_long = offset.magnitude() - length
    return (
        Contact(particle, other, way, restitution, too_long),
        Contact(particle, other, -way, restitution, 0.0 - too_long),
    )


def _taut(
    particle: Particle, other: Particle | None, end: Vector3, length: float, restitution: float
) -> list[Contact]:
    """Return the contact of a cable, in a list, if there is one."""
    pull, _ = _both(particle, other, end, length, restitution)
    return [pull] if pull.penetration >= 0.0 else []
