"""A platform that tilts on a pivot, and a weight that tips it (book 8.2.1, mini-project 8.1).

Seen from the side, the platform is a V made of rods, and the tip of the V is the pivot on the
ground. There are two such Vs, one at z = -1 and one at z = 1, with rods between them.
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

    ``particles`` are in the order of ``PLACES``, so the first two are the immovable pivot. You may
    use more rods than necessary. The length of each is the current distance between its ends.
    """
    raise NotImplementedError("Exercise B8.6: A platform that can only tilt")


def balancing_mass(masses: Sequence[float], places: Sequence[float], x: float) -> float:
    """Compute the mass in kg that you must place at ``x`` to balance the platform.

    The platform already carries ``masses`` in kg at the positions ``places`` in m, which are
    negative to the left of the pivot. It is balanced if the torques, the sum of m x, add up to
    zero. If they already do, return 0 for any x, even for 0. Otherwise only a mass on the side that
    rises can balance the platform.

    Raises ValueError if no mass of 0 or more at x balances it, or if an argument is invalid.
    """
    raise NotImplementedError("Exercise B8.7: What tips a platform")


class TiltingPlatform:
    """A platform that tilts on an immovable pivot.

    ``world`` simulates its ``particles``, which are in the order of ``PLACES``, and its ``rods``.
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
        distance apart. If no rod joins them yet, add one to ``self.rods`` and to the contact
        generators of the world. The pivot can then slide, because the ground has no friction. The
        method is called only once.
        """
        raise NotImplementedError("Exercise 8.1: Free the pivot")

    def put_weight(self, mass: float, x: float) -> None:
        """Put a weight of ``mass`` kg on the platform at ``x``, in place of the current weight.

        ``x`` is in m, from ``LEFT`` to ``RIGHT``. There is no particle at this position, so divide
        the mass between the two ends so that the torque about the pivot is the same. Each of the
        two particles of an end carries half of the mass at its end, in addition to its own
        ``MASS``.
        """
        raise NotImplementedError("Exercise B8.7: What tips a platform")

    def tilt(self) -> float:
        """Measure the tilt in radians, which is positive when the right end is higher."""
        across = self.particles[4].position - self.particles[2].position
        return math.atan2(across.y, across.x)

    def step(self, duration: float) -> None:
        """Move the platform forward by one time step of ``duration`` s."""
        self.world.step(duration)
