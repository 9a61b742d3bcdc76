"""Links that limit the distance between two particles, or a particle and an anchor.

A link is a contact generator. Its contacts have ``a`` as ``particle`` and ``b`` as ``other``, or
None for a fixed ``anchor``. A link that is too long pulls: the normal points from ``particle`` to
the other end. A link that is too short pushes: the normal points away from the other end. The
penetration is the difference in length. If both ends are at the same position, use +Y as the
direction to the other end, as ``direction_of`` of contacts.py does. ``contacts()`` changes nothing.

Lengths are in m. Constructors raise ValueError for a number that is out of range, and TypeError for
an argument of the wrong type. Later changes of the attributes are not checked. Book: section 7.4.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution, direction_of


class Cable:
    """A cable that keeps two particles at most ``max_length`` m apart.

    ``restitution`` is the speed at which the ends approach after the cable has become taut, divided
    by the speed at which they moved apart before.
    """

    def __init__(
        self, a: Particle, b: Particle, max_length: float, restitution: float = 0.0
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the cable is taut (at least ``max_length`` long).

        A slack cable has no contact, so the list is empty.
        """
        offset = self.b.position - self.a.position
        pull = _pull(self.a, self.b, offset, self.max_length, self.restitution)
        return [pull] if pull.penetration >= 0.0 else []


class AnchoredCable:
    """A cable that keeps a particle at most ``max_length`` m away from a fixed ``anchor``."""

    def __init__(
        self, particle: Particle, anchor: Vector3, max_length: float, restitution: float = 0.0
    ) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a list as ``Cable`` does, with the anchor in place of ``b``."""
        offset = self.anchor - self.particle.position
        pull = _pull(self.particle, None, offset, self.max_length, self.restitution)
        return [pull] if pull.penetration >= 0.0 else []


class Rod:
    """A rod that keeps two particles exactly ``length`` m apart."""

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the rod is too short or too long.

        Penetrations are positive, and the restitution is 0. If the length is exactly right, the
        list is empty. This is the rod of the book's listing.
        """
        offset = self.b.position - self.a.position
        sides = _sides(self.a, self.b, offset, self.length)
        return [side for side in sides if side.penetration > 0.0]


class AnchoredRod:
    """A rod to a fixed ``anchor``. You can hang a pendulum from it, for example."""

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a list as ``Rod`` does, with the anchor in place of ``b``."""
        offset = self.anchor - self.particle.position
        sides = _sides(self.particle, None, offset, self.length)
        return [side for side in sides if side.penetration > 0.0]


class Limits:
    """Exercise 7.6: a link that keeps two particles from getting too close or too far apart.

    A ``min_length`` of 0 means no lower limit. It must not be greater than ``max_length``.
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
            wanted = f"min_length must be at most max_length ({max_length!r})"
            raise ValueError(f"{wanted}, got {min_length!r}")
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Exercise 7.6: return a contact for each limit that is reached or passed.

        At ``max_length`` or more the link pulls, and at ``min_length`` or less it pushes. If both
        limits are reached, return both contacts, in this order, each with the link's restitution.
        """
        offset = self.b.position - self.a.position
        limits = [_pull(self.a, self.b, offset, self.max_length, self.restitution)]
        if self.min_length:
            limits.append(_push(self.a, self.b, offset, self.min_length, self.restitution))
        return [limit for limit in limits if limit.penetration >= 0.0]


class TwoSidedRod(Rod):
    """G7.1: a rod with two contacts in every step, as the book's text asks for (erratum E-9)."""

    def contacts(self) -> list[Contact]:
        """G7.1: always return two contacts: first one that pulls, then one that pushes.

        The penetration of the first is the distance minus ``length``, which may be negative. The
        second contact has the opposite normal and the opposite penetration.
        """
        offset = self.b.position - self.a.position
        return _sides(self.a, self.b, offset, self.length)


def _pull(
    particle: Particle, other: Particle | None, offset: Vector3, length: float, restitution: float
) -> Contact:
    """Return the contact of a link that must not be longer than ``length``."""
    excess = offset.magnitude() - length
    return Contact(particle, other, direction_of(offset), restitution, excess)


def _push(
    particle: Particle, other: Particle | None, offset: Vector3, length: float, restitution: float
) -> Contact:
    """Return the contact of a link that must not be shorter than ``length``."""
    lack = length - offset.magnitude()
    return Contact(particle, other, -direction_of(offset), restitution, lack)


def _sides(
    particle: Particle, other: Particle | None, offset: Vector3, length: float
) -> list[Contact]:
    """Return both contacts of a rod: the one that pulls, and the one that pushes."""
    return [
        _pull(particle, other, offset, length, 0.0),
        _push(particle, other, offset, length, 0.0),
    ]


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    """Check that the ends of a link are two different particles, and return both."""
    instance_of("a", a, Particle)
    if instance_of("b", b, Particle) is a:
        raise ValueError(f"a and b must be two different particles, got {b!r} twice")
    return a, b
