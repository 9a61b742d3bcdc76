"""A particle: a point with a mass that moves by Newton's laws (book chapter 3).

Units are SI units. A setter raises TypeError for anything that is not a number, and ValueError for
a number that makes no sense. The particle then keeps its old value.
"""

from __future__ import annotations

import math
from typing import Any

from ch02_vectors.arguments import finite_vector, not_negative, positive, positive_or_infinite
from ch02_vectors.vector import Vector3


class Particle:
    """A point mass with a position, a velocity and a constant acceleration, such as gravity.

    A vector that is assigned to one of the three is checked and copied. A new particle has a mass
    of 1 kg and a damping of 1. The engine stores 1 / mass in ``_inverse_mass`` and the damping in
    ``_damping``. If you need another attribute, add it to ``__slots__``.
    """

    __slots__ = ("_damping", "_inverse_mass", "acceleration", "position", "velocity")

    position: Vector3
    velocity: Vector3
    acceleration: Vector3

    def __init__(
        self,
        position: Vector3 | None = None,
        velocity: Vector3 | None = None,
        acceleration: Vector3 | None = None,
        *,
        mass: float = 1.0,
        damping: float = 1.0,
    ) -> None:
        self.position = Vector3() if position is None else position
        self.velocity = Vector3() if velocity is None else velocity
        self.acceleration = Vector3() if acceleration is None else acceleration
        self.mass = mass
        self.damping = damping

    def __setattr__(self, name: str, value: Any) -> None:
        """Set an attribute. A vector is first checked and copied."""
        if name in ("position", "velocity", "acceleration"):
            value = finite_vector(name, value)
        object.__setattr__(self, name, value)

    @property
    def mass(self) -> float:
        """The mass of the particle in kg, or ``math.inf`` if it is immovable (book 3.2)."""
        return 1.0 / self._inverse_mass if self._inverse_mass else math.inf

    @mass.setter
    def mass(self, mass: float) -> None:
        """Set the mass in kg, which must be positive. Infinity makes the particle immovable."""
        self._inverse_mass = not_negative("1 / mass", 1.0 / positive_or_infinite("mass", mass))

    @property
    def inverse_mass(self) -> float:
        """The inverse of the mass in 1/kg, which is 0 if the particle is immovable."""
        return self._inverse_mass

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass: float) -> None:
        """Set the inverse of the mass, which must be finite and not negative."""
        self._inverse_mass = not_negative("inverse_mass", inverse_mass)

    @property
    def has_finite_mass(self) -> bool:
        """True if the mass is finite, so that forces and impulses can move the particle."""
        return self.mass < math.inf

    @property
    def damping(self) -> float:
        """The fraction d of the velocity that the particle keeps per second (book Eq. 3.6).

        0 stops the particle, and a number above 1 speeds it up.
        """
        return self._damping

    @damping.setter
    def damping(self, damping: float) -> None:
        """Set the damping, which must be finite and not negative."""
        self._damping = not_negative("damping", damping)

    def kinetic_energy(self) -> float:
        """Return the kinetic energy of the particle, m |v|^2 / 2, in J (exercise 3.3).

        An immovable particle does not move, so its kinetic energy is 0.
        """
        if not self.has_finite_mass:
            return 0.0
        return 0.5 * self.mass * self.velocity.squared_magnitude()

    def momentum(self) -> Vector3:
        """Return the momentum of the particle, m v, in kg m/s as a new vector (book 3.2).

        An immovable particle does not move, so its momentum is zero.
        """
        if not self.has_finite_mass:
            return Vector3()
        return self.velocity * self.mass

    @property
    def last_acceleration(self) -> Vector3:
        """The acceleration in the last time step, in m/s^2 as a new vector."""
        return self.acceleration.copy()

    def drift(self, duration: float) -> None:
        """Move the particle for ``duration`` s at its current velocity, which does not change.

        The new position is p' = p + v h (book Eq. 2.7). An immovable particle does not move at all.
        The duration may be 0 or negative, because a step may consist of several drifts.
        """
        if self.has_finite_mass:
            self.position.add_scaled(self.velocity, duration)

    def kick(self, duration: float) -> None:
        """Apply the acceleration and then the damping to the velocity, as in the book's listing.

        The new velocity is v' = (v + a h) d^h, for a ``duration`` of h s (erratum E-16). Use the
        acceleration and the damping that the particle has now. The result does not depend on the
        mass. A kick changes only the velocity, and nothing if the particle is immovable.
        """
        if self.has_finite_mass:
            velocity = self.velocity
            velocity.add_scaled(self.acceleration, duration)
            velocity *= self.damping**duration

    def integrate(self, duration: float) -> None:
        """Advance the particle by one step of explicit Euler: first ``drift``, and then ``kick``.

        So the new position depends only on the old velocity (book 3.3.1, 3.3.2). The new velocity
        must come from ``self.kick(duration)``, because the particle of chapter 5 overrides it. An
        immovable particle does not change.
        """
        positive("duration", duration)
        self.drift(duration)
        self.kick(duration)
