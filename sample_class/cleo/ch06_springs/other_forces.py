"""Other forces."""

import math

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class Buoyancy:
    def __init__(self, max_depth, volume, water_height, liquid_density=1000.0, gravity=9.81):
        self.max_depth = positive("max_depth", max_depth)
        self.volume = positive("volume", volume)
        self.water_height = finite("water_height", water_height)
        self.liquid_density = positive("liquid_density", liquid_density)
        self.gravity = not_negative("gravity", gravity)

    def update_force(self, particle, duration):
        depth = particle.position.y
        full = self.liquid_density * self.volume * self.gravity
        if depth >= self.water_height + self.max_depth:
            return
        if depth <= self.water_height - self.max_depth:
            particle.add_force(Vector3(0, full, 0))
            return
        share = (self.water_height + self.max_depth - depth) / (2 * self.max_depth)
        particle.add_force(Vector3(0, full * share, 0))


class LighterThanAir:
    def __init__(self, max_lift, scale_height):
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle, duration):
        lift = self.max_lift * math.exp(-particle.position.y / self.scale_height)
        particle.add_force(Vector3(0, lift, 0))


class Overcrowding:
    def __init__(self, particles, distance, stiffness):
        for i, one in enumerate(particles):
            instance_of(f"particles[{i}]", one, Particle)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle, duration):
        for other in self.particles:
            if other is particle:
                continue
            away = particle.position - other.position
            length = away.magnitude()
            if length < self.distance:
                push = self.stiffness * (self.distance - length)
                particle.add_force(away.normalized() * push)


class HomingBullet:
    def __init__(self, target, stiffness, look_ahead):
        self.target = instance_of("target", target, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle, duration):
        goal = self.target.position + self.target.velocity * self.look_ahead
        particle.add_force((goal - particle.position) * self.stiffness)
