"""Platform."""

import math

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Rod
from ch08_mass_aggregate.world import ParticleWorld

PLACES = (
    (0.0, 0.0, -1.0),
    (0.0, 0.0, 1.0),
    (-3.0, 2.0, -1.0),
    (-3.0, 2.0, 1.0),
    (4.0, 2.0, -1.0),
    (4.0, 2.0, 1.0),
)
LEFT, RIGHT = -3.0, 4.0
MASS = 1.0
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 100


def rods_of(particles):
    pairs = [(0, 2), (0, 4), (2, 4), (1, 3), (1, 5), (3, 5), (2, 3), (4, 5)]
    rods = []
    for i, j in pairs:
        a, b = particles[i], particles[j]
        rods.append(Rod(a, b, (b.position - a.position).magnitude()))
    return rods


def balancing_mass(masses, places, x):
    finite("x", x)
    if len(masses) != len(places):
        raise ValueError("there must be as many places as masses")
    torque = 0.0
    for m, p in zip(masses, places, strict=True):
        torque += not_negative("mass", m) * finite("place", p)
    mass = -torque / x
    if mass < 0:
        raise ValueError("nothing balances that there")
    return mass


class TiltingPlatform:
    def __init__(self):
        self.particles = [
            Particle(Vector3(*place), acceleration=GRAVITY, mass=MASS, damping=DAMPING)
            for place in PLACES
        ]
        for pivot in self.particles[:2]:
            pivot.mass = math.inf
        self.rods = rods_of(self.particles)
        self.world = ParticleWorld(
            self.particles, [*self.rods, GroundPlane(self.particles)], iterations=ITERATIONS
        )

    def free_pivot(self):
        for pivot in self.particles[:2]:
            pivot.mass = MASS

    def put_weight(self, mass, x):
        not_negative("mass", mass)
        finite("x", x)
        if x < LEFT or x > RIGHT:
            raise ValueError(f"x must be from {LEFT} to {RIGHT}, got {x!r}")
        right = mass * (x - LEFT) / (RIGHT - LEFT)
        left = mass - right
        for i in (2, 3):
            self.particles[i].mass = MASS + left / 2
        for i in (4, 5):
            self.particles[i].mass = MASS + right / 2

    def tilt(self):
        across = self.particles[4].position - self.particles[2].position
        return math.atan2(across.y, across.x)

    def step(self, duration):
        self.world.step(duration)
