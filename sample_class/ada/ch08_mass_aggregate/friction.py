"""Contacts that rub: Coulomb friction, with one coefficient for sliding and sticking."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane


class FrictionContact(Contact):
    """A contact with friction, whose coefficient is 0 or more."""

    __slots__ = ("_moves", "friction")

    def __init__(
        self,
        particle: Particle,
        other: Particle | None,
        normal: Vector3,
        restitution: float = 0.0,
        penetration: float = 0.0,
        friction: float = 0.0,
    ) -> None:
        super().__init__(particle, other, normal, restitution, penetration)
        self.friction = not_negative("friction", friction)
        self._moves = Vector3()

    def sliding_velocity(self) -> Vector3:
        v = self.particle.velocity * 1.0
        if self.other is not None:
            v.add_scaled(self.other.velocity, -1.0)
        return self.normal.cross(v.cross(self.normal))

    def friction_impulse(self, normal_impulse: float) -> Vector3:
        most = self.friction * not_negative("normal_impulse", normal_impulse)
        heavy = self.total_inverse_mass()
        if not heavy:
            return Vector3()
        stop = self.sliding_velocity() * (-1.0 / heavy)
        size = stop.magnitude()
        return stop * (most / size) if size > most else stop

    def resolve_velocity(self, duration: float = 0.0) -> None:
        closing = self.separating_velocity()
        super().resolve_velocity(duration)
        total = self.total_inverse_mass()
        change = self.separating_velocity() - closing
        if change > 0.0 and total:
            impulse = self.friction_impulse(change / total)
            self._moves.add_scaled(impulse, duration)
            self.particle.velocity.add_scaled(impulse, self.particle.inverse_mass)
            if self.other is not None:
                self.other.velocity.add_scaled(impulse, -self.other.inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        move, other_move = super().resolve_penetration()
        move.add_scaled(self._moves, self.particle.inverse_mass)
        self.particle.position.add_scaled(self._moves, self.particle.inverse_mass)
        if self.other is not None:
            other_move.add_scaled(self._moves, -self.other.inverse_mass)
            self.other.position.add_scaled(self._moves, -self.other.inverse_mass)
        self._moves = Vector3()
        return move, other_move


class FrictionGround(GroundPlane):
    """Level ground that rubs."""

    def __init__(
        self,
        particles: Sequence[Particle],
        friction: float,
        height: float = 0.0,
        radius: float = 0.0,
        restitution: float = 0.0,
    ) -> None:
        super().__init__(particles, height, radius, restitution)
        self.friction = not_negative("friction", friction)

    def contacts(self) -> list[Contact]:
        rubbing: list[Contact] = []
        for c in super().contacts():
            rubbing.append(
                FrictionContact(
                    c.particle, None, c.normal, c.restitution, c.penetration, self.friction
                )
            )
        return rubbing
