"""The rules of a sniper game (project 4.2), in which the wind changes between shots.

This module draws nothing, so it works without a screen. The player shoots at four discs of the same
size. The Z axis points down the range, Y points up, and X points to the left of an observer who
faces along Z. The player aims with two angles in radians: the azimuth from Z toward X, and the
elevation above the horizontal.
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
    """A circular target that faces the rifle.

    Its center is at (``x``, ``y``, ``distance``), in m. A hit scores the points of the ring that it
    lands in, multiplied by ``factor``. More distant targets have a larger factor.
    """

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
    """The hole that a bullet makes in a target, and the points that it scores.

    ``x`` and ``y`` are its position in m from the center of the target.
    """

    target: Target
    x: float
    y: float
    points: int


class Wind:
    """A force generator for wind: the drag of moving air, which carries a particle along.

    ``velocity`` is the velocity of the air in m/s. ``k1`` is in N s/m and ``k2`` in N s^2/m^2, as
    in Eq. 5.1.

    Raises:
        ValueError: if a coefficient is negative or not finite.
    """

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)
        self.velocity = Vector3()

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the drag of the moving air to the particle's other forces.

        Compute it with ``drag_force`` from the velocity of the particle relative to the air. A
        particle that moves with the air therefore feels no force. In still air, the force is the
        same as with ``Drag``. Project 4.2.
        """
        particle.add_force(drag_force(particle.velocity - self.velocity, self.k1, self.k2))


class SniperRange:
    """A round of the sniper game: the bullet in flight, the wind, the holes and the score.

    The player has ``SHOTS`` shots in a round.
    """

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
        """Return True once the last shot has been fired and its bullet is no longer in flight."""
        return self.shots_left == 0 and self.bullet is None

    def change_wind(self) -> None:
        """Draw a new horizontal wind at random, with numbers from ``self.random``.

        Draw the component along X first, and then the component along Z, both uniformly from
        -STRONGEST_WIND to STRONGEST_WIND. The order matters, because the same seed must always give
        the same winds. Store the result as the velocity of ``self.wind``, and keep this generator,
        because the registry uses it. Project 4.2.
        """
        self.wind.velocity = Vector3(
            self.random.uniform(-STRONGEST_WIND, STRONGEST_WIND),
            0.0,
            self.random.uniform(-STRONGEST_WIND, STRONGEST_WIND),
        )

    def shoot(self, azimuth: float, elevation: float) -> bool:
        """Try to fire a bullet in the direction of the two angles. Return True if it was fired.

        The rifle does not fire while another bullet is in flight, or if no shots are left.
        Otherwise a bullet of ``BULLET_MASS`` starts at ``MUZZLE`` with ``MUZZLE_SPEED``, and
        ``shots_left`` decreases by 1. Gravity is the bullet's own acceleration, and the wind acts
        on it through ``self.forces``. Project 4.2.
        """
        finite("azimuth", azimuth)
        finite("elevation", elevation)
        if self.bullet is not None or self.shots_left == 0:
            return False
        level = MUZZLE_SPEED * math.cos(elevation)
        velocity = Vector3(
            level * math.sin(azimuth), MUZZLE_SPEED * math.sin(elevation), level * math.cos(azimuth)
        )
        self.bullet = Particle(Vector3(*MUZZLE), velocity, Vector3(*GRAVITY), mass=BULLET_MASS)
        self.forces.add(self.bullet, self.wind)
        self.shots_left -= 1
        return True

    def update(self, duration: float) -> None:
        """Advance the bullet by ``duration`` s, and update the score if it hits a target.

        If no bullet is in flight, do nothing. Otherwise update the forces, move the bullet, and
        call ``hit_on_the_way`` to find out whether it has passed through a target. If it has, add
        the hole to ``holes`` and its points to the score.

        The shot ends with a hit, or when the bullet is below the ground (y < 0) or beyond
        ``END_OF_RANGE`` in z. To prepare for the next shot, clear the registered forces, set
        ``bullet`` to None, and change the wind. Project 4.2.
        """
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
        if hole is not None or bullet.position.y < 0.0 or bullet.position.z > END_OF_RANGE:
            self.forces.clear()
            self.bullet = None
            self.change_wind()


def hit_on_the_way(start: Vector3, end: Vector3) -> Hole | None:
    """Find the first hole that a bullet makes on its straight path from ``start`` to ``end``.

    A target is a flat disc, and the path crosses its plane if start.z < distance <= end.z. If the
    crossing point lies inside a ring, the bullet makes a hole there, which earns the points of the
    ring times the factor of the target. Return None if the bullet hits no target. The vectors
    ``start`` and ``end`` themselves do not change. Project 4.2.
    """
    for target in TARGETS:  # the nearest comes first
        if start.z < target.distance <= end.z:
            share = (target.distance - start.z) / (end.z - start.z)
            x = start.x + (end.x - start.x) * share - target.x
            y = start.y + (end.y - start.y) * share - target.y
            points = ring_points(x, y) * target.factor
            if points:
                return Hole(target, x, y, points)
    return None


def ring_points(x: float, y: float) -> int:
    """Look up the score for a bullet that hits a target at (x, y), in m from the center.

    The smallest ring in ``RINGS`` that contains (x, y) determines the score. A hit on the edge of a
    ring counts as inside. If no ring contains it, the bullet has missed the target, so return 0.
    Project 4.2.
    """
    for radius, points in RINGS:
        if math.hypot(x, y) <= radius:
            return points
    return 0
