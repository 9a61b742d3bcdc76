"""Forces."""

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3


class ForceRegistry:
    def __init__(self):
        self._pairs = []

    def pairs(self):
        return [*self._pairs]

    def add(self, particle, generator):
        if not hasattr(particle, "add_force") or not hasattr(generator, "update_force"):
            raise TypeError(f"no particle and generator: {particle!r}, {generator!r}")
        self._pairs.append((particle, generator))

    def remove(self, particle, generator):
        self._pairs.remove((particle, generator))

    def clear(self):
        self._pairs = []

    def update_forces(self, duration):
        positive("duration", duration)
        for particle, generator in list(self._pairs):
            if particle.has_finite_mass:
                generator.update_force(particle, duration)


class Gravity:
    def __init__(self, acceleration):
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle, duration):
        if particle.has_finite_mass:
            particle.add_force(particle.mass * self.acceleration)


class Drag:
    def __init__(self, k1, k2):
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle, duration):
        particle.add_force(drag_force(particle.velocity, self.k1, self.k2))


def drag_force(velocity, k1, k2):
    speed = velocity.magnitude()
    return velocity / speed * -(k1 * speed + k2 * speed**2)


class Uplift:
    def __init__(self, origin, radius, force):
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle, duration):
        away = particle.position - self.origin
        if away.magnitude() <= self.radius:
            particle.add_force(self.force)


class Airbrake:
    FULL = 1.0 - 1e-12

    def __init__(self, k):
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle, duration):
        if self.on:
            particle.add_force(-self.k * particle.velocity)


class PointGravity:
    def __init__(self, center, strength):
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle, duration):
        if not particle.has_finite_mass:
            return
        direction = self.center - particle.position
        direction *= particle.mass * self.strength
        particle.add_force(direction)


class InverseSquareGravity:
    def __init__(self, center, mu):
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle, duration):
        if not particle.has_finite_mass:
            return
        way = self.center - particle.position
        r = way.magnitude()
        if r > 0:
            particle.add_force(way * (self.mu * particle.mass / r**3))
