"""A wheel of rods about an immovable hub, driven at its rim (mini-project 8.3).

It turns in the X-Y plane, counter-clockwise where its spin is positive.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Rod
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 8  # particles of the rim
RADIUS = 1.0  # m
MASS = 1.0  # kg, of each of them
ITERATIONS = 200  # a phase


def rods_of(hub: Particle, rim: Sequence[Particle]) -> list[Rod]:
    rods: list[Rod] = []
    before = rim[-1]
    for particle in rim:
        for other in (hub, before):
            length = (particle.position - other.position).magnitude()
            rods.append(Rod(other, particle, length))
        before = particle
    return rods


class RimDrive:
    """A force generator that drives a rim: a force of one size in N, round the hub (8.3b)."""

    def __init__(self, hub: Particle, force: float) -> None:
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        spoke = particle.position - self.hub.position
        length = math.hypot(spoke.x, spoke.y)  # without z: the force is always of one size
        if length > 0.0:
            size = self.force / length
            particle.add_force(Vector3(-spoke.y * size, spoke.x * size))


def spin(hub: Particle, rim: Sequence[Particle]) -> float:
    turning = inertia = 0.0
    for particle in filter(lambda one: one.has_finite_mass, rim):
        p = particle.position - hub.position
        v = particle.velocity - hub.velocity
        turning += particle.mass * p.cross(v).z
        inertia += particle.mass * (p.x * p.x + p.y * p.y)
    if inertia == 0.0:
        return 0.0
    return turning / inertia


def deformation(rods: Sequence[Rod]) -> float:
    worst = 0.0
    for rod in rods:
        length = (rod.a.position - rod.b.position).magnitude()
        worst = max(worst, abs(length - rod.length) / rod.length)
    return worst


class Wheel:
    """A wheel: its ``hub``, ``rim``, ``rods`` and ``world``."""

    def __init__(self, force: float = 1.0, driven: int = COUNT) -> None:
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

    def step(self, duration: float) -> None:
        self.world.step(duration)
