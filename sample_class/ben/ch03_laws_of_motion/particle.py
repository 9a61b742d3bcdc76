"""Ben has begun with the masses."""

import math

from ch02_vectors.vector import Vector3


class Particle:
    def __init__(self, position=None, velocity=None, acceleration=None, *, mass=1.0, damping=1.0):
        self.position = position or Vector3()
        self.velocity = velocity or Vector3()
        self.acceleration = acceleration or Vector3()
        self.mass = mass
        self.damping = damping

    @property
    def mass(self):
        return 1 / self.inverse_mass

    @mass.setter
    def mass(self, mass):
        if mass <= 0:
            raise ValueError(f"mass must be positive, got {mass}")
        self.inverse_mass = 1 / mass

    @property
    def has_finite_mass(self):
        return not math.isinf(self.mass)

    def momentum(self):
        raise NotImplementedError("Exercise B3.2: Momentum")

    def kinetic_energy(self):
        raise NotImplementedError("Exercise 3.3: Kinetic energy")

    def drift(self, duration):
        raise NotImplementedError("Exercise B3.4: The step")

    def kick(self, duration):
        raise NotImplementedError("Exercise B3.4: The step")

    def integrate(self, duration):
        raise NotImplementedError("Exercise B3.4: The step")
