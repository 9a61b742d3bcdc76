"""Contacts."""

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6
VELOCITY_TOLERANCE = 1e-12
DEPTH_TOLERANCE = 1e-9


class Contact:
    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(self, particle, other, normal, restitution=0.0, penetration=0.0):
        self.particle = a_particle("particle", particle)
        self.other = None if other is None else a_particle("other", other)
        if other is particle:
            raise ValueError(f"other must be another particle than particle, got {other!r} twice")
        self.normal = finite_vector("normal", normal)
        if abs(normal.magnitude() - 1.0) > UNIT_TOLERANCE:
            raise ValueError(f"normal must have length 1, to {UNIT_TOLERANCE:g}, got {normal!r}")
        self.restitution = a_restitution("restitution", restitution)
        self.penetration = finite("penetration", penetration)

    def separating_velocity(self):
        relative = self.particle.velocity.copy()
        if self.other:
            relative -= self.other.velocity
        return relative.dot(self.normal)

    def velocity_after(self, duration=0.0):
        not_negative("duration", duration)
        vs = self.separating_velocity()
        if vs >= 0:
            return vs
        # as the book's listing, for micro-collisions
        caused = Vector3()
        if self.particle.inverse_mass > 0:
            caused += self.particle.acceleration
        if self.other and self.other.inverse_mass > 0:
            caused -= self.other.acceleration
        by_acceleration = caused.dot(self.normal) * duration
        new = -self.restitution * vs
        if by_acceleration < 0:
            new = max(new + self.restitution * by_acceleration, 0.0)
        return new

    def resolve_velocity(self, duration=0.0):
        new = self.velocity_after(duration)
        vs = self.separating_velocity()
        total = self.total_inverse_mass()
        if vs >= 0 or total <= 0:
            return
        impulse_per_mass = self.normal * ((new - vs) / total)
        self.particle.velocity += impulse_per_mass * self.particle.inverse_mass
        if self.other:
            self.other.velocity -= impulse_per_mass * self.other.inverse_mass

    def resolve_penetration(self):
        total = self.total_inverse_mass()
        if self.penetration <= 0 or total <= 0:
            return Vector3(), Vector3()
        move_per_mass = self.normal * (self.penetration / total)
        mine = move_per_mass * self.particle.inverse_mass
        self.particle.position += mine
        its = Vector3()
        if self.other:
            its = move_per_mass * -self.other.inverse_mass
            self.other.position += its
        self.penetration = 0.0
        return mine, its

    def resolve(self, duration):
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def total_inverse_mass(self):
        other = 0.0 if self.other is None else self.other.inverse_mass
        return self.particle.inverse_mass + other


class ContactGenerator(Protocol):
    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""


class ContactResolver:
    def __init__(self, iterations=None):
        if iterations is not None:
            if not isinstance(iterations, int) or isinstance(iterations, bool):
                raise TypeError(f"iterations must be a whole number or None, got {iterations!r}")
            if iterations < 1:
                raise ValueError(f"iterations must be 1 or more, got {iterations!r}")
        self.iterations = iterations
        self.iterations_used = 0

    def resolve_contacts(self, contacts, duration):
        positive("duration", duration)
        movable = [contact for contact in contacts if contact.total_inverse_mass()]
        limit = self.iterations or 2 * len(movable)
        used = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = used + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts, limit, duration):
        used = 0
        while used < limit:
            worst = None
            lowest = -VELOCITY_TOLERANCE
            for contact in contacts:
                vs = contact.separating_velocity()
                if vs < lowest:
                    worst = contact
                    lowest = vs
            if worst is None:
                break
            worst.resolve_velocity(duration)
            used += 1
        return used

    def resolve_penetrations(self, contacts, limit):
        used = 0
        while used < limit:
            worst = None
            deepest = DEPTH_TOLERANCE
            for contact in contacts:
                if contact.penetration > deepest:
                    worst = contact
                    deepest = contact.penetration
            if worst is None:
                break
            worst.resolve_penetration()
            used += 1
        return used


def a_particle(name, value):
    if not isinstance(value, Particle):
        raise TypeError(f"{name} must be a Particle, got {value!r}")
    return value


def a_restitution(name, value):
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset):
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
