"""A trebuchet: a heavy counterweight throws a projectile from a sling (project 8.2).

All is in the X-Y plane, and the projectile flies towards positive X. A beam turns on an immovable
pivot. It is bent there, so that three rods make it rigid: its short arm carries the counterweight,
its long arm ends in a tip, from which the sling hangs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.links import Cable, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

G = 9.81  # m/s^2
PIVOT_HEIGHT = 5.0  # m above the ground
PROJECTILE_MASS = 5.0  # kg
TIP_MASS = 5.0  # kg, what the beam counts for at its tip
START = math.radians(200.0)  # where the long arm points to at the start, from X towards Y
BEND = math.radians(120.0)  # from the long arm back to the short one, which stands up at the start
STEP = 1.0 / 250.0  # s
TIME_LIMIT = 4.0  # s: what has not let go until then throws nothing
ITERATIONS = 100  # a phase
MOST_WEIGHT, LONGEST_BEAM = 400.0, 5.0  # kg and m: what my_design may have, its arms together


@dataclass(frozen=True)
class Design:
    """What may be chosen of a trebuchet: kg, m and degrees."""

    counterweight: float
    short_arm: float
    long_arm: float
    sling: float
    release_angle: float

    def __post_init__(self) -> None:
        positive("counterweight", self.counterweight)
        positive("short_arm", self.short_arm)
        positive("long_arm", self.long_arm)
        positive("sling", self.sling)
        if not -90.0 < finite("release_angle", self.release_angle) < 90.0:
            raise ValueError(f"release_angle must be in (-90, 90), got {self.release_angle!r}")
        if PIVOT_HEIGHT + self.long_arm * math.sin(START) < self.sling:
            raise ValueError(f"sling must not reach the ground, got {self.sling!r}")


@dataclass(frozen=True)
class Throw:
    """What a throw came to: the range in m from below the pivot, and the share of the energy."""

    range: float
    share: float


def my_design() -> Design:
    return Design(400.0, 0.68, 4.24, 3.41, 25.0)  # found by many throws


class Trebuchet:
    """A trebuchet of a design: its particles, and the ``world`` in which they move."""

    def __init__(self, design: Design) -> None:
        down = Vector3(0.0, -G, 0.0)
        self.design = design
        pivot = Vector3(0.0, PIVOT_HEIGHT, 0.0)
        long_arm = Vector3(math.cos(START), math.sin(START)) * design.long_arm
        short_arm = Vector3(math.cos(START - BEND), math.sin(START - BEND)) * design.short_arm
        self.pivot = Particle(pivot, mass=math.inf)
        self.weight = Particle(pivot + short_arm, acceleration=down, mass=design.counterweight)
        self.tip = Particle(pivot + long_arm, acceleration=down, mass=TIP_MASS)
        self.projectile = Particle(
            self.tip.position - Vector3(0.0, design.sling), acceleration=down, mass=PROJECTILE_MASS
        )
        self.flies = False
        self.sling = Cable(self.tip, self.projectile, design.sling)
        particles = [self.pivot, self.weight, self.tip, self.projectile]
        self.world = ParticleWorld(particles, [*self.beam(), self.sling], iterations=ITERATIONS)

    def beam(self) -> list[ContactGenerator]:
        corners = (self.pivot, self.weight, self.tip)
        return [
            TwoSidedRod(a, b, (b.position - a.position).magnitude())
            for a, b in combinations(corners, 2)
        ]

    def lets_go(self) -> bool:
        v = self.projectile.velocity
        if v.x <= 0.0 or self.projectile.position.y <= self.pivot.position.y:
            return False
        return v.y <= v.x * math.tan(math.radians(self.design.release_angle))

    def step(self, duration: float) -> None:
        self.world.step(duration)
        if not self.flies and self.lets_go():
            self.flies = True
            self.world.contact_generators.remove(self.sling)

    def throw(self) -> Throw:
        ball = self.projectile
        first, weight_first = ball.position.y, self.weight.position.y
        frames = round(TIME_LIMIT / STEP)
        while frames and not self.flies and ball.position.y > 0.0:
            self.step(STEP)
            frames -= 1
        if not self.flies:
            return Throw(0.0, 0.0)
        place, v = ball.position, ball.velocity
        gained = ball.kinetic_energy() + ball.mass * G * (place.y - first)
        lost = self.weight.mass * G * (weight_first - self.weight.position.y)
        top = place.y + v.y * v.y / (2.0 * G)  # behind it, where it flies downwards already
        time = v.y / G + math.sqrt(2.0 * top / G)
        distance = place.x - self.pivot.position.x + v.x * time
        return Throw(distance, gained / lost if lost > 0.0 else 0.0)
