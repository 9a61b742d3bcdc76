"""Ada's range."""

import math
from dataclasses import dataclass

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.grenade import FUSE, bounce, fragments
from ch04_particle_engine.targets import strike_first

MUZZLE = (0.0, 1.5, 0.0)
LONGEST_FLIGHT = 5.0
END_OF_RANGE = 200.0


@dataclass(frozen=True)
class ShotType:
    name: str
    mass: float
    velocity: tuple
    acceleration: tuple
    damping: float


SHOT_TYPES = {
    "pistol": ShotType("pistol", 2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    "artillery": ShotType("artillery", 200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    "fireball": ShotType("fireball", 1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    "laser": ShotType("laser", 0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    "grenade": ShotType("grenade", 0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
}


class Shot:
    def __init__(self, type, particle):
        self.type = type
        self.particle = particle
        self.age = 0.0


def aim(speed, azimuth, elevation):
    not_negative("speed", speed)
    finite("azimuth", azimuth)
    finite("elevation", elevation)
    along = Vector3(math.sin(azimuth), 0.0, math.cos(azimuth))
    return (along * math.cos(elevation) + Vector3(0, math.sin(elevation), 0)) * speed


def is_spent(shot):
    place = shot.particle.position
    flying = place.y >= 0 and shot.age <= LONGEST_FLIGHT and place.z <= END_OF_RANGE
    return not flying


def grenade_after(shot):
    bounce(shot.particle)
    if shot.age < FUSE:
        return [] if is_spent(shot) else [shot]
    return [Shot("fragment", piece) for piece in fragments(shot.particle)]


class BallisticRange:
    def __init__(self, targets=()):
        self.targets = list(targets)
        self.shots = []

    def fire(self, name, azimuth=0.0, elevation=None):
        if name not in SHOT_TYPES:
            raise ValueError(f"there is no shot called {name!r}")
        kind = SHOT_TYPES[name]
        speed = Vector3(*kind.velocity).magnitude()
        if elevation is None:
            elevation = math.asin(kind.velocity[1] / speed)
        particle = Particle(
            Vector3(*MUZZLE),
            aim(speed, azimuth, elevation),
            Vector3(*kind.acceleration),
            mass=kind.mass,
            damping=kind.damping,
        )
        self.shots.append(Shot(name, particle))

    def update(self, duration):
        positive("duration", duration)
        for target in self.targets:
            target.particle.integrate(duration)
        self.shots = [left for shot in self.shots for left in self.move(shot, duration)]

    def move(self, shot, duration):
        start = shot.particle.position.copy()
        shot.particle.integrate(duration)
        shot.age += duration
        if strike_first(start, shot.particle, self.targets):
            return []
        if shot.type == "grenade":
            return grenade_after(shot)
        return [] if is_spent(shot) else [shot]
