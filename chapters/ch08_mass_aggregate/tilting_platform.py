"""A platform that tilts on a pivot, and a weight that tips it (book 8.2.1, mini-project 8.1).

Seen from the side, the platform is a V made of rods, and the tip of the V is the pivot on the
ground. The right end is farther from the pivot than the left end. The platform consists of two such
Vs, one at z = -1 and one at z = 1, with rods between them. Arguments of the wrong type raise
TypeError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

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
MASS = 1.0  # kg, of each particle, without the weight
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 100  # per phase


def rods_of(particles: Sequence[Particle]) -> list[Rod]:
    """Create rods that make the platform rigid, so that it can tilt but not move in any other way.

    ``particles`` are in the order of ``PLACES``, so the first two are the pivot, which is
    immovable. You choose which particles to join, and you may use more rods than necessary. The
    length of each rod is the current distance between its ends.
    """
    raise NotImplementedError("Exercise B8.6: A platform that can only tilt")


def balancing_mass(masses: Sequence[float], places: Sequence[float], x: float) -> float:
    """Compute the mass in kg that you must place at ``x`` to balance the platform.

    The platform already carries other masses: ``masses`` in kg, at the positions ``places`` in m.
    Positions are measured along the platform from the pivot, and are negative to the left of it.
    The torque of each mass is proportional to the mass times its position. The platform is balanced
    if all torques add up to zero.

    If they already do, return 0 for any x, even for 0. Otherwise, a mass of 0 or more can balance
    the platform only on the side that rises.

    Raises:
        ValueError: if no mass of 0 or more at x balances the platform.
    """
    raise NotImplementedError("Exercise B8.7: What tips a platform")


class TiltingPlatform:
    """A platform of particles and rods that tilts on an immovable pivot.

    ``world`` simulates the platform. Its ``particles`` are in the same order as their start
    positions in ``PLACES``.
    """

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
        """Make the pivot movable, so that it rests on the ground without being fixed to it.

        Give each of the pivot's two particles the mass ``MASS``. A rod must now keep them the same
        distance apart, because they are no longer immovable. If no rod joins them yet, add one to
        ``self.rods`` and to the contact generators of the world. The pivot can then slide, because
        the ground has no friction. You may assume that this method is called only once.
        Mini-project 8.1.
        """
        raise NotImplementedError("Exercise 8.1: Free the pivot")

    def put_weight(self, mass: float, x: float) -> None:
        """Put a weight of ``mass`` kg on the platform at ``x``, in place of the current weight.

        ``x`` is the position along the platform in m, from ``LEFT`` to ``RIGHT``. There is no
        particle at this position, so the two ends of the platform carry the weight. Divide the mass
        between the ends so that the torque about the pivot is the same as with the weight at ``x``.
        Each end consists of two particles. Each of these carries half of the mass at its end, in
        addition to its own ``MASS``.
        """
        raise NotImplementedError("Exercise B8.7: What tips a platform")

    def tilt(self) -> float:
        """Measure how far the platform is tilted, as an angle in radians.

        The angle is 0 at the start, and positive when the right end is higher.
        """
        across = self.particles[4].position - self.particles[2].position
        return math.atan2(across.y, across.x)

    def step(self, duration: float) -> None:
        """Move the platform forward by one time step of ``duration`` s."""
        self.world.step(duration)
