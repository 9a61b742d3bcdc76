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
ITERATIONS = 200  # per phase


def rods_of(hub: Particle, rim: Sequence[Particle]) -> list[Rod]:
    """Create the rods of a wheel: its spokes, and the rods along its rim.

    ``rim`` has three or more particles, in order. A spoke joins the hub to each of them. The rods
    along the rim join each particle to the next one, and the last particle to the first. The length
    of each rod is the current distance between its ends. Mini-project 8.3a.
    """
    raise NotImplementedError("Exercise 8.3a: A wheel")


class RimDrive:
    """A force generator that rotates a wheel by pushing the particles of its rim around ``hub``.

    ``force`` is in N, and a positive value pushes counter-clockwise. Register the drive for each
    particle of the rim that it should push. It pushes each of them with the full force.
    Mini-project 8.3b.
    """

    def __init__(self, hub: Particle, force: float) -> None:
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Push ``particle`` around the hub, in the X-Y plane and at a right angle to its spoke.

        A positive force rotates the wheel counter-clockwise. The force does not depend on the
        distance from the hub. However, a particle at the hub's position gets no force, because the
        direction would be undefined there.
        """
        raise NotImplementedError("Exercise 8.3b: Drive the rim")


def spin(hub: Particle, rim: Sequence[Particle]) -> float:
    """Measure how fast a wheel rotates about its hub, in rad/s.

    This angular velocity is the angular momentum of the rim divided by its moment of inertia. The
    angular momentum is the sum of m (x v_y - y v_x) over all particles of the rim. The moment of
    inertia is the sum of m (x^2 + y^2). The hub may itself move, so measure positions and
    velocities relative to the hub. Return 0 if the moment of inertia is zero.
    """
    raise NotImplementedError("Exercise 8.3b: Drive the rim")


def deformation(rods: Sequence[Rod]) -> float:
    """Measure how much a wheel is deformed: the largest relative error in the length of a rod.

    The relative error is the difference between the actual and the intended length, divided by the
    intended length. Return 0 if there are no rods. Mini-project 8.3c.
    """
    raise NotImplementedError("Exercise 8.3c: Does it deform?")


class Wheel:
    """A wheel of particles and rods that rotates about an immovable hub.

    ``world`` simulates the ``hub``, the particles of the ``rim`` and the ``rods``. A RimDrive with
    a ``force`` in N pushes each of the first ``driven`` particles of the rim.

    Raises:
        ValueError: if the force is not finite, or ``driven`` is not a whole number from 0 to
            ``COUNT``.
    """

    def __init__(self, force: float = 1.0, driven: int = COUNT) -> None:
        if not isinstance(driven, int) or driven not in range(COUNT + 1):
            raise ValueError(f"driven must be a whole number from 0 to {COUNT}, got {driven!r}")
        self.hub = Particle(mass=math.inf)
        angles = [math.tau * i / COUNT for i in range(COUNT)]
        self.rim = [
            Particle(Vector3(RADIUS * math.cos(angle), RADIUS * math.sin(angle)), mass=MASS)
            for angle in angles
        ]
        self.rods = rods_of(self.hub, self.rim)
        self.drive = RimDrive(self.hub, force)
        self.world = ParticleWorld([self.hub, *self.rim], self.rods, iterations=ITERATIONS)
        for particle in self.rim[:driven]:
            self.world.registry.add(particle, self.drive)

    def step(self, duration: float) -> None:
        """Move the wheel forward by one time step of ``duration`` s."""
        self.world.step(duration)
