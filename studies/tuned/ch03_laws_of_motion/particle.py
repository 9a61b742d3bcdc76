"""The particle of chapter 3 in plain numbers.

Instead of adding vectors, a step changes their components, and calls no other method. It computes
d^h only if the damping or the duration has changed since the last step.
"""

from __future__ import annotations

import math
from typing import Any

from ch02_vectors.arguments import finite_vector, not_negative, positive, positive_or_infinite
from ch02_vectors.vector import Vector3


class Particle:
    """A point mass, with the attributes and methods of the Particle in solutions/.

    ``_keep`` is d^h for the duration ``_span`` of the last step. ``_span`` is NaN, which equals no
    duration, if no such factor is known, or if the particle is immovable.
    """

    __slots__ = (
        "_damping",
        "_inverse_mass",
        "_keep",
        "_span",
        "acceleration",
        "position",
        "velocity",
    )

    position: Vector3
    velocity: Vector3
    acceleration: Vector3
    _keep: float
    _span: float

    def __init_subclass__(cls) -> None:
        """Let ``integrate`` call a drift or a kick that a subclass has written."""
        super().__init_subclass__()
        own = vars(cls)
        if ("drift" in own or "kick" in own) and "integrate" not in own:
            cls.integrate = drift_and_kick  # type: ignore[assignment]

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
        if name in ("position", "velocity", "acceleration"):
            value = finite_vector(name, value)
        object.__setattr__(self, name, value)

    @property
    def mass(self) -> float:
        return 1.0 / self._inverse_mass if self._inverse_mass else math.inf

    @mass.setter
    def mass(self, mass: float) -> None:
        self._inverse_mass = not_negative("1 / mass", 1.0 / positive_or_infinite("mass", mass))
        self._span = math.nan

    @property
    def inverse_mass(self) -> float:
        return self._inverse_mass

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass: float) -> None:
        self._inverse_mass = not_negative("inverse_mass", inverse_mass)
        self._span = math.nan

    @property
    def has_finite_mass(self) -> bool:
        return self.mass < math.inf

    @property
    def damping(self) -> float:
        return self._damping

    @damping.setter
    def damping(self, damping: float) -> None:
        self._damping = not_negative("damping", damping)
        self._span = math.nan

    def kinetic_energy(self) -> float:
        if not self._inverse_mass:
            return 0.0
        return 0.5 * self.mass * self.velocity.squared_magnitude()

    def momentum(self) -> Vector3:
        return self.velocity * self.mass if self._inverse_mass else Vector3()

    @property
    def last_acceleration(self) -> Vector3:
        return self.acceleration.copy()

    def drift(self, duration: float) -> None:
        if self._inverse_mass:
            position, velocity = self.position, self.velocity
            position.x += velocity.x * duration
            position.y += velocity.y * duration
            position.z += velocity.z * duration

    def kick(self, duration: float) -> None:
        if self._inverse_mass:
            keep = self._keep if duration == self._span else self._factor(duration)
            velocity, acceleration = self.velocity, self.acceleration
            velocity.x = (velocity.x + acceleration.x * duration) * keep
            velocity.y = (velocity.y + acceleration.y * duration) * keep
            velocity.z = (velocity.z + acceleration.z * duration) * keep

    def integrate(self, duration: float) -> None:
        if duration != self._span and not self._renew(duration):
            return
        position = self.position
        velocity = self.velocity
        position.x += velocity.x * duration
        position.y += velocity.y * duration
        position.z += velocity.z * duration
        acceleration = self.acceleration
        keep = self._keep
        velocity.x = (velocity.x + acceleration.x * duration) * keep
        velocity.y = (velocity.y + acceleration.y * duration) * keep
        velocity.z = (velocity.z + acceleration.z * duration) * keep

    def _renew(self, duration: float) -> bool:
        """Compute the factor d^h of a step, and return False if the particle is immovable."""
        if type(duration) is not float or not 0.0 < duration < math.inf:
            positive("duration", duration)
        if not self._inverse_mass:
            return False
        self._factor(duration)
        return True

    def _factor(self, duration: float) -> float:
        """Return the factor d^h, and store it if it can be that of a whole step."""
        keep: float = self._damping**duration
        if 0.0 < duration < math.inf:
            _set_keep(self, keep)
            _set_span(self, duration)
        return keep


# These set an attribute without calling Particle.__setattr__, in a quarter of the time.
_set_keep, _set_span = vars(Particle)["_keep"].__set__, vars(Particle)["_span"].__set__
set_inverse_mass = vars(Particle)["_inverse_mass"].__set__  # set it back before the next step


def drift_and_kick(particle: Particle, duration: float) -> None:
    """Make a step of explicit Euler with the methods of a subclass."""
    positive("duration", duration)
    particle.drift(duration)
    particle.kick(duration)
