"""Ada's sniper range."""

import math
from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, drag_force
from ch05_forces.particle import Particle

MUZZLE = (0.0, 1.5, 0.0)
MUZZLE_SPEED = 120.0
SWING = 0.2
BULLET_MASS = 1.0
GRAVITY = (0.0, -2.0, 0.0)
K1, K2 = 0.02, 0.0003
END_OF_RANGE = 210.0
STRONGEST_WIND = 10.0
SHOTS = 10


@dataclass(frozen=True)
class Target:
    x: float
    y: float
    distance: float
    factor: int


TARGETS = (
    Target(-1.5, 1.5, 50.0, 1),
    Target(-0.5, 1.5, 100.0, 2),
    Target(2.0, 1.5, 150.0, 3),
    Target(5.0, 1.5, 200.0, 4),
)
RINGS = ((0.1, 10), (0.25, 5), (0.5, 2))


@dataclass(frozen=True)
class Hole:
    target: Target
    x: float
    y: float
    points: int


class Wind:
    def __init__(self, k1, k2):
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)
        self.velocity = Vector3()

    def update_force(self, particle, duration):
        through_the_air = particle.velocity - self.velocity
        particle.add_force(drag_force(through_the_air, self.k1, self.k2))


class SniperRange:
    def __init__(self, seed):
        self.random = Random(seed)
        self.wind = Wind(K1, K2)
        self.forces = ForceRegistry()
        self.bullet = None
        self.shots_left = SHOTS
        self.score = 0
        self.holes = []
        self.change_wind()

    def is_over(self):
        return self.shots_left == 0 and self.bullet is None

    def change_wind(self):
        x, z = ((self.random.random() * 2 - 1) * STRONGEST_WIND for _ in range(2))
        self.wind.velocity = Vector3(x, 0, z)

    def shoot(self, azimuth, elevation):
        if not (-SWING <= azimuth <= SWING and -SWING <= elevation <= SWING):
            raise ValueError(f"the rifle does not turn to {azimuth}, {elevation}")
        if self.bullet or not self.shots_left:
            return False
        self.bullet = Particle(
            Vector3(*MUZZLE),
            Vector3(
                math.sin(azimuth) * math.cos(elevation),
                math.sin(elevation),
                math.cos(azimuth) * math.cos(elevation),
            )
            * MUZZLE_SPEED,
            Vector3(*GRAVITY),
            mass=BULLET_MASS,
        )
        self.forces.add(self.bullet, self.wind)
        self.shots_left -= 1
        return True

    def update(self, duration):
        positive("duration", duration)
        if self.bullet is None:
            return
        before = self.bullet.position.copy()
        self.forces.update_forces(duration)
        self.bullet.integrate(duration)
        now = self.bullet.position
        hole = hit_on_the_way(before, now)
        if hole:
            self.holes.append(hole)
            self.score += hole.points
        if hole or now.y < 0 or now.z > END_OF_RANGE:
            self.forces.clear()
            self.bullet = None
            self.change_wind()


def hit_on_the_way(start, end):
    for target in TARGETS:
        if not start.z < target.distance <= end.z:
            continue
        place = start + (end - start) * ((target.distance - start.z) / (end.z - start.z))
        x, y = place.x - target.x, place.y - target.y
        if ring_points(x, y):
            return Hole(target, x, y, ring_points(x, y) * target.factor)
    return None


def ring_points(x, y):
    away = math.hypot(x, y)
    return max((points for radius, points in RINGS if away <= radius), default=0)
