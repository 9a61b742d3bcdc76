"""Links between two particles, or between a particle and an anchor: cables, rods and limits.

A cable and a rod each have a function that asks how far too long they are, and along which way.
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
        return _taut(self.particle, None, self.anchor, self.max_length, self.restitution)


class Rod:
    """Holds two particles at exactly one distance; what pulls or pushes is not returned."""

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        return _held(self.a, self.b, self.b.position, self.length)


class AnchoredRod:
    """Holds a particle at exactly one distance from an anchor, which may be moved."""

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        return _held(self.particle, None, self.anchor, self.length)


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
        a, b, c = self.a, self.b, self.restitution
        offset = b.position - a.position
        distance = offset.magnitude()
        reached = _taut(a, b, b.position, self.max_length, c)
        if 0.0 < self.min_length >= distance:
            reached.append(Contact(a, b, -direction_of(offset), c, self.min_length - distance))
        return reached


class TwoSidedRod(Rod):
    """Going further, G7.1: a rod that always pulls and pushes, whatever its length is just now."""

    def contacts(self) -> list[Contact]:
        a, b = self.a, self.b
        offset = b.position - a.position
        way, too_long = direction_of(offset), offset.magnitude() - self.length
        return [Contact(a, b, way, 0.0, too_long), Contact(a, b, -way, 0.0, -too_long)]


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    a_particle("a", a)
    if a_particle("b", b) is a:
        raise ValueError(f"b must be another particle than a, got {b!r} twice")
    return a, b


def _taut(
    particle: Particle, other: Particle | None, end: Vector3, length: float, restitution: float
) -> list[Contact]:
    """Return the contact of a cable, in a list, if there is one."""
    offset = end - particle.position
    too_long = offset.magnitude() - length
    if too_long < 0.0:
        return []
    return [Contact(particle, other, direction_of(offset), restitution, too_long)]


def _held(particle: Particle, other: Particle | None, end: Vector3, length: float) -> list[Contact]:
    """Return the contact of a rod, in a list, if there is one."""
    offset = end - particle.position
    too_long = offset.magnitude() - length
    way = direction_of(offset)
    if too_long < 0.0:
        way.invert()
    return [Contact(particle, other, way, 0.0, abs(too_long))] if too_long else []
