"""Links that limit the distance between two particles, or a particle and an anchor.

Cables and rods are links. A link is a contact generator. It generates no contact while its length
is within its limits. When the length reaches or passes a limit, ``contacts()`` returns a contact.
Resolving this contact brings the length back to the limit. ``contacts()`` itself changes nothing.

Lengths are in m. Constructors raise ValueError for a length that is not positive, a restitution
outside 0 to 1 and anything that is not finite. They raise TypeError for an argument of the wrong
type. You may change the attributes later, as a winch does, but these changes are not checked.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution


class Cable:
    """A cable that keeps two particles at most ``max_length`` m apart.

    When the cable becomes taut, its ends can bounce back toward each other. ``restitution`` is the
    speed at which they approach after this bounce, divided by the speed at which they moved apart
    before it. Book: section 7.4.1.
    """

    def __init__(
        self, a: Particle, b: Particle, max_length: float, restitution: float = 0.0
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the cable is taut (at least ``max_length`` long).

        In the contact, ``particle`` is ``a`` and ``other`` is ``b``. The normal points from ``a``
        to ``b``, because a taut cable pulls its ends together. The penetration is the current
        length minus ``max_length``. A slack cable has no contact, so the list is empty.
        """
        raise NotImplementedError("Exercise B7.7: Cables")


class AnchoredCable:
    """A cable that keeps a particle at most ``max_length`` m away from a fixed ``anchor``.

    It works like a ``Cable`` whose second end cannot move. Book: section 7.4.1.
    """

    def __init__(
        self, particle: Particle, anchor: Vector3, max_length: float, restitution: float = 0.0
    ) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the cable is taut, or an empty list if it is slack.

        The contact is the same as for ``Cable``, except that ``other`` is None and the normal
        points to the anchor.
        """
        raise NotImplementedError("Exercise B7.7: Cables")


class Rod:
    """A rod that keeps two particles exactly ``length`` m apart.

    It pulls its ends together if they are too far apart, and pushes them apart if they are too
    close. Book: section 7.4.2.
    """

    def __init__(self, a: Particle, b: Particle, length: float) -> None:
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the rod is too short or too long.

        If the length of the rod is exactly right, the list is empty.

        In the contact, ``particle`` is ``a`` and ``other`` is ``b``. If the rod is too long, it
        pulls, so the normal points from ``a`` to ``b``. If it is too short, it pushes, so the
        normal points away from ``b``. The penetration is the difference between the distance and
        ``length`` as a positive number, and the restitution is 0. If both ends are at the same
        position, use +Y as the direction from ``a`` to ``b``, as ``direction_of`` of contacts.py
        does. This method follows the book's listing. The book's text asks for two contacts in every
        step, as in ``TwoSidedRod`` (erratum E-9).
        """
        raise NotImplementedError("Exercise B7.8: Rods")


class AnchoredRod:
    """A rod that keeps a particle exactly ``length`` m away from a fixed ``anchor``.

    You can hang a pendulum from it, for example. Book: section 7.4.2.
    """

    def __init__(self, particle: Particle, anchor: Vector3, length: float) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self) -> list[Contact]:
        """Return a list with one contact if the rod is too short or too long.

        If the length of the rod is exactly right, the list is empty. The contact is the same as for
        ``Rod``, but ``other`` is None and the anchor takes the place of the second particle.
        """
        raise NotImplementedError("Exercise B7.8: Rods")


class Limits:
    """Exercise 7.6: a link that keeps two particles from getting too close or too far apart.

    The particles stay at least ``min_length`` m and at most ``max_length`` m apart. If
    ``min_length`` is 0, there is no lower limit. The constructor also raises ValueError if
    ``min_length`` is negative or greater than ``max_length``.
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

        If the distance is ``max_length`` or more, the contact is like the contact of a Cable. If it
        is ``min_length`` or less, the contact pushes: its normal points away from ``b``, and its
        penetration is ``min_length`` minus the distance. If both limits are reached, return both
        contacts, in this order. Each contact has the restitution of the link. If both ends are at
        the same position, use +Y as the direction from ``a`` to ``b``.
        """
        raise NotImplementedError("Exercise 7.6: A link with two limits")


class TwoSidedRod(Rod):
    """G7.1: a rod with two contacts in every step, one that pulls and one that pushes.

    A ``Rod`` gets a contact only if its length is wrong at the start of a step. If its ends move
    apart later in the step, nothing stops them until the next step. Such delays add up in a chain,
    because correcting one rod stretches the next, which gets its contact one step later. A pull
    then travels about one rod per step, however many iterations there are. With two contacts per
    rod, there is no delay. The book's text asks for such rods (7.4.2), although its listing makes
    only one contact (erratum E-9).
    """

    def contacts(self) -> list[Contact]:
        """G7.1: always return two contacts: first one that pulls, then one that pushes.

        The first contact is like the contact of a Cable. Its normal points from ``a`` to ``b``, and
        its penetration is the distance minus ``length``, which may be negative. The second contact
        has the opposite normal and the opposite penetration. In the velocity phase, the first
        contact stops ends that move apart, and the second stops ends that approach each other. If
        both ends are at the same position, use +Y as the direction from ``a`` to ``b``.
        """
        raise NotImplementedError("Exercise G7.1: Two-sided rods, as in the text of the book")


def two_particles(a: Particle, b: Particle) -> tuple[Particle, Particle]:
    """Check that the ends of a link are two different particles, and return both."""
    instance_of("a", a, Particle)
    if instance_of("b", b, Particle) is a:
        raise ValueError(f"a and b must be two different particles, got {b!r} twice")
    return a, b
