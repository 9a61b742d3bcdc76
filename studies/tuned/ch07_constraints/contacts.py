"""Contacts between two particles, or between a particle and the world, and their resolver.

A contact stores the direction in which two bodies touch and the depth of their overlap. It also
stores the restitution, which is the fraction of the speed that is left after a bounce. To resolve
the contact, the engine applies an impulse (a change of momentum in N s, erratum E-24) and moves the
two bodies apart. Impulses always conserve momentum, but they conserve kinetic energy only if the
restitution is 1 (erratum E-7).

Lengths are in m, velocities in m/s.

This version computes in plain numbers. The resolver stores the separating velocities and depths in
lists. After each resolution it updates only those of contacts with the same particles.
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
        if not isinstance(particle, Particle):
            instance_of("particle", particle, Particle)
        if other is not None and not isinstance(other, Particle):
            instance_of("other", other, Particle)
        if other is particle:
            wanted = "particle and other must be two different particles"
            raise ValueError(f"{wanted}, got {other!r} twice")
        self.particle = particle
        self.other = other
        if type(normal) is not Vector3:
            normal = finite_vector("normal", normal)
        if not abs(math.hypot(normal.x, normal.y, normal.z) - 1.0) <= UNIT_TOLERANCE:
            finite_vector("normal", normal)
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
        v, n = self.particle.velocity, self.normal
        if self.other is None:
            return v.x * n.x + v.y * n.y + v.z * n.z
        w = self.other.velocity
        return (v.x - w.x) * n.x + (v.y - w.y) * n.y + (v.z - w.z) * n.z

    def velocity_after(self, duration: float = 0.0) -> float:
        if not (type(duration) is float and 0.0 <= duration < math.inf):
            not_negative("duration", duration)
        closing = self.separating_velocity()
        if closing >= 0.0:
            return closing
        if not self.restitution:
            return 0.0  # whatever has built up
        acceleration = Vector3()
        if self.particle._inverse_mass:
            acceleration += self.particle.last_acceleration
        if self.other is not None and self.other._inverse_mass:
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
        _add_scaled(self.particle.velocity, self.normal, impulse * self.particle._inverse_mass)
        if self.other is not None:
            _add_scaled(self.other.velocity, self.normal, -impulse * self.other._inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        total = self.total_inverse_mass()
        if self.penetration <= 0.0 or total == 0.0:
            return Vector3(), Vector3()
        share = self.penetration / total
        move, other_move = self.normal * (share * self.particle._inverse_mass), Vector3()
        _add_scaled(self.particle.position, move, 1.0)
        if self.other is not None:
            other_move = self.normal * (-share * self.other._inverse_mass)
            _add_scaled(self.other.position, other_move, 1.0)
        self.penetration = 0.0
        return move, other_move

    def resolve(self, duration: float) -> None:
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def total_inverse_mass(self) -> float:
        """Return 1 / ma + 1 / mb, which is 0 if neither particle can move."""
        if self.other is None:
            return self.particle._inverse_mass
        return self.particle._inverse_mass + self.other._inverse_mass


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
        near = _contacts_of_each(contacts)
        speeds = [contact.separating_velocity() for contact in contacts]
        for used in range(limit):
            lowest = min(speeds, default=0.0)
            if lowest >= -VELOCITY_TOLERANCE:
                return used
            worst = contacts[speeds.index(lowest)]
            worst.resolve_velocity(duration)
            for i, contact in near[worst.particle]:
                speeds[i] = contact.separating_velocity()
            if worst.other is not None:
                for i, contact in near[worst.other]:
                    speeds[i] = contact.separating_velocity()
        return limit

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        near = _contacts_of_each(contacts)
        depths = [contact.penetration for contact in contacts]
        for used in range(limit):
            deepest = max(depths, default=0.0)
            if deepest <= DEPTH_TOLERANCE:
                return used
            at = depths.index(deepest)
            worst = contacts[at]
            moves = worst.resolve_penetration()
            for particle, move in zip((worst.particle, worst.other), moves, strict=True):
                if particle is None or not particle._inverse_mass:
                    continue
                x, y, z = move.x, move.y, move.z
                for i, contact in near[particle]:
                    if contact is not worst:
                        n = contact.normal
                        change = x * n.x + y * n.y + z * n.z
                        contact.penetration -= change if contact.particle is particle else -change
                        depths[i] = contact.penetration
            depths[at] = worst.penetration
        return limit


def _contacts_of_each(contacts: Iterable[Contact]) -> dict[Particle, list[tuple[int, Contact]]]:
    """Return the contacts of each particle, with their indices."""
    found: dict[Particle, list[tuple[int, Contact]]] = {}
    for pair in enumerate(contacts):
        contact = pair[1]
        found.setdefault(contact.particle, []).append(pair)
        if contact.other is not None:
            found.setdefault(contact.other, []).append(pair)
    return found


def _add_scaled(vector: Vector3, other: Vector3, scale: float) -> None:
    """Add a multiple of another vector, unless it is zero."""
    if scale:
        vector.x += other.x * scale
        vector.y += other.y * scale
        vector.z += other.z * scale


def a_restitution(name: str, value: float) -> float:
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
