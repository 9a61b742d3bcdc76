"""Ada's particle with forces."""

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle


class Particle(particle.Particle):
    __slots__ = ("_forces",)

    def __init__(self, position=None, velocity=None, acceleration=None, *, mass=1.0, damping=1.0):
        super().__init__(position, velocity, acceleration, mass=mass, damping=damping)
        self._forces = [None, None]

    @property
    def force_accumulator(self):
        if self._forces[0] is None:
            return Vector3()
        return Vector3(*self._forces[0])

    def add_force(self, force):
        total = self.force_accumulator
        total += finite_vector("force", force)
        self._forces[0] = tuple(finite_vector("total force", total))

    def clear_forces(self):
        self._forces[0] = None

    @property
    def last_acceleration(self):
        result = self.acceleration.copy()
        if self._forces[1] is not None:
            result.add_scaled(Vector3(*self._forces[1]), self.inverse_mass)
        return result

    def kick(self, duration):
        finite("duration", duration)
        self._forces = [None, self._forces[0]]
        if self.has_finite_mass:
            self.velocity.add_scaled(self.last_acceleration, duration)
            self.velocity *= self.damping**duration
