"""Contacts with Coulomb friction (the book mentions friction in 8.2.2, but does not build it).

While a contact presses two bodies together, friction acts against their sliding. In one step, the
friction impulse is at most mu times the normal impulse. The coefficient of friction mu is the same
for bodies that slide and for bodies that stick. Impulses are in N s. Constructors raise ValueError
for a friction that is negative or not finite.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane


class FrictionContact(Contact):
    """A contact with friction. ``friction`` is mu, which is 0 if there is no friction.

    Semi-implicit Euler has already moved the particles by h times a velocity that friction had not
    changed yet. On a slope, a body that should stick would slide by g sin(theta) h^2 per step. So
    ``resolve_penetration`` also changes the positions by h times what friction changes.
    """

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
        self._moves = Vector3()  # the friction impulses times the step's duration, in N s^2

    def sliding_velocity(self) -> Vector3:
        """Compute how fast ``particle`` slides along ``other``, as a new vector in m/s.

        With v = va - vb and the normal n, the result is v - (v . n) n, the part of the relative
        velocity along the surface. The velocity vb is 0 if ``other`` is None.
        """
        raise NotImplementedError("Exercise G8.3: Friction")

    def friction_impulse(self, normal_impulse: float) -> Vector3:
        """Compute the impulse of friction on ``particle`` as a new vector in N s.

        ``normal_impulse`` is the size j of the impulse that has just pressed the bodies together.
        The friction impulse points against the sliding velocity. Its size is the smaller one of
        mu j and s / (1/ma + 1/mb), which stops the sliding speed s. Leave out 1/ma or 1/mb for a
        particle that is immovable or missing. Return zero if the bodies do not slide, or if neither
        of them can move. This method changes nothing.
        """
        raise NotImplementedError("Exercise G8.3: Friction")

    def resolve_velocity(self, duration: float = 0.0) -> None:
        """Resolve the velocity as ``Contact`` does, and then apply the impulse of friction."""
        before = self.separating_velocity()
        super().resolve_velocity(duration)
        total = self.total_inverse_mass()
        if total == 0.0:
            return
        gained = max(0.0, self.separating_velocity() - before)  # never negative by rounding
        impulse = self.friction_impulse(gained / total)
        self._moves.add_scaled(impulse, duration)
        self.particle.velocity.add_scaled(impulse, self.particle.inverse_mass)
        if self.other is not None:
            self.other.velocity.add_scaled(impulse, -self.other.inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        """Move the particles apart as ``Contact`` does, and undo the sliding that friction stopped.

        Return the displacements of ``particle`` and ``other`` in m, as two new vectors.
        """
        move, other_move = super().resolve_penetration()
        back = self._moves * self.particle.inverse_mass
        self.particle.position += back
        move += back
        if self.other is not None:
            back = self._moves * self.other.inverse_mass
            self.other.position -= back
            other_move -= back
        self._moves = Vector3()
        return move, other_move


class FrictionGround(GroundPlane):
    """Level ground with friction: a ``GroundPlane`` whose contacts are ``FrictionContact``.

    For a slope, tilt gravity to (g sin(theta), -g cos(theta), 0) instead of the ground.
    """

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
        """Return a contact with friction for each particle that touches the ground."""
        return [
            FrictionContact(c.particle, None, c.normal, c.restitution, c.penetration, self.friction)
            for c in super().contacts()
        ]
