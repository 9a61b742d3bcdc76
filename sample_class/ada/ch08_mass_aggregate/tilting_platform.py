"""Ada's seesaw."""

import math
from itertools import product

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

# Whoever is not of one's own kind is held: 12 rods, one more than are needed.
PIVOT_NUMBERS, LEFT_NUMBERS, RIGHT_NUMBERS = (0, 1), (2, 3), (4, 5)
HELD = [
    *product(PIVOT_NUMBERS, LEFT_NUMBERS),
    *product(PIVOT_NUMBERS, RIGHT_NUMBERS),
    *product(LEFT_NUMBERS, RIGHT_NUMBERS),
]


def rod_between(a, b):
    return Rod(a, b, (a.position - b.position).magnitude())


def rods_of(particles):
    return [rod_between(particles[i], particles[j]) for i, j in HELD]


def balancing_mass(masses, places, x):
    if len(masses) != len(places):
        raise ValueError(f"{len(masses)} masses, but {len(places)} places")
    finite("x", x)
    turn = 0.0
    for i, (m, place) in enumerate(zip(masses, places)):
        turn += not_negative(f"masses[{i}]", m) * finite(f"places[{i}]", place)
    if turn == 0:
        return 0.0  # nothing to do
    if x == 0:
        raise ValueError("on the pivot no mass turns anything")
    return not_negative("the mass that would balance them", -turn / x)


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
        one, other = self.particles[:2]
        if one.has_finite_mass:
            return  # it is free already
        one.mass = other.mass = MASS
        axle = rod_between(one, other)
        self.rods.append(axle)
        self.world.contact_generators.append(axle)

    def put_weight(self, mass, x):
        not_negative("mass", mass)
        if not LEFT <= finite("x", x) <= RIGHT:
            raise ValueError(f"x is not between the ends: {x!r}")
        s = (x - LEFT) / (RIGHT - LEFT)
        for numbers, share in (LEFT_NUMBERS, 1 - s), (RIGHT_NUMBERS, s):
            for i in numbers:
                self.particles[i].mass = MASS + mass * share / 2

    def tilt(self):
        across = self.particles[4].position - self.particles[2].position
        return math.atan2(across.y, across.x)

    def step(self, duration):
        self.world.step(duration)
