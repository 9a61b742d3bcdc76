"""Contacts between two particles, or between a particle and the world, and their resolver.

A contact stores the direction in which two bodies touch and the depth of their overlap. It also
stores the restitution, which is the fraction of the speed that is left after a bounce. To resolve
the contact, the engine applies an impulse (a change of momentum in N s, erratum E-24) and moves the
two bodies apart. Impulses always conserve momentum, but they conserve kinetic energy only if the
restitution is 1 (erratum E-7).

Lengths are in m, velocities in m/s.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6  # how far from 1 the length of a normal may be
VELOCITY_TOLERANCE = 1e-12  # m/s: a slower closing speed is only rounding
DEPTH_TOLERANCE = 1e-9  # m: a smaller depth counts as touching


class Contact:
    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(
        self,
        particle: Particle,
        other: Particle | None,
        normal: Vector3,
        restitution: float = 0.0,
        penetration: float = 0.0,
    ) -> None:
        # Speed matters here, so arguments.py is called only for a value that looks wrong.
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
        velocity = self.particle.velocity
        if self.other is not None:
            velocity = velocity - self.other.velocity
        return velocity.dot(self.normal)

    def velocity_after(self, duration: float = 0.0) -> float:
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
        wanted = self.velocity_after(duration)
        closing = self.separating_velocity()
        total = self.total_inverse_mass()
        if closing >= 0.0 or total == 0.0:
            return
        impulse = (wanted - closing) / total
        self.particle.velocity.add_scaled(self.normal, impulse * self.particle.inverse_mass)
        if self.other is not None:
            self.other.velocity.add_scaled(self.normal, -impulse * self.other.inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        move, other_move = Vector3(), Vector3()
        total = self.total_inverse_mass()
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
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb, which is 0 if neither particle can move."""
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    def contacts(self) -> Iterable[Contact]:
        """Find all contacts at the current positions and return them."""


class ContactResolver:
    def __init__(self, iterations: int | None = None) -> None:
        if iterations is not None:
            if not isinstance(iterations, int) or isinstance(iterations, bool):
                raise TypeError(f"iterations must be a whole number or None, got {iterations!r}")
            if iterations < 1:
                raise ValueError(f"iterations must be 1 or more, got {iterations!r}")
        self.iterations = iterations
        self.iterations_used = 0

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        positive("duration", duration)
        movable = [contact for contact in contacts if contact.total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
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
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
