"""Contacts between particles, or of a particle with the world, and the resolver that ends them.

Each of the two takes a share of what has to change, by how easily it is moved.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

UNIT_TOLERANCE = 1e-6  # how far from 1 the length of a normal may be
VELOCITY_TOLERANCE = 1e-12  # m/s: what closes more slowly is rounding
DEPTH_TOLERANCE = 1e-9  # m: what is less deep counts as touching


class Contact:
    """Two particles that touch, or a particle that touches what nothing moves (``other`` None)."""

    __slots__ = ("normal", "other", "particle", "penetration", "restitution")

    def __init__(
        self,
        particle: Particle,
        other: Particle | None,
        normal: Vector3,
        restitution: float = 0.0,
        penetration: float = 0.0,
    ) -> None:
        self.particle = a_particle("particle", particle)
        self.other = None if other is None else a_particle("other", other)
        if other is particle:
            raise ValueError(f"other must be another particle than particle, got {other!r} twice")
        self.normal = finite_vector("normal", normal)
        if abs(normal.magnitude() - 1.0) > UNIT_TOLERANCE:
            raise ValueError(f"normal must have length 1, to {UNIT_TOLERANCE:g}, got {normal!r}")
        self.restitution = a_restitution("restitution", restitution)
        self.penetration = finite("penetration", penetration)

    def separating_velocity(self) -> float:
        n = self.normal
        away = self.particle.velocity @ n
        return away if self.other is None else away - self.other.velocity @ n

    def velocity_after(self, duration: float = 0.0) -> float:
        duration = not_negative("duration", duration)
        closing = -self.separating_velocity()
        if closing <= 0.0:
            return -closing
        pulled = sum(
            sign * (body.last_acceleration @ self.normal) for body, sign in self._movable()
        )
        return self.restitution * max(0.0, closing + min(0.0, pulled * duration))

    def resolve_velocity(self, duration: float = 0.0) -> None:
        after = self.velocity_after(duration)
        before = self.separating_velocity()
        if before < 0.0:
            for body, share in self._shares():
                body.velocity.add_scaled(self.normal, share * (after - before))

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        shares = self._shares()
        if not shares or self.penetration <= 0.0:
            return Vector3(), Vector3()
        moves = {id(body): self.normal * (share * self.penetration) for body, share in shares}
        for body, _ in shares:
            body.position.add_scaled(moves[id(body)], 1.0)
        self.penetration = 0.0
        return moves.get(id(self.particle), Vector3()), moves.get(id(self.other), Vector3())

    def resolve(self, duration: float) -> None:
        positive("duration", duration)
        self.resolve_velocity(duration)
        self.resolve_penetration()

    def _movable(self) -> list[tuple[Particle, float]]:
        """Return which of the two can be moved, with the sign of its way along the normal."""
        both = ((self.particle, 1.0), (self.other, -1.0))
        return [(body, sign) for body, sign in both if body is not None and body.inverse_mass]

    def _shares(self) -> list[tuple[Particle, float]]:
        """Return the share of each that can be moved in a change along the normal, with its sign.

        By ratios of inverse masses: no sum and no impulse that could be too large for a float.
        """
        movable = self._movable()
        if len(movable) < 2:
            return movable
        (a, _), (b, _) = movable
        return [
            (a, 1.0 / (1.0 + b.inverse_mass / a.inverse_mass)),
            (b, -1.0 / (1.0 + a.inverse_mass / b.inverse_mass)),
        ]

    def total_inverse_mass(self) -> float:
        return sum(body.inverse_mass for body, _ in self._movable())


class ContactGenerator(Protocol):
    """Whatever has this method generates contacts: no class needs to derive from this one."""

    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""


class ContactResolver:
    """Resolves the contacts of a frame in two phases, velocities and then depths, worst first."""

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
        used = 0
        while contacts and used < limit:
            # Of equals min takes the first; the place in the list is only how it is found again.
            velocity, place = min((c.separating_velocity(), i) for i, c in enumerate(contacts))
            if velocity >= -VELOCITY_TOLERANCE:
                break
            contacts[place].resolve_velocity(duration)
            used += 1
        return used

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        used = 0
        while contacts and used < limit:
            worst = max(contacts, key=lambda contact: contact.penetration)  # of equals, the first
            if worst.penetration <= DEPTH_TOLERANCE:
                break
            moves = worst.resolve_penetration()
            used += 1
            for body, move in zip((worst.particle, worst.other), moves, strict=True):
                for contact in contacts:
                    if contact is worst or body is None:
                        continue
                    if contact.particle is body:
                        contact.penetration -= move @ contact.normal
                    elif contact.other is body:
                        contact.penetration += move @ contact.normal
        return used


def a_particle(name: str, value: Particle) -> Particle:
    """Return a particle; TypeError names what is none."""
    if not isinstance(value, Particle):
        raise TypeError(f"{name} must be a Particle, got {value!r}")
    return value


def a_restitution(name: str, value: float) -> float:
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)


def direction_of(offset: Vector3) -> Vector3:
    direction = offset.normalized()
    return direction if direction.squared_magnitude() else Vector3(0.0, 1.0, 0.0)
