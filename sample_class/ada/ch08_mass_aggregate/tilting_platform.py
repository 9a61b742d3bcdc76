"""A platform that tilts on a pivot, and a weight that tips it (book 8.2.1; mini-project 8.1).

Seen from the side it is a V of rods: a pivot at the ground, and two ends above it, of which the
right one is further away. All of it is there twice, at z = -1 and z = 1, joined by rods.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Rod
from ch08_mass_aggregate.world import ParticleWorld

PLACES = (
    (0.0, 0.0, -1.0),  # the pivot
    (0.0, 0.0, 1.0),
    (-3.0, 2.0, -1.0),  # the left end
    (-3.0, 2.0, 1.0),
    (4.0, 2.0, -1.0),  # the right end
    (4.0, 2.0, 1.0),
)
LEFT, RIGHT = -3.0, 4.0  # m
MASS = 1.0  # kg, of each particle without the weight
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 100  # a phase


def rods_of(particles: Sequence[Particle]) -> list[Rod]:
    rods = []
    pairs = [(end, pivot) for end in (2, 3, 4, 5) for pivot in (0, 1)]
    for i, j in [*pairs, (2, 4), (3, 5), (2, 5), (3, 4), (2, 3), (4, 5)]:
        a, b = particles[i], particles[j]
        rods.append(Rod(a, b, (a.position - b.position).magnitude()))
    return rods


def balancing_mass(masses: Sequence[float], places: Sequence[float], x: float) -> float:
    if len(masses) != len(places):
        wanted = f"places must be as many as masses, {len(masses)}"
        raise ValueError(f"{wanted}, got {len(places)}")
    finite("x", x)
    turn = 0.0
    for i, (mass, place) in enumerate(zip(masses, places, strict=True)):
        turn += not_negative(f"masses[{i}]", mass) * finite(f"places[{i}]", place)
    if turn == 0.0:
        return 0.0
    if x == 0.0 or (x > 0.0) == (turn > 0.0):
        raise ValueError(f"x must be where a mass can balance the others, got {x!r}")
    return finite("the balancing mass", abs(turn / x))


class TiltingPlatform:
    """The platform over the ground, with an immovable pivot: ``particles``, ``rods``, ``world``."""

    def __init__(self) -> None:
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

    def free_pivot(self) -> None:
        one, two = self.particles[:2]
        one.mass = two.mass = MASS
        if any({id(rod.a), id(rod.b)} == {id(one), id(two)} for rod in self.rods):
            return  # it was free already
        axle = Rod(one, two, (two.position - one.position).magnitude())
        self.rods.append(axle)
        self.world.contact_generators.append(axle)

    def put_weight(self, mass: float, x: float) -> None:
        not_negative("mass", mass)
        if not LEFT <= finite("x", x) <= RIGHT:
            raise ValueError(f"x must be from {LEFT!r} to {RIGHT!r}, got {x!r}")
        share = (x - LEFT) / (RIGHT - LEFT)  # of the right end
        for end, part in ((2, 1.0 - share), (4, share)):
            for particle in self.particles[end : end + 2]:
                particle.mass = MASS + 0.5 * part * mass

    def tilt(self) -> float:
        across = self.particles[4].position - self.particles[2].position
        return math.atan2(across.y, across.x)

    def step(self, duration: float) -> None:
        self.world.step(duration)
