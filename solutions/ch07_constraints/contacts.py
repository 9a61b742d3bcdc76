"""Contacts between two particles or a particle and the world, and the resolver for them.

A contact describes two bodies that touch. It stores the direction of the contact, the depth of the
overlap, and the fraction of the speed that is left after a bounce. Resolving the contact changes
the velocities by an impulse (a change of momentum in N s, E-24) and pushes the two bodies apart.
Impulses conserve momentum at every restitution, but kinetic energy only at restitution 1 (E-7).

Lengths are in m, velocities in m/s.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6  # how far from 1 the length of a normal may be
VELOCITY_TOLERANCE = 1e-12  # m/s: a slower closing speed is only rounding
DEPTH_TOLERANCE = 1e-9  # m: a smaller depth counts as touching


class Contact:
    """A contact of a particle with another one, or with the immovable world if ``other`` is None.

    ``normal`` is the unit vector that points from ``other`` to ``particle``. For two balls it is
    the direction of pa - pb, and on the ground it is (0, 1, 0) (Eq. 7.2, 7.4). The contact stores a
    copy. ``restitution`` is the ratio of the separating speed after a bounce to the closing speed
    before it. ``penetration`` is the depth of the overlap. It is 0 if the two just touch, and
    negative if there is a gap. Attributes may be changed later, but changes are not checked.

    Raises:
        ValueError: if the length of the normal differs from 1 by more than 1e-6, the restitution is
            not from 0 to 1, the penetration is not finite, or both particles are the same.
        TypeError: if an argument has the wrong type.
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
        # Contacts are made in every step, so speed matters here. The functions of arguments.py are
        # called only for a value that looks wrong.
        self.particle = instance_of("particle", particle, Particle)
        self.other = None if other is None else instance_of("other", other, Particle)
        if other is particle:
            wanted = "particle and other must be two different particles"
            raise ValueError(f"{wanted}, got {other!r} twice")
        if not (isinstance(normal, Vector3) and abs(normal.magnitude() - 1.0) <= UNIT_TOLERANCE):
            normal = finite_vector("normal", normal)
            if abs(normal.magnitude() - 1.0) > UNIT_TOLERANCE:
                wanted = f"normal must be a unit vector (within {UNIT_TOLERANCE:g})"
                raise ValueError(f"{wanted}, got {normal!r}")
        self.normal = normal.copy()
        if not (type(restitution) is float and 0.0 <= restitution <= 1.0):
            restitution = a_restitution("restitution", restitution)
        self.restitution = restitution
        if type(penetration) is not float or penetration * 0.0 != 0.0:  # infinity * 0 is NaN
            penetration = finite("penetration", penetration)
        self.penetration = penetration

    def separating_velocity(self) -> float:
        """Return the separating velocity (va - vb) . n in m/s, negative for a closing contact.

        If ``other`` is None, vb is zero. Book 7.1.1, Eq. 7.2.
        """
        velocity = self.particle.velocity
        if self.other is not None:
            velocity = velocity - self.other.velocity
        return velocity.dot(self.normal)

    def velocity_after(self, duration: float = 0.0) -> float:
        """Return the separating velocity in m/s that the contact must have after it is resolved.

        If the separating velocity v_s is 0 or positive, the result is v_s. A closing contact (v_s <
        0) bounces with the restitution c, so the result is -c v_s (Eq. 7.3).

        A body at rest on the ground closes its contact too, because gravity has just accelerated it
        for one time step. If this small velocity made it bounce, the body would jitter. So if the
        acceleration closes the contact, (aa - ab) . n < 0, take out the velocity that it has built
        up: return c (-v_s + (aa - ab) . n h), but never less than 0. Here h is the duration of the
        step in s, and aa and ab are the ``last_acceleration`` of the particles, which includes
        forces. For an immovable or missing particle, use 0. The book counts only the constant
        acceleration, so a body under a gravity generator would jitter (7.2.3, E-26).

        Time division resolves an impact at one instant, when no such velocity has built up. Pass a
        duration of 0 for it.

        Raises:
            ValueError: if the duration is negative or not finite, in every case.
        """
        if not (type(duration) is float and 0.0 <= duration < math.inf):
            not_negative("duration", duration)
        closing = self.separating_velocity()
        if closing >= 0.0:
            return closing
        acceleration = Vector3()
        if self.particle.inverse_mass:
            acceleration += self.particle.last_acceleration
        if self.other is not None and self.other.inverse_mass:
            acceleration -= self.other.last_acceleration
        built_up = min(0.0, acceleration.dot(self.normal) * duration)
        return max(0.0, self.restitution * (built_up - closing))

    def resolve_velocity(self, duration: float = 0.0) -> None:
        """Apply the impulse that changes the separating velocity to ``velocity_after(duration)``.

        The impulse g in N s acts along the normal n, and with the opposite sign on ``other``: va' =
        va + n g / ma and vb' = vb - n g / mb. This conserves momentum. Nothing changes if the
        contact is not closing, or if neither particle can move. Book 7.1.4 and 7.2.1.

        Raises:
            ValueError: if the duration is negative or not finite, in every case.
        """
        wanted = self.velocity_after(duration)
        closing = self.separating_velocity()
        total = self._total_inverse_mass()
        if closing >= 0.0 or total == 0.0:
            return
        impulse = (wanted - closing) / total
        self.particle.velocity.add_scaled(self.normal, impulse * self.particle.inverse_mass)
        if self.other is not None:
            self.other.velocity.add_scaled(self.normal, -impulse * self.other.inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        """Move the two particles apart along the normal until they touch, and return both moves.

        The lighter particle moves farther, because the depth d is divided in the ratio of the
        inverse masses. ``particle`` moves by n d mb / (ma + mb) and ``other`` by -n d ma / (ma +
        mb). If one of the two is immovable, the other moves by the whole depth. Afterward the
        penetration is 0. If the penetration is 0 or negative, or neither particle can move, nothing
        changes. Book 7.2.2.

        Returns:
            The displacements of ``particle`` and ``other`` in m, as two new vectors. A particle
                that did not move has a displacement of zero, so that no earlier displacement is
                applied again (E-27).
        """
        move, other_move = Vector3(), Vector3()
        total = self._total_inverse_mass()
        if self.penetration <= 0.0 or total == 0.0:
            return move, other_move
        share = self.penetration / total
        move.add_scaled(self.normal, share * self.particle.inverse_mass)
        self.particle.position.add_scaled(move, 1.0)  # += would check and copy the position again
        if self.other is not None:
            other_move.add_scaled(self.normal, -share * self.other.inverse_mass)
            self.other.position.add_scaled(other_move, 1.0)
        self.penetration = 0.0
        return move, other_move

    def resolve(self, duration: float) -> None:
        """Resolve the velocity and then the penetration, after a time step of a duration in s.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def _total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb, which is 0 if neither particle can move."""
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    """The interface of a contact generator. A generator need not inherit from this class."""

    def contacts(self) -> Iterable[Contact]:
        """Return the current contacts."""


class ContactResolver:
    """Resolves the contacts of a time step in two phases: velocities, then penetrations (7.3.1).

    Each phase resolves the worst contact first. If several contacts are equally bad, it takes the
    first of them. Resolving one contact can make others better or worse, so all contacts are
    compared again afterward. ``iterations`` limits the number of resolutions in each phase. If it
    is None, the limit is twice the number of contacts. After a step, ``iterations_used`` is the
    number of resolutions in both phases together.

    Raises:
        ValueError: if ``iterations`` is less than 1.
        TypeError: if ``iterations`` is not a whole number or None.
    """

    def __init__(self, iterations: int | None = None) -> None:
        if iterations is not None:
            if not isinstance(iterations, int) or isinstance(iterations, bool):
                raise TypeError(f"iterations must be a whole number or None, got {iterations!r}")
            if iterations < 1:
                raise ValueError(f"iterations must be 1 or more, got {iterations!r}")
        self.iterations = iterations
        self.iterations_used = 0

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        """Resolve the contacts after a time step of a duration in s: velocities, then penetrations.

        This changes the velocities and positions of the particles, and the penetrations of the
        contacts. A contact in which neither particle can move is ignored, and does not count for
        the limit.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        movable = [contact for contact in contacts if contact._total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
        """Repeatedly resolve the velocity of the contact that closes fastest.

        Stop after ``limit`` resolutions, or when no contact closes faster than
        ``VELOCITY_TOLERANCE``. Of several equally fast contacts, take the first. Penetrations do
        not matter here, and in every contact at least one particle can move.

        Returns:
            The number of resolutions.
        """
        for used in range(limit):
            worst, lowest = None, -VELOCITY_TOLERANCE
            for contact in contacts:
                # This is separating_velocity in plain floats. Every impulse compares all contacts.
                v, n = contact.particle.velocity, contact.normal
                if contact.other is None:
                    velocity = v.x * n.x + v.y * n.y + v.z * n.z
                else:
                    w = contact.other.velocity
                    velocity = (v.x - w.x) * n.x + (v.y - w.y) * n.y + (v.z - w.z) * n.z
                if velocity < lowest:
                    worst, lowest = contact, velocity
            if worst is None:
                return used
            worst.resolve_velocity(duration)
        return limit

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        """Repeatedly resolve the penetration of the deepest contact.

        Every resolution moves particles, which changes the penetrations of all their contacts. So
        for each of these contacts, subtract the distance that its ``particle`` moved along its
        normal, and add the distance that its ``other`` moved along the normal. The book's listing
        omits this update (E-8).

        Stop after ``limit`` resolutions, or when no contact is deeper than ``DEPTH_TOLERANCE``. Of
        several equally deep contacts, take the first. In every contact at least one particle can
        move.

        Returns:
            The number of resolutions.
        """
        for used in range(limit):
            worst, deepest = None, DEPTH_TOLERANCE
            for contact in contacts:
                if contact.penetration > deepest:
                    worst, deepest = contact, contact.penetration
            if worst is None:
                return used
            a, b = worst.particle, worst.other
            move_a, move_b = worst.resolve_penetration()
            for contact in contacts:
                if contact is worst:
                    continue
                if contact.particle is a:
                    contact.penetration -= move_a.dot(contact.normal)
                elif contact.particle is b:
                    contact.penetration -= move_b.dot(contact.normal)
                if contact.other is a:
                    contact.penetration += move_a.dot(contact.normal)
                elif contact.other is b and b is not None:
                    contact.penetration += move_b.dot(contact.normal)
        return limit


def a_restitution(name: str, value: float) -> float:
    """Return a restitution as a float, or raise ValueError if it is not from 0 to 1."""
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    """Return the unit vector along an offset as a new vector, or +Y if the offset is zero."""
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
