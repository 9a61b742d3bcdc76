"""Blob."""

import math
from itertools import combinations

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import ElasticLimitSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Cable, two_particles
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 10
RADIUS = 0.5
MASS = 0.1
STIFFNESS = 30.0
LIMIT, BREAK = 1.2, 2.0
SHARE = 0.25
DAMPING = 0.3
GRAVITY = Vector3(0.0, -9.81, 0.0)


class Bond:
    def __init__(self, a, b, stiffness, rest_length, limit, share, break_length):
        self.a, self.b = two_particles(a, b)
        self._to_b = ElasticLimitSpring(b, stiffness, rest_length, limit, share)
        self._to_a = ElasticLimitSpring(a, stiffness, rest_length, limit, share)
        self.rest_length = rest_length
        self.break_length = positive("break_length", break_length)
        if not rest_length <= limit <= break_length:
            wanted = f"limit must be from rest_length, {rest_length!r}, to break_length, "
            raise ValueError(f"{wanted}{break_length!r}, got {limit!r}")
        self.holds = True

    def update_force(self, particle, duration):
        length = (self.b.position - self.a.position).magnitude()
        self.holds = length <= self.break_length
        if not self.holds:
            return
        if particle is self.a:
            self._to_b.update_force(particle, duration)
        else:
            self._to_a.update_force(particle, duration)


def spread(particles):
    if len(particles) == 0:
        raise ValueError("there are no particles")
    center = Vector3()
    mass = 0.0
    for particle in particles:
        if particle.inverse_mass == 0:
            raise ValueError("one is immovable")
        center += particle.position * particle.mass
        mass += particle.mass
    center /= mass
    total = 0.0
    for particle in particles:
        total += particle.mass * (particle.position - center).squared_magnitude()
    return math.sqrt(total / mass)


class Blob:
    def __init__(self, height=2.0, cables=False):
        middle = Vector3(0.0, positive("height", height))
        places = [middle]
        for i in range(COUNT - 1):
            angle = math.tau * i / (COUNT - 1)
            places.append(middle + Vector3(math.cos(angle), math.sin(angle)) * RADIUS)
        self.particles = [
            Particle(place, acceleration=GRAVITY, mass=MASS, damping=DAMPING) for place in places
        ]
        self.push = Vector3()
        self.world = ParticleWorld(self.particles, [GroundPlane(self.particles)])
        self.bonds = []
        for a, b in combinations(self.particles, 2):
            rest = (b.position - a.position).magnitude()
            bond = Bond(a, b, STIFFNESS, rest, LIMIT * rest, SHARE, BREAK * rest)
            self.bonds.append(bond)
            self.world.registry.add(a, bond)
            self.world.registry.add(b, bond)
            if cables:
                self.world.contact_generators.append(Cable(a, b, BREAK * rest))

    def step(self, duration):
        self.world.start_frame()
        for particle in self.particles:
            particle.add_force(self.push)
        self.world.run_physics(duration)
