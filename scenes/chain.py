"""A straight chain of rods that hangs from the origin in the X-Y plane, released from rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Protocol

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.links import AnchoredRod, Rod
from scenes.readings import numbers
from scenes.setup import Setup


class Link(Protocol):
    """A class whose instances keep two particles at a given distance, such as TwoSidedRod."""

    def __call__(self, a: Particle, b: Particle, length: float, /) -> ContactGenerator: ...


@dataclass(frozen=True)
class Chain:
    """The scene with a particle at the lower end of each rod, listed from the top to the tip."""

    masses: Sequence[float]  # kg
    length: float  # m, of every rod
    angle: float = 0.0  # rad, at the start, from straight down
    gravity: float = 10.0  # m/s^2

    def particles(self) -> list[Particle]:
        """Create the particles at their initial positions."""
        along = Vector3(math.sin(self.angle), -math.cos(self.angle))
        down = Vector3(0.0, -self.gravity)
        return [
            Particle(along * (self.length * i), acceleration=down, mass=mass)
            for i, mass in enumerate(self.masses, 1)
        ]

    def setup(self, link: Link | None = None) -> Setup:
        """Create the particles and their rods, the first of which is an AnchoredRod.

        With ``link``, all are of that class, the first on an immovable particle that is not listed.
        """
        particles = self.particles()
        if link:
            ends = pairwise([Particle(mass=math.inf), *particles])
            return Setup(particles, contacts=[link(a, b, self.length) for a, b in ends])
        first = AnchoredRod(particles[0], Vector3(), self.length)
        rods = [Rod(a, b, self.length) for a, b in pairwise(particles)]
        return Setup(particles, contacts=[first, *rods])

    def excess(self, particles: Sequence[Particle]) -> list[float]:
        """Measure by how much each rod is too long, in m."""
        places = [(0.0, 0.0, 0.0), *(numbers(particle.position) for particle in particles)]
        return [math.dist(a, b) - self.length for a, b in pairwise(places)]

    def place(self, angles: Sequence[Any]) -> tuple[float, ...]:
        """Compute x and y of all particles, one after the other, from the angles of the rods."""
        parts, x, y = [], 0.0, 0.0
        for angle in angles:
            x += self.length * math.sin(angle)
            y -= self.length * math.cos(angle)
            parts += [x, y]
        return tuple(parts)
