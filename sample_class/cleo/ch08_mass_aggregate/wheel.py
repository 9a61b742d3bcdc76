"""Wheel."""

import math

from ch02_vectors.arguments import finite
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Rod
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 8
RADIUS = 1.0
MASS = 1.0
ITERATIONS = 200


def rods_of(hub, rim):
    rods = []
    for particle in rim:
        rods.append(Rod(hub, particle, (particle.position - hub.position).magnitude()))
    for i in range(len(rim) - 1):
        a, b = rim[i], rim[i + 1]
        rods.append(Rod(a, b, (b.position - a.position).magnitude()))
    return rods


class RimDrive:
    def __init__(self, hub, force):
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle, duration):
        spoke = particle.position - self.hub.position
        length = math.hypot(spoke.x, spoke.y)
        if length == 0:
            return
        scale = self.force / length
        particle.add_force(Vector3(-spoke.y * scale, spoke.x * scale, 0))


def spin(hub, rim):
    momentum = 0.0
    inertia = 0.0
    for particle in rim:
        m = particle.mass
        x = particle.position.x - hub.position.x
        y = particle.position.y - hub.position.y
        momentum += m * (x * particle.velocity.y - y * particle.velocity.x)
        inertia += m * (x * x + y * y)
    if inertia == 0:
        return 0.0
    return momentum / inertia


def deformation(rods):
    worst = 0.0
    for rod in rods:
        length = (rod.b.position - rod.a.position).magnitude()
        worst = max(worst, length / rod.length - 1)
    return worst


class Wheel:
    def __init__(self, force=1.0, driven=COUNT):
        self.hub = Particle(mass=math.inf)
        angles = [math.tau * i / COUNT for i in range(COUNT)]
        self.rim = [
            Particle(Vector3(RADIUS * math.cos(angle), RADIUS * math.sin(angle)), mass=MASS)
            for angle in angles
        ]
        self.rods = rods_of(self.hub, self.rim)
        self.drive = RimDrive(self.hub, force)
        self.world = ParticleWorld([self.hub, *self.rim], self.rods, iterations=ITERATIONS)
        for particle in self.rim[:driven]:
            self.world.registry.add(particle, self.drive)

    def step(self, duration):
        self.world.step(duration)
