"""A wheel of rods about an immovable hub, driven at its rim (mini-project 8.3).

It turns in the X-Y plane, counter-clockwise where its spin is positive.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Rod, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 8  # particles of the rim
RADIUS = 1.0  # m
MASS = 1.0  # kg, of each of them
ITERATIONS = 200  # a phase


def rods_of(hub: Particle, rim: Sequence[Particle]) -> list[Rod]:
    """Return the rods of a wheel: a spoke to each particle of the rim, and from each to the next.

    The rim, of three or more, is given in order, and its last particle is joined to the first. Each
    rod is as long as its ends are apart now (8.3a).
    """
    ends = [(hub, particle) for particle in rim]
    ends += [(particle, rim[(i + 1) % len(rim)]) for i, particle in enumerate(rim)]
    return [TwoSidedRod(a, b, (b.position - a.position).magnitude()) for a, b in ends]


class RimDrive:
    """A force generator that drives a rim: a force of one size in N, round the hub (8.3b)."""

    def __init__(self, hub: Particle, force: float) -> None:
        self.hub = hub
        self.force = finite("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force in N, at a right angle to the spoke, in the X-Y plane.

        A positive force is one that turns the wheel counter-clockwise. At the hub there is none.
        """
        spoke = particle.position - self.hub.position
        length = math.hypot(spoke.x, spoke.y)
        if length > 0.0:
            share = self.force / length
            particle.add_force(Vector3(-spoke.y * share, spoke.x * share, 0.0))


def spin(hub: Particle, rim: Sequence[Particle]) -> float:
    """Return how fast a wheel turns about its hub, in rad/s: angular momentum by moment of inertia.

    That is the sum of m (x v_y - y v_x), divided by that of m (x^2 + y^2), with places and
    velocities as they are seen from the hub, should that move. 0 where the rim has no moment of
    inertia.
    """
    turning, inertia = 0.0, 0.0
    for particle in rim:
        place = particle.position - hub.position
        velocity = particle.velocity - hub.velocity
        turning += particle.mass * (place.x * velocity.y - place.y * velocity.x)
        inertia += particle.mass * (place.x * place.x + place.y * place.y)
    return turning / inertia if inertia else 0.0


def deformation(rods: Sequence[Rod]) -> float:
    """Return by which share of its length the worst of some rods is too long or too short (8.3c).

    0 where there are none.
    """
    return max(
        (abs((rod.b.position - rod.a.position).magnitude() / rod.length - 1.0) for rod in rods),
        default=0.0,
    )


class Wheel:
    """A wheel: its ``hub``, ``rim``, ``rods`` and ``world``.

    The first ``driven`` particles of the rim are driven by a ``drive`` of a ``force`` in N each.
    ValueError where the force is not finite, or driven not from 0 to COUNT.
    """

    def __init__(self, force: float = 1.0, driven: int = COUNT) -> None:
        if driven not in range(COUNT + 1):
            raise ValueError(f"driven must be from 0 to {COUNT}, got {driven!r}")
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
        """Let a frame of a duration in s pass."""
        self.world.step(duration)
