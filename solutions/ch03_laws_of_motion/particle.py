"""A particle: a point with a mass that moves by Newton's laws (book chapter 3).

All units are SI units: m, m/s, m/s^2, kg, s, J and kg m/s.
"""

from __future__ import annotations

import math
from typing import Any

from ch02_vectors.arguments import finite_vector, not_negative, positive, positive_or_infinite
from ch02_vectors.vector import Vector3


class Particle:
    """A point mass with a position, a velocity and a constant acceleration, such as gravity.

    ``position``, ``velocity`` and ``acceleration`` are vectors, and are zero by default. If you
    assign a vector to one of these attributes, the particle stores a copy, so two particles never
    share a vector. The assignment raises ValueError if the vector is not finite, and TypeError if
    the value is not a vector at all. You may also change single components, as in
    ``particle.velocity.y = 3.0``, but nothing checks these changes, so make sure that the
    components stay finite.

    A new particle has a mass of 1 kg and a damping of 1, unless you pass other numbers. ``damping``
    is the fraction of the velocity that the particle keeps per second. 1 keeps all of it, 0 stops
    the particle, and a number above 1 speeds it up. A particle is immovable if its mass is
    ``math.inf``, which means that its inverse mass is 0.

    The engine stores 1 / mass in ``_inverse_mass`` and the damping in ``_damping``. A particle can
    have only the attributes that are listed in ``__slots__``, so if your code needs another
    attribute, add it to this list.
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
        """Set an attribute. A position, velocity or acceleration is first checked and copied."""
        if name in ("position", "velocity", "acceleration"):
            value = finite_vector(name, value)
        object.__setattr__(self, name, value)

    @property
    def mass(self) -> float:
        """The mass of the particle in kg, which is ``math.inf`` if the particle is immovable.

        The mass is always positive. Book 3.2.
        """
        return 1.0 / self._inverse_mass if self._inverse_mass else math.inf

    @mass.setter
    def mass(self, mass: float) -> None:
        """Set the mass in kg. Use ``math.inf`` to make the particle immovable.

        Like every setter of this class, it raises TypeError for anything that is not a number. If a
        setter raises an error, the particle keeps its old value.

        Raises:
            ValueError: if the mass is not positive.
        """
        self._inverse_mass = not_negative("1 / mass", 1.0 / positive_or_infinite("mass", mass))

    @property
    def inverse_mass(self) -> float:
        """The inverse of the mass, 1 / mass, in 1/kg. It is 0 for an immovable particle.

        The particle stores this number instead of the mass.
        """
        return self._inverse_mass

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass: float) -> None:
        """Set the inverse of the mass, 1 / mass, in 1/kg.

        Raises:
            ValueError: if the inverse mass is negative or not finite.
        """
        self._inverse_mass = not_negative("inverse_mass", inverse_mass)

    @property
    def has_finite_mass(self) -> bool:
        """True if the mass is finite, so that forces and impulses can move the particle."""
        return self.mass < math.inf

    @property
    def damping(self) -> float:
        """The fraction d of the velocity that the particle keeps per second (book Eq. 3.6)."""
        return self._damping

    @damping.setter
    def damping(self, damping: float) -> None:
        """Set the fraction of the velocity that the particle keeps per second.

        Raises:
            ValueError: if the damping is negative or not finite.
        """
        self._damping = not_negative("damping", damping)

    def kinetic_energy(self) -> float:
        """Return the kinetic energy of the particle, m |v|^2 / 2, in J.

        An immovable particle does not move, so its kinetic energy is 0. Exercise 3.3.
        """
        if not self.has_finite_mass:
            return 0.0
        return 0.5 * self.mass * self.velocity.squared_magnitude()

    def momentum(self) -> Vector3:
        """Return the momentum of the particle, m v, in kg m/s as a new vector.

        Momentum stays constant as long as no force acts. An immovable particle does not move, so
        its momentum is zero. Book 3.2.
        """
        if not self.has_finite_mass:
            return Vector3()
        return self.velocity * self.mass

    @property
    def last_acceleration(self) -> Vector3:
        """The total acceleration of the particle in its last time step, in m/s^2 as a new vector.

        No forces act in this chapter, so it equals the constant acceleration. In chapter 5 it also
        includes force / mass.
        """
        return self.acceleration.copy()

    def drift(self, duration: float) -> None:
        """Move the particle for ``duration`` s at its current velocity, which does not change.

        With h = ``duration``, the new position is p' = p + v h. An immovable particle does not move
        at all. The duration may be 0 or negative, because some integrators of chapter 6 split a
        step into several drifts, some of them backward.

        Book Eq. 2.7.
        """
        if self._inverse_mass:
            # Plain floats are many times as fast as operators, which make new vectors.
            position = self.position
            velocity = self.velocity
            position.x += velocity.x * duration
            position.y += velocity.y * duration
            position.z += velocity.z * duration

    def kick(self, duration: float) -> None:
        """Apply the acceleration and damping of the particle to its velocity over ``duration`` s.

        With h = ``duration`` and the damping d, the new velocity is v' = (v + a h) d^h. As in the
        book's listing, the acceleration is applied first, and the damping then acts on the result.
        The book's Eq. 3.6 damps only the old velocity: v d^h + a h (erratum E-16). As in ``drift``,
        the duration may be 0, or negative if the damping is not 0.

        A kick changes only the velocity, and nothing at all if the particle is immovable. Use the
        acceleration and the damping that the particle has now, because a game may change them
        between two steps. The result does not depend on the mass, because the acceleration is
        already given.
        """
        if self._inverse_mass:
            keep = self._damping
            if keep != 1.0:  # without damping there is no power to compute
                keep **= duration
            velocity = self.velocity
            acceleration = self.acceleration
            velocity.x = (velocity.x + acceleration.x * duration) * keep
            velocity.y = (velocity.y + acceleration.y * duration) * keep
            velocity.z = (velocity.z + acceleration.z * duration) * keep

    def integrate(self, duration: float) -> None:
        """Advance the particle by one step of explicit Euler: first ``drift``, and then ``kick``.

        ``duration`` is in s. Because the drift comes first, the new position depends only on the
        old velocity. The term a h^2 / 2 is left out on purpose (book 3.3.1). This is the
        book's integrator (3.3.2), although a comment there gives it another name (erratum E-17).

        The new velocity must come from ``self.kick(duration)``, because the particle of chapter 5
        overrides ``kick`` to add forces. An immovable particle does not change.
        """
        positive("duration", duration)
        self.drift(duration)
        self.kick(duration)
