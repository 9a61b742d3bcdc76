"""Contacts between particles, or of a particle with the world, and the resolver that ends them.

A contact says that two things touch: along which normal, how deep in each other they are, and how
much of their speed a bounce returns. A resolver gives impulses, changes of momentum in N s (E-24),
and moves things apart. Momentum is kept whatever the restitution is; only at restitution 1 kinetic
energy is as well (E-7).

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
VELOCITY_TOLERANCE = 1e-12  # m/s: what closes more slowly is rounding
DEPTH_TOLERANCE = 1e-9  # m: what is less deep counts as touching


class Contact:
    """Two particles that touch, or a particle that touches what nothing moves (``other`` None).

    ``normal`` is the unit vector along which ``particle`` leaves, seen from the other. That makes
    it (pa - pb)^ for two balls, and (0, 1, 0) on the ground (Eq. 7.2, 7.4). ``restitution`` is the
    share of the closing speed that a bounce returns. ``penetration`` is how deep they are in each
    other: 0 where they touch, negative where they are apart.

    Raises ValueError where the normal is not of unit length, to 1e-6, the restitution is not from
    0 to 1, the penetration is not finite, or both particles are the same one. What is no Particle,
    no Vector3 or no number is a TypeError. The normal is copied. All of them may be changed later,
    and are then yours to keep right.
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
        # Contacts are made anew in every frame. So each number is compared here, and only one that
        # looks wrong is passed on to the function that names it.
        self.particle = instance_of("particle", particle, Particle)
        self.other = None if other is None else instance_of("other", other, Particle)
        if other is particle:
            raise ValueError(f"other must be another particle than particle, got {other!r} twice")
        if not (isinstance(normal, Vector3) and abs(normal.magnitude() - 1.0) <= UNIT_TOLERANCE):
            normal = finite_vector("normal", normal)
            if abs(normal.magnitude() - 1.0) > UNIT_TOLERANCE:
                wanted = f"normal must have length 1, to {UNIT_TOLERANCE:g}"
                raise ValueError(f"{wanted}, got {normal!r}")
        self.normal = normal.copy()
        if not (type(restitution) is float and 0.0 <= restitution <= 1.0):
            restitution = a_restitution("restitution", restitution)
        self.restitution = restitution
        if type(penetration) is not float or penetration * 0.0 != 0.0:  # infinity * 0 is NaN
            penetration = finite("penetration", penetration)
        self.penetration = penetration

    def separating_velocity(self) -> float:
        """Return how fast the two part, (va - vb) . n in m/s: negative while they close (Eq. 7.2).

        vb is zero where there is no other.
        """
        velocity = self.particle.velocity
        if self.other is not None:
            velocity = velocity - self.other.velocity
        return velocity.dot(self.normal)

    def velocity_after(self, duration: float = 0.0) -> float:
        """Return the separating velocity in m/s that the contact should have once it is resolved.

        What parts already, or neither closes nor parts, keeps its own. What closes at v_s < 0
        bounces: -c v_s (Eq. 7.3; the book's text has c v_s in one place, E-25).

        But a body that rests closes too, by what a frame of a duration h in s has just accelerated
        it; a bounce of that would make it jitter. So where the frame's acceleration closes the
        contact, (aa - ab) . n < 0, the bounce is c (-v_s + (aa - ab) . n h), and never below 0
        (7.2.3). Each acceleration is the last_acceleration of the particle, all of the frame's:
        the book counts the constant one only, and then gravity by a generator shakes what rests
        (E-26). What is immovable, or not there, has none.

        A duration of 0 is that of an impact at a point of time: nothing has accelerated it. Raises
        ValueError where the duration is negative or not finite.
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
        """Give what closes the impulse that makes it part as velocity_after says (7.1.4, 7.2.1).

        The impulse g in N s acts along the normal, on the other with the opposite sign: va' = va +
        n g / ma, vb' = vb - n g / mb. So what changes is shared by inverse mass, and momentum is
        kept. What parts already stays as it is, and so do two that are both immovable.

        Raises ValueError as velocity_after does.
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
        """Move the two apart along the normal, so that they touch, and return how each was moved.

        The depth d is shared by inverse mass, as the impulse is: the particle moves by n d times
        mb / (ma + mb), the other by -n d times ma / (ma + mb) (7.2.2), or one of them all the way
        where the other is immovable. The penetration is 0 afterwards. What only touches, is apart
        or cannot be moved stays as it is. Both moves are new vectors in m, and zero for what did
        not move, so that no older move is left to be counted twice (E-27).
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
        """Resolve the velocity, for a frame of a duration in s, and then the penetration.

        Raises ValueError where the duration is not positive and finite; nothing is moved then.
        """
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def _total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb: 0 where nothing can be moved."""
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    """Whatever has this method generates contacts: no class needs to derive from this one."""

    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""


class ContactResolver:
    """Resolves the contacts of a frame in two phases, velocities and then depths (7.3.1).

    Each phase takes the worst contact first, and the first of several that are equally bad. To
    resolve one may make others better or worse, so each phase looks at all of them again after each
    one. ``iterations`` is how often each phase may resolve a contact; None stands for twice as many
    as there are contacts. ``iterations_used`` is how many both phases have used in the last frame.

    Raises ValueError where ``iterations`` is below 1, TypeError where it is no whole number.
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
        """Resolve the contacts of a frame of a duration in s: all velocities, then all depths.

        Contacts in which nothing can be moved are left out, and do not count. Their particles'
        velocities and positions are what changes, and the penetrations of the contacts.

        Raises ValueError where the duration is not positive and finite; nothing is moved then.
        """
        positive("duration", duration)
        movable = [contact for contact in contacts if contact._total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
        """Resolve the velocity of the contact that closes fastest, again and again.

        Ends after ``limit`` of them, or when none closes faster than VELOCITY_TOLERANCE. Return how
        many it has resolved. In each of ``contacts`` something can be moved; how deep they are does
        not matter here.
        """
        for used in range(limit):
            worst, lowest = None, -VELOCITY_TOLERANCE
            for contact in contacts:
                # Contact.separating_velocity in plain floats: each impulse asks every contact.
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
        """Resolve the penetration of the deepest contact, again and again.

        In each of ``contacts`` something can be moved. Each move changes how deep all the other
        contacts of the particles that moved are: one is deeper by how far its other moved along its
        normal, and less deep by how far its particle did. The listing leaves that out (E-8).

        Ends after ``limit`` of them, or when none is deeper than DEPTH_TOLERANCE. Return how many
        it has resolved.
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
    """Return a restitution; ValueError for a number that is not from 0 to 1."""
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    """Return the direction of an offset, as new, and +Y where it has none."""
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
