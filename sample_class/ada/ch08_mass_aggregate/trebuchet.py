"""Ada's trebuchet."""

import math
from dataclasses import dataclass

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Cable, Rod
from ch08_mass_aggregate.world import ParticleWorld

G = 9.81
PIVOT_HEIGHT = 5.0
PROJECTILE_MASS = 5.0
TIP_MASS = 5.0
START = math.radians(200.0)
BEND = math.radians(120.0)
STEP = 1.0 / 250.0
TIME_LIMIT = 4.0
ITERATIONS = 100
MOST_WEIGHT, LONGEST_BEAM = 400.0, 5.0


@dataclass(frozen=True)
class Design:
    counterweight: float
    short_arm: float
    long_arm: float
    sling: float
    release_angle: float

    def __post_init__(self):
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
    range: float
    share: float


def my_design():
    return Design(MOST_WEIGHT, 0.75, LONGEST_BEAM - 0.75, 3.2, 27.0)


class Trebuchet:
    def __init__(self, design):
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

    def beam(self):
        # the lengths of both arms are in the design, the third one is not
        across = (self.weight.position - self.tip.position).magnitude()
        return [
            Rod(self.pivot, self.weight, self.design.short_arm),
            Rod(self.pivot, self.tip, self.design.long_arm),
            Rod(self.weight, self.tip, across),
        ]

    def lets_go(self):
        x, y, _ = self.projectile.velocity
        above = self.projectile.position.y > self.pivot.position.y
        return above and x > 0 and y <= x * math.tan(math.radians(self.design.release_angle))

    def step(self, duration):
        self.world.step(duration)
        if not self.flies and self.lets_go():
            self.flies = True
            self.world.contact_generators.remove(self.sling)

    def throw(self):
        stone, weight = self.projectile, self.weight
        low, high = stone.position.y, weight.position.y
        frames = round(TIME_LIMIT / STEP)
        while not self.flies:
            if not frames or stone.position.y <= 0:
                return Throw(0.0, 0.0)
            self.step(STEP)
            frames -= 1

        x, y, _ = stone.position
        v = stone.velocity
        lost = weight.mass * G * (high - weight.position.y)
        gained = stone.mass * (v.squared_magnitude() / 2 + G * (y - low))
        # up to the top, and down from there
        top = y + v.y**2 / (2 * G)
        time = v.y / G + math.sqrt(2 * top / G)
        return Throw(x + v.x * time - self.pivot.position.x, gained / lost)
