"""Hana's particle, which is right: what goes wrong comes from her vectors."""

import math

from ch02_vectors.vector import Vector3
from ch02_vectors import arguments


class Particle:
    def __init__(self, position=None, velocity=None, acceleration=None, *, mass=1.0, damping=1.0):
        self.position = position or Vector3()
        self.velocity = velocity or Vector3()
        self.acceleration = acceleration or Vector3()
        self.mass = mass
        self.damping = damping

    def __setattr__(self, name, value):
        if name in ("position", "velocity", "acceleration"):
            value = arguments.finite_vector(name, value)
        super().__setattr__(name, value)

    @property
    def mass(self):
        return self._mass

    @mass.setter
    def mass(self, mass):
        self._mass = arguments.positive_or_infinite("mass", mass)

    @property
    def inverse_mass(self):
        return 1 / self._mass

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass):
        arguments.not_negative("inverse_mass", inverse_mass)
        self._mass = 1 / inverse_mass if inverse_mass else math.inf

    @property
    def has_finite_mass(self):
        return self._mass < math.inf

    @property
    def damping(self):
        return self._damping

    @damping.setter
    def damping(self, damping):
        self._damping = arguments.not_negative("damping", damping)

    def momentum(self):
        if self.has_finite_mass:
            return self.mass * self.velocity
        return Vector3()

    def kinetic_energy(self):
        if self.has_finite_mass:
            return self.mass * self.velocity.squared_magnitude() / 2
        return 0.0

    @property
    def last_acceleration(self):
        return self.acceleration.copy()

    def drift(self, duration):
        arguments.finite("duration", duration)
        if self.has_finite_mass:
            self.position.add_scaled(self.velocity, duration)

    def kick(self, duration):
        arguments.finite("duration", duration)
        if self.has_finite_mass:
            self.velocity.add_scaled(self.acceleration, duration)
            self.velocity *= self.damping**duration

    def integrate(self, duration):
        arguments.positive("duration", duration)
        self.drift(duration)
        self.kick(duration)
