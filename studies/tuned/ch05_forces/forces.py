"""The force registry of chapter 5 without calls of its own, and weights in plain numbers.

The registry checks a duration only if it differs from the last one, copies its pairs only after a
change, and reads an inverse mass without its property.
"""

from __future__ import annotations

import math
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class ForceGenerator(Protocol):
    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force to the others on ``particle``. Change nothing else."""


class ForceRegistry:
    def __init__(self) -> None:
        self._pairs: list[tuple[Particle, ForceGenerator]] = []
        self._fixed: tuple[tuple[Particle, ForceGenerator], ...] | None = None  # a copy, or None
        self._checked = math.nan  # the last duration that was checked

    def pairs(self) -> list[tuple[Particle, ForceGenerator]]:
        return [*self._pairs]

    def add(self, particle: Particle, generator: ForceGenerator) -> None:
        self._pairs.append((particle, generator))
        self._fixed = None

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        for i, (other, others) in enumerate(self._pairs):
            if other is particle and others is generator:
                del self._pairs[i]
                self._fixed = None
                return

    def clear(self) -> None:
        self._pairs.clear()
        self._fixed = None

    def update_forces(self, duration: float) -> None:
        if duration != self._checked:
            self._checked = positive("duration", duration)
        if (pairs := self._fixed) is None:
            pairs = self._fixed = tuple(self._pairs)
        for particle, generator in pairs:
            if particle._inverse_mass:
                generator.update_force(particle, duration)


class Gravity:
    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        if particle._inverse_mass:
            mass, g = 1.0 / particle._inverse_mass, self.acceleration
            particle.add_numbers(g.x * mass, g.y * mass, g.z * mass)


class Drag:
    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle: Particle, duration: float) -> None:
        v = particle.velocity
        k = self.k1 + self.k2 * math.hypot(v.x, v.y, v.z)
        particle.add_numbers(v.x * -k, v.y * -k, v.z * -k)


def drag_force(velocity: Vector3, k1: float, k2: float) -> Vector3:
    return velocity * -(k1 + k2 * velocity.magnitude())


class Uplift:
    def __init__(self, origin: Vector3, radius: float, force: Vector3) -> None:
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        place = particle.position
        if math.hypot(place.x - self.origin.x, place.z - self.origin.z) <= self.radius:
            particle.add_force(self.force)


class Airbrake:
    # The share of a full stop that the brake takes at most: rounding cannot make it more than all.
    FULL = 1.0 - 1e-12

    def __init__(self, k: float) -> None:
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle: Particle, duration: float) -> None:
        positive("duration", duration)
        if self.on:
            most = self.FULL * particle.mass / duration
            particle.add_force(particle.velocity * -min(self.k, most))


class PointGravity:
    def __init__(self, center: Vector3, strength: float) -> None:
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle: Particle, duration: float) -> None:
        if particle.has_finite_mass:
            way = (self.center - particle.position).normalized()
            particle.add_force(way * (particle.mass * self.strength))


class InverseSquareGravity:
    def __init__(self, center: Vector3, mu: float) -> None:
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle: Particle, duration: float) -> None:
        if not particle.has_finite_mass:
            return
        way = self.center - particle.position
        distance = way.magnitude()
        force = particle.mass / distance * (self.mu / distance) if distance else math.inf
        if not math.isfinite(force):
            raise ArithmeticError(f"the force is not finite at {distance!r} m from the center")
        particle.add_force(way.normalized() * force)
