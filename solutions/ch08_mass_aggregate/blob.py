"""A blob of particles, held together by bonds that can weaken, break and heal (book 8.2.3).

Lengths are in m. Constructors raise ValueError for a number that is out of range.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import ElasticLimitSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Cable, two_particles
from ch08_mass_aggregate.world import ParticleWorld

COUNT = 10  # particles, one of them in the middle
RADIUS = 0.5  # m, from the middle to the others
MASS = 0.1  # kg, of each particle
STIFFNESS = 30.0  # N/m, of a bond
LIMIT, BREAK = 1.2, 2.0  # of the length of a bond at rest
SHARE = 0.25  # of the stiffness that is left beyond LIMIT
DAMPING = 0.3
GRAVITY = Vector3(0.0, -9.81, 0.0)


class Bond:
    """A soft spring between two particles that has an elastic limit, can break, and can heal.

    Up to the length ``limit``, the bond is an ordinary spring with a ``stiffness`` in N/m. Beyond
    it, the stiffness is multiplied by the fraction ``share``, as in exercise 6.1. If the bond gets
    longer than ``break_length``, it breaks and exerts no force until it heals. It heals when the
    distance between its ends is ``rest_length`` or less. ``holds`` is False while it is broken.
    Register the bond for both particles: each call to ``update_force`` pulls on one end only.
    """

    def __init__(
        self,
        a: Particle,
        b: Particle,
        stiffness: float,
        rest_length: float,
        limit: float,
        share: float,
        break_length: float,
    ) -> None:
        self.a, self.b = two_particles(a, b)
        self._to_b = ElasticLimitSpring(b, stiffness, rest_length, limit, share)
        self._to_a = ElasticLimitSpring(a, stiffness, rest_length, limit, share)
        self.rest_length = rest_length
        self.break_length = positive("break_length", break_length)
        if not rest_length <= limit <= break_length:
            wanted = f"limit must be from rest_length ({rest_length!r}) to break_length "
            raise ValueError(f"{wanted}({break_length!r}), got {limit!r}")
        self.holds = True

    def update_force(self, particle: Particle, duration: float) -> None:
        """Break or heal the bond if necessary, and pull on ``particle`` if the bond is intact.

        The registry calls this method once for each end. Break or heal before you compute the
        force, so that both ends do so in the same step.
        """
        length = (self.b.position - self.a.position).magnitude()
        if self.holds:
            self.holds = length <= self.break_length
        else:
            self.holds = length <= self.rest_length
        if self.holds:
            spring = self._to_b if particle is self.a else self._to_a
            spring.update_force(particle, duration)


def spread(particles: Sequence[Particle]) -> float:
    """Measure the size of a blob in m.

    The result is the root mean square distance of the particles from their center of mass, weighted
    by mass. There is at least one particle, all of them can move, and none of them is changed.
    """
    total = math.fsum(positive("mass", particle.mass) for particle in particles)
    center = sum((particle.position * particle.mass for particle in particles), Vector3()) / total
    squares = [
        particle.mass * (particle.position - center).squared_magnitude() for particle in particles
    ]
    return math.sqrt(math.fsum(squares) / total)


class Blob:
    """A flat blob of ``particles`` that falls to the ground from ``height``.

    ``world`` simulates it. ``bonds`` join every pair of particles. If ``cables`` is True, a cable
    as long as the ``break_length`` of the bond also joins every pair, so that no bond breaks.
    ``push`` is a force in N that acts on each particle in every step. Set it to push the blob.
    """

    def __init__(self, height: float = 2.0, cables: bool = False) -> None:
        if finite("height", height) < RADIUS:
            raise ValueError(f"height must be {RADIUS:g} or more, got {height!r}")
        angles = [math.tau * i / (COUNT - 1) for i in range(COUNT - 1)]
        ring = [Vector3(math.cos(angle), math.sin(angle)) * RADIUS for angle in angles]
        middle = Vector3(0.0, height)
        self.particles = [
            Particle(middle + offset, acceleration=GRAVITY, mass=MASS, damping=DAMPING)
            for offset in [Vector3(), *ring]
        ]
        self.push = Vector3()
        self.world = ParticleWorld(self.particles, [GroundPlane(self.particles)])
        self.bonds = []
        for a, b in combinations(self.particles, 2):
            rest = (b.position - a.position).magnitude()
            bond = Bond(a, b, STIFFNESS, rest, LIMIT * rest, SHARE, BREAK * rest)
            self.bonds.append(bond)
            self.world.registry.add(a, bond)
            self.world.registry.add(b, bond)
            if cables:
                self.world.contact_generators.append(Cable(a, b, BREAK * rest))

    def step(self, duration: float) -> None:
        """Push every particle, and advance the blob by one time step of ``duration`` s.

        If the duration is invalid, nothing changes.
        """
        positive("duration", duration)
        self.world.start_frame()
        for particle in self.particles:
            particle.add_force(self.push)
        self.world.run_physics(duration)
