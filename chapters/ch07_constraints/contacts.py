"""Contacts, and the resolver that resolves all contacts of a time step.

To resolve a contact, apply an impulse, which is a change of momentum in N s (erratum E-24), and
move the two bodies apart. Lengths are in m, velocities in m/s.

A number out of range, such as a negative duration, raises ValueError. A value of the wrong type
raises TypeError. In both cases nothing changes.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, instance_of, not_negative, positive, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6  # how far from 1 the length of a normal may be
VELOCITY_TOLERANCE = 1e-12  # m/s: a slower closing speed is only rounding
DEPTH_TOLERANCE = 1e-9  # m: a smaller depth counts as touching


class Contact:
    """A contact between two particles, or with the immovable world if ``other`` is None.

    ``normal`` is a unit vector from ``other`` to ``particle``, such as (0, 1, 0) on the ground.
    ``restitution``, from 0 to 1, is the speed after a bounce divided by the speed before it.
    ``penetration`` is the depth of the overlap, which is negative if there is a gap. Vectors are
    copied. Later changes of the attributes are not checked.
    """

    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(
        self,
        particle: Particle,
        other: Particle | None,
        normal: Vector3,
        restitution: float = 0.0,
        penetration: float = 0.0,
    ) -> None:
        self.particle = instance_of("particle", particle, Particle)
        self.other = None if other is None else instance_of("other", other, Particle)
        if other is particle:
            wanted = "particle and other must be two different particles"
            raise ValueError(f"{wanted}, got {other!r} twice")
        self.normal = a_unit_vector("normal", normal)
        self.restitution = a_restitution("restitution", restitution)
        self.penetration = finite("penetration", penetration)

    def separating_velocity(self) -> float:
        """Compute how fast the two bodies move apart, in m/s, without changing anything (Eq. 7.4).

        The result is (va - vb) . n, which is negative while the bodies approach. Here n is the
        normal, va is the velocity of ``particle``, and vb is that of ``other``, or 0 if it is None.
        """
        raise NotImplementedError("Exercise B7.1: Separating velocity")

    def velocity_after(self, duration: float = 0.0) -> float:
        """Compute the separating velocity in m/s that the contact must have after it is resolved.

        If the separating velocity v_s is 0 or positive, the result is v_s. A closing contact
        bounces with the restitution c, but without the velocity that the acceleration has built up
        in a step of h = ``duration`` s: return c (a h - v_s), but never less than 0. Here a is
        (aa - ab) . n, or 0 if that is positive, and aa and ab are the ``last_acceleration`` of the
        particles, which includes forces. Use 0 for an immovable or missing particle. This method
        changes nothing. Book: 7.1.2 and 7.2.3.
        """
        raise NotImplementedError("Exercise B7.2: Bounces and resting contacts")

    def resolve_velocity(self, duration: float = 0.0) -> None:
        """Apply the impulse that changes the separating velocity to ``velocity_after(duration)``.

        The impulse g in N s acts along the normal n: va' = va + n g / ma and vb' = vb - n g / mb.
        This conserves momentum. Nothing else changes, and nothing at all if the contact is not
        closing, or if neither particle can move. Book: 7.1.4 and 7.2.
        """
        raise NotImplementedError("Exercise B7.3: Impulses")

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        """Move the two particles apart along the normal n until they touch.

        For the penetration d, and the inverse masses ia and ib, ``particle`` moves by
        n d ia / (ia + ib), and ``other`` by -n d ib / (ia + ib), so the lighter one moves farther.
        Then the penetration is 0. If the penetration is 0 or negative, or neither particle can
        move, nothing changes. Return both displacements in m, as two new vectors, which are zero
        for a particle that did not move. Book 7.2.2.
        """
        raise NotImplementedError("Exercise B7.4: Pushing particles apart")

    def resolve(self, duration: float) -> None:
        """Resolve the velocity and then the penetration, for a step of ``duration`` s, above 0."""
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb in 1/kg, which is 0 if neither particle can move."""
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    """The interface of a contact generator, which is any object with a ``contacts`` method."""

    def contacts(self) -> Iterable[Contact]:
        """Find all contacts at the current positions and return them."""


class ContactResolver:
    """Resolves the contacts of a time step: first velocities, then penetrations (book 7.3.1).

    ``iterations`` limits the number of resolutions in each phase. It is at least 1, and None means
    twice the number of contacts. ``iterations_used`` counts those of both phases in the last step.
    """

    def __init__(self, iterations: int | None = None) -> None:
        self.iterations = None if iterations is None else whole("iterations", iterations)
        self.iterations_used = 0

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        """Resolve the velocities of all contacts, and then their penetrations.

        ``duration`` is above 0. Contacts in which neither particle can move are left out.
        """
        positive("duration", duration)
        movable = [contact for contact in contacts if contact.total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
        """Repeatedly resolve the velocity of the contact that closes fastest.

        Stop after ``limit`` resolutions, or when no contact closes faster than
        ``VELOCITY_TOLERANCE``. Return the number of resolutions. If several contacts are equally
        fast, take the first. This phase ignores penetrations. Pass ``duration`` on to
        ``resolve_velocity``. The list may be empty.
        """
        raise NotImplementedError("Exercise B7.5: Fastest contact first")

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        """Repeatedly resolve the penetration of the deepest contact.

        Stop after ``limit`` resolutions, or when no contact is deeper than ``DEPTH_TOLERANCE``.
        Return the number of resolutions. If several contacts are equally deep, take the first.

        A resolution also changes the depths of all other contacts of the particles that it moved.
        So update each of these contacts. If its ``particle`` has moved by da and its ``other`` by
        db, its depth decreases by (da - db) . n. The book's listing omits this (erratum E-8).
        """
        raise NotImplementedError("Exercise B7.6: Deepest contact first")


def a_unit_vector(name: str, v: Vector3) -> Vector3:
    """Check that the length of a vector is 1, and return a copy of the vector."""
    v = finite_vector(name, v)
    if abs(v.magnitude() - 1.0) > UNIT_TOLERANCE:
        raise ValueError(f"{name} must be a unit vector (within {UNIT_TOLERANCE:g}), got {v!r}")
    return v


def a_restitution(name: str, value: float) -> float:
    """Check that a restitution is a number from 0 to 1, and return it as a float."""
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    """Return the unit vector along ``offset``, or +Y if ``offset`` is zero and has no direction."""
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
