"""The rules of a sniper game (project 4.2), in which the wind changes between shots.

The Z axis points down the range, Y up, and X to the left of an observer who faces along Z. The
azimuth turns from Z toward X, and the elevation up from the horizontal, both in radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
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
    """A disc that faces the rifle. A hit scores the points of its ring times ``factor``."""

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
    """The hole of a bullet in a target, at (x, y) in m from its center, and the points for it."""

    target: Target
    x: float
    y: float
    points: int


class Wind:
    """The drag of air that moves at ``velocity`` in m/s, with k1 and k2 as in Eq. 5.1."""

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)
        self.velocity = Vector3()

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the drag of the moving air to the particle's other forces.

        Compute it with ``drag_force`` from the velocity of the particle relative to the air. A
        particle that moves with the air therefore feels no force.
        """
        raise NotImplementedError("Exercise P4.2a: Sniper range: the wind")


class SniperRange:
    """A round of the game, in which the player has SHOTS shots."""

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
        """Return True once the last bullet is no longer in flight."""
        return self.shots_left == 0 and self.bullet is None

    def change_wind(self) -> None:
        """Draw a new horizontal wind at random, with numbers from ``self.random``.

        Draw the component along X first, and then the one along Z, both uniformly from
        -STRONGEST_WIND to STRONGEST_WIND, because the same seed must always give the same winds.
        Store the result as the velocity of ``self.wind``, and keep this generator, because the
        registry uses it.
        """
        raise NotImplementedError("Exercise P4.2a: Sniper range: the wind")

    def shoot(self, azimuth: float, elevation: float) -> bool:
        """Try to fire a bullet in the direction of the two angles. Return True if it was fired.

        The rifle does not fire while another bullet is in flight, or if no shots are left.
        Otherwise a bullet of ``BULLET_MASS`` starts at ``MUZZLE`` with ``MUZZLE_SPEED``, and
        ``shots_left`` decreases by 1. Gravity is the bullet's own acceleration, and the wind acts
        on it through ``self.forces``.
        """
        raise NotImplementedError("Exercise P4.2b: Sniper range: the rules")

    def update(self, duration: float) -> None:
        """Advance the bullet by ``duration`` s, and update the score if it hits a target.

        If no bullet is in flight, do nothing. Otherwise update the forces, move the bullet, and
        call ``hit_on_the_way``. If the bullet has made a hole, add the hole to ``holes`` and its
        points to the score. The shot ends with a hit, or when the bullet is below the ground (y <
        0) or beyond ``END_OF_RANGE`` in z. Then clear the registered forces, set ``bullet`` to
        None, and change the wind.
        """
        raise NotImplementedError("Exercise P4.2b: Sniper range: the rules")


def hit_on_the_way(start: Vector3, end: Vector3) -> Hole | None:
    """Find the first hole that a bullet makes on its straight path from ``start`` to ``end``.

    The path crosses the plane of a target if start.z < distance <= end.z. If the crossing point
    lies inside a ring, the bullet makes a hole there, which earns the points of the ring times the
    factor of the target. Return None if the bullet hits no target.
    """
    raise NotImplementedError("Exercise P4.2b: Sniper range: the rules")


def ring_points(x: float, y: float) -> int:
    """Return the points of a bullet that hits at (x, y), in m from the center of a target.

    The smallest ring in ``RINGS`` that contains (x, y) counts, with its edge. Without one, it is 0.
    """
    raise NotImplementedError("Exercise P4.2b: Sniper range: the rules")
