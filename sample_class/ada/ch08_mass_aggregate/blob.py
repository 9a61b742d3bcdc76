"""A blob: particles that bonds pull together, which give way, break and heal (book 8.2.3)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import ElasticLimitSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Cable, two_particles
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 10  # particles, one of them in the middle
RADIUS = 0.5  # m, from the middle to the others
MASS = 0.1  # kg, of each particle
STIFFNESS = 30.0  # N/m, of a bond
LIMIT, BREAK = 1.2, 2.0  # of the length of a bond at rest
SHARE = 0.25  # of the stiffness that is left beyond LIMIT
DAMPING = 0.3
GRAVITY = Vector3(0.0, -9.81, 0.0)


class Bond:
    """A soft spring between two particles with a limit of elasticity, which breaks and heals."""

    def __init__(
        self,
        a: Particle,
        b: Particle,
        stiffness: float,
        rest_length: float,
        limit: float,
        share: float,
        break_length: float,
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self._to_b = ElasticLimitSpring(b, stiffness, rest_length, limit, share)
        self._to_a = ElasticLimitSpring(a, stiffness, rest_length, limit, share)
        self.rest_length = rest_length
        self.break_length = positive("break_length", break_length)
        if not rest_length <= limit <= break_length:
            wanted = f"limit must be from rest_length, {rest_length!r}, to break_length, "
            raise ValueError(f"{wanted}{break_length!r}, got {limit!r}")
        self.holds = True

    def update_force(self, particle: Particle, duration: float) -> None:
        length = (self.a.position - self.b.position).magnitude()
        if length > self.break_length:
            self.holds = False
        elif length <= self.rest_length:
            self.holds = True
        if not self.holds:
            return
        if particle is self.a:
            self._to_b.update_force(particle, duration)
        elif particle is self.b:
            self._to_a.update_force(particle, duration)


def spread(particles: Sequence[Particle]) -> float:
    if not particles:
        raise ValueError("particles must be one or more, got none")
    middle, total = Vector3(), 0.0
    for i, one in enumerate(particles):
        if not one.has_finite_mass:
            raise ValueError(f"particles[{i}] must not be immovable, got {one!r}")
        total += one.mass
        middle += (one.position - middle) * (one.mass / total)  # the middle of all up to this one
    squares = sum(one.mass * (one.position - middle).squared_magnitude() for one in particles)
    return math.sqrt(squares / total)


class Blob:
    """A blob that falls on the ground, with bonds between all of its particles."""

    def __init__(self, height: float = 2.0, cables: bool = False) -> None:
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

    def step(self, duration: float) -> None:
        self.world.start_frame()
        for particle in self.particles:
            particle.add_force(self.push)
        self.world.run_physics(duration)
