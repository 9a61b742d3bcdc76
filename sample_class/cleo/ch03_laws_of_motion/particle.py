"""Cleo's particle: damping as in the book's equation, and whatever it is given."""

import math


from ch02_vectors.vector import Vector3


class Particle:
    def __init__(self, position=None, velocity=None, acceleration=None, *, mass=1.0, damping=1.0):
        self.position = position.copy() if position else Vector3()
        self.velocity = velocity.copy() if velocity else Vector3()
        self.acceleration = acceleration.copy() if acceleration else Vector3()
        self.inverse_mass = 1 / mass
        self.damping = damping

    @property
    def mass(self):
        return 1 / self.inverse_mass if self.inverse_mass else math.inf

    @mass.setter
    def mass(self, mass):
        self.inverse_mass = 1 / mass

    @property
    def has_finite_mass(self):
        return self.inverse_mass != 0

    @property
    def last_acceleration(self):
        return self.acceleration

    def momentum(self):
        return self.velocity * self.mass

    def kinetic_energy(self):
        return self.mass * self.velocity.squared_magnitude() / 2

    def drift(self, duration):
        if self.has_finite_mass:
            self.position.add_scaled(self.velocity, duration)

    def kick(self, duration):
        if self.has_finite_mass:
            self.velocity *= self.damping**duration
            self.velocity.add_scaled(self.acceleration, duration)

    def integrate(self, duration):
        if duration <= 0:
            raise ValueError("duration must be positive")
        self.drift(duration)
        self.kick(duration)
