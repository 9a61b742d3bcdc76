"""Point masses that obey Newton's laws and advance one frame at a time. SI units throughout."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3


def _as_number(name: str, value: object) -> float:
    """Turn an int or a float into a float; anything else is a TypeError.

    An int too large for a float becomes an infinity, so that the range checks see it.
    """
    if not isinstance(value, (int, float)):
        raise TypeError(f"{name}: expected a number, got {value!r}")
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def _at_least_zero(name: str, value: object) -> float:
    number = _as_number(name, value)
    if not math.isfinite(number) or number < 0:
        raise ValueError(f"{name}: expected a finite number of 0 or more, got {value!r}")
    return number


def _own_vector(name: str, value: object) -> Vector3:
    """Copy a finite vector for the particle to keep."""
    if not isinstance(value, Vector3):
        raise TypeError(f"{name}: expected a Vector3, got {value!r}")
    if not all(map(math.isfinite, value)):
        raise ValueError(f"{name}: expected finite components, got {value!r}")
    return value.copy()


class Particle:
    """A mass at a point, with a velocity and an acceleration that does not change by itself."""

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

    @property
    def position(self) -> Vector3:
        """Where the particle is, in m."""
        return self._place

    @position.setter
    def position(self, place: Vector3) -> None:
        self._place = _own_vector("position", place)

    @property
    def velocity(self) -> Vector3:
        """How fast it goes and where to, in m/s."""
        return self._motion

    @velocity.setter
    def velocity(self, motion: Vector3) -> None:
        self._motion = _own_vector("velocity", motion)

    @property
    def acceleration(self) -> Vector3:
        """What its velocity gains every second, in m/s^2."""
        return self._pull

    @acceleration.setter
    def acceleration(self, pull: Vector3) -> None:
        self._pull = _own_vector("acceleration", pull)

    @property
    def mass(self) -> float:
        return self._kilograms

    @mass.setter
    def mass(self, mass: float) -> None:
        kilograms = _as_number("mass", mass)
        if math.isnan(kilograms) or kilograms <= 0:
            raise ValueError(f"mass: expected a number above 0, got {mass!r}")
        self._kilograms = kilograms

    @property
    def inverse_mass(self) -> float:
        return 1 / self._kilograms

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass: float) -> None:
        reciprocal = _at_least_zero("inverse_mass", inverse_mass)
        self._kilograms = 1 / reciprocal if reciprocal else math.inf

    @property
    def has_finite_mass(self) -> bool:
        return not math.isinf(self._kilograms)

    @property
    def damping(self) -> float:
        return self._kept_per_second

    @damping.setter
    def damping(self, damping: float) -> None:
        self._kept_per_second = _at_least_zero("damping", damping)

    @property
    def last_acceleration(self) -> Vector3:
        return self._pull.copy()

    def kinetic_energy(self) -> float:
        if not self.has_finite_mass:
            return 0.0
        return 0.5 * self._kilograms * (self._motion @ self._motion)

    def momentum(self) -> Vector3:
        return self._motion * self._kilograms if self.has_finite_mass else Vector3()

    def drift(self, duration: float) -> None:
        seconds = _as_number("duration", duration)
        if not math.isfinite(seconds):
            raise ValueError(f"duration: expected a finite number, got {duration!r}")
        if self.has_finite_mass:
            self._place = self._place + self._motion * seconds

    def kick(self, duration: float) -> None:
        seconds = _as_number("duration", duration)
        if not math.isfinite(seconds):
            raise ValueError(f"duration: expected a finite number, got {duration!r}")
        if self.has_finite_mass:
            kept = math.pow(self._kept_per_second, seconds)
            self._motion = (self._motion + self._pull * seconds) * kept

    def integrate(self, duration: float) -> None:
        seconds = _as_number("duration", duration)
        if not 0 < seconds < math.inf:
            raise ValueError(f"duration: expected a finite number above 0, got {duration!r}")
        self.drift(seconds)
        self.kick(seconds)
