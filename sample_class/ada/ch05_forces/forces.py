"""Force generators, and the registry that asks them for their forces once a frame (book 5.2, 5.3).

A generator adds a force to a particle, and knows nothing of the other forces that act on it. What
one is made with is looked at and, where it is a vector, copied. Its attributes may be changed
later, and are then yours to keep finite.
"""

from __future__ import annotations

import math
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class ForceGenerator(Protocol):
    """Whatever has this method is a force generator: no class needs to derive from this one."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add this generator's force on a particle, for a frame of a duration in s (5.2.1)."""


class ForceRegistry:
    """Pairs of a particle and a generator, in the order in which they were added."""

    def __init__(self) -> None:
        self._pairs: list[tuple[Particle, ForceGenerator]] = []

    def pairs(self) -> list[tuple[Particle, ForceGenerator]]:
        return [*self._pairs]

    def add(self, particle: Particle, generator: ForceGenerator) -> None:
        _must_have(particle, "particle", "add_force")
        _must_have(generator, "generator", "update_force")
        self._pairs.append((particle, generator))

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        for index in reversed(range(len(self._pairs))):
            one, other = self._pairs[index]
            if one is particle and other is generator:
                del self._pairs[index]
                return

    def clear(self) -> None:
        self._pairs = []

    def update_forces(self, duration: float) -> None:
        positive("duration", duration)
        for particle, generator in tuple(self._pairs):
            if particle.has_finite_mass:
                generator.update_force(particle, duration)


class Gravity:
    """The weight of a particle, m g (Eq. 3.4), for an acceleration g in m/s^2: a vector."""

    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        if particle.has_finite_mass:
            particle.add_force(particle.mass * self.acceleration)


class Drag:
    """Drag against the motion (Eq. 5.1): a linear and a quadratic part."""

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle: Particle, duration: float) -> None:
        particle.add_force(drag_force(particle.velocity, self.k1, self.k2))


def drag_force(velocity: Vector3, k1: float, k2: float) -> Vector3:
    # v^ |v| is v, so one |v| goes into it: no division, and nothing to ask of a zero.
    return velocity * -(k1 + k2 * velocity.magnitude())


class Uplift:
    """Exercise 5.1: a vertical column of rising air that has no top."""

    def __init__(self, origin: Vector3, radius: float, force: Vector3) -> None:
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        away = particle.position - self.origin
        away.y = 0.0
        if away.magnitude() <= self.radius:
            particle.add_force(self.force)


class Airbrake:
    """Exercise 5.2: a large drag, -k v with k in N s/m, that is switched on and off."""

    # The share of a full stop that the brake takes at most: rounding cannot make it more than all.
    FULL = 1.0 - 1e-12

    def __init__(self, k: float) -> None:
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle: Particle, duration: float) -> None:
        positive("duration", duration)
        if not self.on:
            return
        strongest = self.FULL * particle.mass / duration  # this k would take FULL of the velocity
        particle.add_force(-particle.velocity * min(self.k, strongest))


class PointGravity:
    """Exercise 5.3: gravity towards a point, of the same strength in m/s^2 at every distance."""

    def __init__(self, center: Vector3, strength: float) -> None:
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle: Particle, duration: float) -> None:
        if not particle.has_finite_mass:
            return
        direction = (self.center - particle.position).normalized()
        particle.add_force(direction * particle.mass * self.strength)


class InverseSquareGravity:
    """Exercise 5.4: gravity towards a point, by the inverse square (Eq. 3.3)."""

    def __init__(self, center: Vector3, mu: float) -> None:
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle: Particle, duration: float) -> None:
        if not particle.has_finite_mass:
            return
        way = self.center - particle.position
        r = way.magnitude()
        if r == 0.0:
            raise ArithmeticError(f"there is no direction at the center {self.center!r}")
        force = way.normalized() * ((self.mu / r) * (particle.mass / r))
        if not all(math.isfinite(component) for component in force):
            raise ArithmeticError(f"the force is not finite at {r!r} m from {self.center!r}")
        particle.add_force(force)


def _must_have(thing: object, name: str, method: str) -> None:
    if not callable(getattr(thing, method, None)):
        raise TypeError(f"{name} must have a method {method}, got {thing!r}")
