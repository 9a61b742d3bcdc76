"""A wheel of rods around an immovable hub, which is driven at its rim (mini-project 8.3).

The wheel rotates in the X-Y plane, and a positive angular velocity is counter-clockwise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Rod
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 8  # particles of the rim
RADIUS = 1.0  # m
MASS = 1.0  # kg, of each of them
AXIS = Vector3(0.0, 0.0, 1.0)
ITERATIONS = 200  # per phase


def rods_of(hub: Particle, rim: Sequence[Particle]) -> list[Rod]:
    """Create the rods of a wheel: its spokes, and the rods along its rim.

    ``rim`` has three or more particles, in order. A spoke joins the hub to each of them. The other
    rods join each particle of the rim to the next one, and the last to the first. The length of
    each rod is the current distance between its ends.
    """
    raise NotImplementedError("Exercise 8.3a: A wheel")


class RimDrive:
    """A force generator that rotates a wheel by pushing particles of its rim around ``hub``.

    Each particle for which it is registered gets the full ``force`` in N.
    """

    def __init__(self, hub: Particle, force: float) -> None:
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Push ``particle`` around the hub, in the X-Y plane and at a right angle to its spoke.

        A positive force rotates the wheel counter-clockwise. It does not depend on the distance
        from the hub. A particle at the hub's position, where no direction is defined, gets none.
        """
        raise NotImplementedError("Exercise 8.3b: Drive the rim")


def spin(hub: Particle, rim: Sequence[Particle]) -> float:
    """Measure how fast a wheel rotates about its hub, in rad/s.

    This is the angular momentum of the rim divided by its moment of inertia. The angular momentum
    is the sum of m (x v_y - y v_x), the Z component of m r x v, and the moment of inertia is the
    sum of m (x^2 + y^2). The hub may itself move, so measure positions and velocities relative to
    the hub. Return 0 if the moment of inertia is zero.
    """
    raise NotImplementedError("Exercise 8.3b: Drive the rim")


def deformation(rods: Sequence[Rod]) -> float:
    """Measure how much a wheel is deformed: the largest relative error in the length of a rod.

    That is the difference from the intended length, divided by the intended length. Return 0 if
    there are no rods.
    """
    raise NotImplementedError("Exercise 8.3c: Does it deform?")


class Wheel:
    """A wheel of particles and rods that rotates about an immovable hub.

    ``world`` simulates the ``hub``, the particles of the ``rim`` and the ``rods``. A RimDrive with
    a ``force`` in N pushes each of the first ``driven`` particles of the rim, from 0 to ``COUNT``.
    """

    def __init__(self, force: float = 1.0, driven: int = COUNT) -> None:
        if not isinstance(driven, int) or driven not in range(COUNT + 1):
            raise ValueError(f"driven must be a whole number from 0 to {COUNT}, got {driven!r}")
        self.hub = Particle(mass=math.inf)
        angles = [math.tau * i / COUNT for i in range(COUNT)]
        spokes = [Vector3(math.cos(angle), math.sin(angle)) * RADIUS for angle in angles]
        self.rim = [Particle(spoke, mass=MASS) for spoke in spokes]
        self.rods = rods_of(self.hub, self.rim)
        self.drive = RimDrive(self.hub, force)
        self.world = ParticleWorld([self.hub, *self.rim], self.rods, iterations=ITERATIONS)
        for particle in self.rim[:driven]:
            self.world.registry.add(particle, self.drive)

    def step(self, duration: float) -> None:
        """Move the wheel forward by one time step of ``duration`` s."""
        self.world.step(duration)
