"""Ada's particle."""

import math

from ch02_vectors.arguments import (
    finite,
    finite_vector,
    not_negative,
    positive,
    positive_or_infinite,
)
from ch02_vectors.vector import Vector3

VECTORS = ("position", "velocity", "acceleration")


class Particle:
    def __init__(self, position=None, velocity=None, acceleration=None, *, mass=1.0, damping=1.0):
        for name, value in zip(VECTORS, (position, velocity, acceleration), strict=True):
            setattr(self, name, Vector3() if value is None else value)
        self.mass = mass
        self.damping = damping

    def __setattr__(self, name, value):
        if name in VECTORS:
            value = finite_vector(name, value)
        object.__setattr__(self, name, value)

    @property
    def mass(self):
        return 1 / self._inverse_mass if self.has_finite_mass else math.inf

    @mass.setter
    def mass(self, mass):
        self._inverse_mass = 1 / positive_or_infinite("mass", mass)

    @property
    def inverse_mass(self):
        return self._inverse_mass

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass):
        self._inverse_mass = not_negative("inverse_mass", inverse_mass)

    @property
    def has_finite_mass(self):
        return self._inverse_mass != 0

    @property
    def damping(self):
        return self._damping

    @damping.setter
    def damping(self, damping):
        self._damping = not_negative("damping", damping)

    def momentum(self):
        return self.velocity * self.mass if self.has_finite_mass else Vector3()

    def kinetic_energy(self):
        return 0.5 * self.momentum().dot(self.velocity)

    @property
    def last_acceleration(self):
        return self.acceleration.copy()

    def drift(self, duration):
        finite("duration", duration)
        if self.has_finite_mass:
            self.position += self.velocity * duration

    def kick(self, duration):
        finite("duration", duration)
        if self.has_finite_mass:
            self.velocity += self.acceleration * duration
            self.velocity *= self.damping**duration

    def integrate(self, duration):
        positive("duration", duration)
        self.drift(duration)
        self.kick(duration)
