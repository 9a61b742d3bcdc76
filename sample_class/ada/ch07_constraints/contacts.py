"""Ada's contacts, and what resolves them."""

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6
VELOCITY_TOLERANCE = 1e-12
DEPTH_TOLERANCE = 1e-9


class Contact:
    """Particle a leaves b, or the world, along the normal."""

    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(self, particle, other, normal, restitution=0.0, penetration=0.0):
        self.particle = a_particle("particle", particle)
        self.other = None if other is None else a_particle("other", other)
        if other is particle:
            raise ValueError(f"a particle does not touch itself: {other!r}")
        self.normal = finite_vector("normal", normal)
        if abs(normal.magnitude() - 1) > UNIT_TOLERANCE:
            raise ValueError(f"normal is not of length 1: {normal!r}")
        self.restitution = a_restitution("restitution", restitution)
        self.penetration = finite("penetration", penetration)

    def separating_velocity(self):
        away = self.particle.velocity
        if self.other is not None:
            away = away - self.other.velocity
        return self.normal @ away

    def velocity_after(self, duration=0.0):
        h = not_negative("duration", duration)
        now = self.separating_velocity()
        if now >= 0:
            return now
        # what it would have had without this frame's pull; no bounce for the rest
        pull = pull_along(self.particle, self.normal) - pull_along(self.other, self.normal)
        without = now if pull > 0 else now - pull * h
        return -self.restitution * without if without < 0 else 0.0

    def resolve_velocity(self, duration=0.0):
        gain = self.velocity_after(duration) - self.separating_velocity()
        if gain > 0 and self._total_inverse_mass():
            self._share(gain, "velocity")

    def resolve_penetration(self):
        if self.penetration <= 0 or not self._total_inverse_mass():
            return Vector3(), Vector3()
        moves = self._share(self.penetration, "position")
        self.penetration = 0.0
        return moves

    def resolve(self, duration):
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def _share(self, amount, name):
        # velocities and positions are shared in the same way, by inverse mass
        unit = amount / self._total_inverse_mass()
        changes = []
        for body, way in (self.particle, unit), (self.other, -unit):
            change = Vector3()
            if body is not None and body.has_finite_mass:
                change.add_scaled(self.normal, way * body.inverse_mass)
                getattr(body, name).add_scaled(change, 1)
            changes.append(change)
        return tuple(changes)

    def _total_inverse_mass(self):
        total = self.particle.inverse_mass
        return total if self.other is None else total + self.other.inverse_mass


def pull_along(body, normal):
    if body is None or not body.has_finite_mass:
        return 0.0
    return body.last_acceleration @ normal


class ContactGenerator(Protocol):
    def contacts(self) -> Iterable[Contact]: ...


class ContactResolver:
    def __init__(self, iterations=None):
        if iterations is not None:
            if type(iterations) is not int:
                raise TypeError(f"iterations is no whole number: {iterations!r}")
            if iterations < 1:
                raise ValueError(f"iterations is below 1: {iterations}")
        self.iterations = iterations
        self.iterations_used = 0

    def resolve_contacts(self, contacts, duration):
        positive("duration", duration)
        movable = [c for c in contacts if c._total_inverse_mass()]
        limit = self.iterations or len(movable) * 2
        first = self.resolve_velocities(movable, limit, duration)
        self.iterations_used = first + self.resolve_penetrations(movable, limit)

    def resolve_velocities(self, contacts, limit, duration):
        def closing(contact):
            return -contact.separating_velocity()

        used = 0
        for worst in worst_again_and_again(contacts, closing, VELOCITY_TOLERANCE, limit):
            worst.resolve_velocity(duration)
            used += 1
        return used

    def resolve_penetrations(self, contacts, limit):
        def depth(contact):
            return contact.penetration

        used = 0
        for worst in worst_again_and_again(contacts, depth, DEPTH_TOLERANCE, limit):
            bodies = worst.particle, worst.other
            for body, move in zip(bodies, worst.resolve_penetration()):
                if body is None:
                    continue
                for c in contacts:
                    # the worst one has its 0 already
                    if c is not worst and body is c.particle:
                        c.penetration -= c.normal @ move
                    elif c is not worst and body is c.other:
                        c.penetration += c.normal @ move
            used += 1
        return used


def worst_again_and_again(contacts, how_bad, tolerance, limit):
    for _ in range(limit if contacts else 0):
        worst = max(contacts, key=how_bad)  # the first, if several are
        if how_bad(worst) <= tolerance:
            return
        yield worst


def a_particle(name, value):
    if not isinstance(value, Particle):
        raise TypeError(f"{name} is no particle: {value!r}")
    return value


def a_restitution(name, value):
    if not_negative(name, value) > 1:
        raise ValueError(f"{name} is above 1: {value!r}")
    return float(value)


def direction_of(offset):
    direction = offset.normalized()
    return direction if direction.magnitude() else Vector3(0, 1, 0)
