"""A sniper range (project 4.2): targets of one size, and a wind that changes between the shots.

The rules need no screen. Z points down the range, Y up and X to the left of one who looks along Z.
A shot is aimed by two angles in radians: azimuth from Z towards X, elevation above the level.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, drag_force
from ch05_forces.particle import Particle

MUZZLE = (0.0, 1.5, 0.0)  # m
MUZZLE_SPEED = 120.0  # m/s: slow enough to be seen, as in chapter 4
SWING = 0.2  # rad, how far the rifle turns to each side, up and down
BULLET_MASS = 1.0  # kg
GRAVITY = (0.0, -2.0, 0.0)  # m/s^2, as slow as the bullet
K1, K2 = 0.02, 0.0003  # N s/m and N s^2/m^2, the drag of the bullet
END_OF_RANGE = 210.0  # m along Z
STRONGEST_WIND = 10.0  # m/s along X and along Z, to either side
SHOTS = 10


@dataclass(frozen=True)
class Target:
    """A disc that faces the rifle: its middle in m, and a factor for the points of its rings."""

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
RINGS = ((0.1, 10), (0.25, 5), (0.5, 2))  # radius in m and points, from the innermost


@dataclass(frozen=True)
class Hole:
    """Where a target was hit, in m from its middle, and the points that it brought."""

    target: Target
    x: float
    y: float
    points: int


class Wind:
    """A force generator: the drag of Eq. 5.1 in air that moves with ``velocity``, in m/s."""

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)
        self.velocity = Vector3()

    def update_force(self, particle: Particle, duration: float) -> None:
        through_the_air = particle.velocity - self.velocity
        particle.add_force(drag_force(through_the_air, self.k1, self.k2))


class SniperRange:
    """A round of SHOTS shots: what is in flight, the wind, the holes and the score."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.wind = Wind(K1, K2)
        self.forces = ForceRegistry()
        self.bullet: Particle | None = None
        self.shots_left = SHOTS
        self.score = 0
        self.holes: list[Hole] = []
        self.change_wind()

    def is_over(self) -> bool:
        return self.shots_left == 0 and self.bullet is None

    def change_wind(self) -> None:
        along_x = self.random.uniform(-STRONGEST_WIND, STRONGEST_WIND)
        along_z = self.random.uniform(-STRONGEST_WIND, STRONGEST_WIND)
        self.wind.velocity = Vector3(along_x, 0.0, along_z)

    def shoot(self, azimuth: float, elevation: float) -> bool:
        for name, angle in (("azimuth", azimuth), ("elevation", elevation)):
            if abs(finite(name, angle)) > SWING:
                raise ValueError(f"{name} must be from {-SWING} to {SWING}, got {angle!r}")
        if self.bullet is not None or self.shots_left < 1:
            return False
        self.bullet = Particle(
            Vector3(*MUZZLE),
            _direction(azimuth, elevation) * MUZZLE_SPEED,
            Vector3(*GRAVITY),
            mass=BULLET_MASS,
        )
        self.forces.add(self.bullet, self.wind)
        self.shots_left -= 1
        return True

    def update(self, duration: float) -> None:
        positive("duration", duration)
        bullet = self.bullet
        if bullet is None:
            return
        start = bullet.position.copy()
        self.forces.update_forces(duration)
        bullet.integrate(duration)
        hole = hit_on_the_way(start, bullet.position)
        if hole is not None:
            self.holes.append(hole)
            self.score += hole.points
        if hole is not None or _is_out(bullet.position):
            self.forces.clear()
            self.bullet = None
            self.change_wind()


def hit_on_the_way(start: Vector3, end: Vector3) -> Hole | None:
    for target in sorted(TARGETS, key=lambda target: target.distance):
        if not start.z < target.distance <= end.z:
            continue
        share = (target.distance - start.z) / (end.z - start.z)
        place = start * (1.0 - share) + end * share
        x, y = place.x - target.x, place.y - target.y
        points = ring_points(x, y) * target.factor
        if points > 0:
            return Hole(target, x, y, points)
    return None


def ring_points(x: float, y: float) -> int:
    off = math.hypot(x, y)
    around = [(radius, points) for radius, points in RINGS if off <= radius]
    return min(around)[1] if around else 0


def _direction(azimuth: float, elevation: float) -> Vector3:
    level = Vector3(math.sin(azimuth), 0.0, math.cos(azimuth))
    return level * math.cos(elevation) + Vector3(0.0, math.sin(elevation), 0.0)


def _is_out(position: Vector3) -> bool:
    return position.y < 0.0 or position.z > END_OF_RANGE
