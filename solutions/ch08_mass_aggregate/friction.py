"""Contacts with Coulomb friction (the book mentions friction in 8.2.2, but does not build it).

While a contact presses two bodies together, friction acts against their sliding. In one step, the
friction impulse is at most mu times the normal impulse. The number mu is the coefficient of
friction. Here it is the same for bodies that slide and for bodies that stick.

Lengths are in m, velocities in m/s, impulses in N s. Arguments of the wrong type raise TypeError.
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

    Semi-implicit Euler has already moved the particles when their contacts are resolved. It moved
    them with velocities that friction had not changed yet. On a slope, a body that should stick
    would therefore slide by g sin(theta) h^2 in every step of h s. So ``resolve_penetration`` also
    changes the positions by the amount that friction changes the velocities, times h. Use an
    integrator that moves the particles with their new velocities, as semi-implicit Euler does.

    Raises:
        ValueError: if the friction is negative or not finite, or Contact rejects an argument.
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
        velocity at a right angle to the normal. The velocity vb is 0 if ``other`` is None.
        """
        velocity = self.particle.velocity.copy()
        if self.other is not None:
            velocity -= self.other.velocity
        return velocity - self.normal * velocity.dot(self.normal)

    def friction_impulse(self, normal_impulse: float) -> Vector3:
        """Compute the impulse of friction on ``particle`` as a new vector in N s.

        ``normal_impulse`` is the size j of the impulse that has just pressed the bodies together.
        The friction impulse points against the sliding velocity. Its size is the smaller one of

        - mu j, which is the most that friction can do, and
        - the impulse that stops the sliding. For the sliding speed s this is s / (1/ma + 1/mb).

        Leave out 1/ma or 1/mb for a particle that is immovable or missing. Return zero if the
        bodies do not slide, or if neither of them can move. This method changes nothing.

        Example:
            A particle of 2 kg slides at (3, 0, 0) on the ground, with mu = 0.5. For a normal
            impulse of 4 N s the result is (-2, 0, 0). For 40 N s it is (-6, 0, 0), which stops it.
        """
        limit = self.friction * not_negative("normal_impulse", normal_impulse)
        sliding = self.sliding_velocity()
        speed = sliding.magnitude()
        total = self._total_inverse_mass()
        if speed == 0.0 or total == 0.0:
            return Vector3()
        return sliding * (-min(limit, speed / total) / speed)

    def resolve_velocity(self, duration: float = 0.0) -> None:
        """Resolve the velocity as ``Contact`` does, and then apply the impulse of friction.

        Raises:
            ValueError: if the duration is negative or not finite, even if nothing would change.
        """
        before = self.separating_velocity()
        super().resolve_velocity(duration)
        total = self._total_inverse_mass()
        gained = max(0.0, self.separating_velocity() - before)  # never negative by rounding
        if gained == 0.0 or total == 0.0:
            return
        impulse = self.friction_impulse(gained / total)
        self._moves.add_scaled(impulse, duration)
        self.particle.velocity.add_scaled(impulse, self.particle.inverse_mass)
        if self.other is not None:
            self.other.velocity.add_scaled(impulse, -self.other.inverse_mass)

    def resolve_penetration(self) -> tuple[Vector3, Vector3]:
        """Move the particles apart as ``Contact`` does, and undo the sliding that friction stopped.

        Returns:
            The displacements of ``particle`` and ``other`` in m, as two new vectors.
        """
        move, other_move = super().resolve_penetration()
        moves, self._moves = self._moves, Vector3()
        move += (back := moves * self.particle.inverse_mass)
        self.particle.position += back
        if self.other is not None:
            other_move -= (back := moves * self.other.inverse_mass)
            self.other.position -= back
        return move, other_move


class FrictionGround(GroundPlane):
    """Level ground with friction: ``GroundPlane`` whose contacts are ``FrictionContact``.

    For a slope at an angle theta, tilt gravity instead of the ground. Give the particles the
    acceleration (g sin(theta), -g cos(theta), 0). ``next_impact`` knows nothing about friction.

    Raises:
        ValueError: if the friction is negative or not finite, or GroundPlane rejects an argument.
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
