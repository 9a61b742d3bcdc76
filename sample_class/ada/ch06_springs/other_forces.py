"""Forces that depend on where a particle is."""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class Buoyancy:
    """The lift of water, whose surface is level, on a body that floats or sinks in it."""

    def __init__(
        self,
        max_depth: float,
        volume: float,
        water_height: float,
        liquid_density: float = 1000.0,
        gravity: float = 9.81,
    ) -> None:
        self.max_depth = positive("max_depth", max_depth)
        self.volume = positive("volume", volume)
        self.water_height = finite("water_height", water_height)
        self.liquid_density = positive("liquid_density", liquid_density)
        self.gravity = not_negative("gravity", gravity)

    def update_force(self, particle: Particle, duration: float) -> None:
        depth = self.water_height - particle.position.y  # of the middle of the body
        if depth <= -self.max_depth:
            return
        share = 1.0 if depth >= self.max_depth else 0.5 * (1.0 + depth / self.max_depth)
        water = self.liquid_density * (share * self.volume)  # kg
        particle.add_force(Vector3(0.0, water * self.gravity, 0.0))


class LighterThanAir:
    """Exercise 6.2: the lift of a balloon, which falls off with the height: F e^(-y / H)."""

    def __init__(self, max_lift: float, scale_height: float) -> None:
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle: Particle, duration: float) -> None:
        share = min(1.0, math.exp(min(0.0, -particle.position.y / self.scale_height)))
        particle.add_force(Vector3(0.0, self.max_lift * share, 0.0))


class Overcrowding:
    """Exercise 6.3: particles that are too near push apart, as a compressed spring does."""

    def __init__(self, particles: list[Particle], distance: float, stiffness: float) -> None:
        for i, one in enumerate(particles):
            instance_of(f"particles[{i}]", one, Particle)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle: Particle, duration: float) -> None:
        for other in self.particles:
            way = particle.position - other.position
            length = way.magnitude()
            if 0.0 < length < self.distance:
                particle.add_force(way * (self.stiffness * (self.distance / length - 1.0)))


class HomingBullet:
    """Exercise 6.4: a force towards where both will be after ``look_ahead`` s."""

    def __init__(self, target: Particle, stiffness: float, look_ahead: float) -> None:
        self.target = instance_of("target", target, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle: Particle, duration: float) -> None:
        way = self.target.position - particle.position
        way.add_scaled(self.target.velocity - particle.velocity, self.look_ahead)
        particle.add_force(way * self.stiffness)
