"""Ada's wheel."""

import math
from itertools import chain, repeat

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
    spokes = zip(repeat(hub), rim)
    tyre = zip(rim, [*rim[1:], rim[0]])
    return [Rod(a, b, (a.position - b.position).magnitude()) for a, b in chain(spokes, tyre)]


class RimDrive:
    def __init__(self, hub, force):
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle, duration):
        spoke = particle.position - self.hub.position
        spoke.z = 0.0
        forwards = Vector3(0, 0, 1).cross(spoke.normalized())  # zero at the hub
        particle.add_force(forwards * self.force)


def spin(hub, rim):
    momentum, inertia = Vector3(), 0.0
    for p in rim:
        spoke = p.position - hub.position
        spoke.z = 0.0
        momentum.add_scaled(spoke.cross(p.velocity - hub.velocity), p.mass)
        inertia += p.mass * spoke.squared_magnitude()
    return momentum.z / inertia if inertia else 0.0


def deformation(rods):
    def strain(rod):
        return (rod.a.position - rod.b.position).magnitude() / rod.length - 1

    return max((abs(strain(rod)) for rod in rods), default=0.0)


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
