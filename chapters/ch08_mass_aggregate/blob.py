"""A blob of particles, held together by bonds that can weaken, break and heal (book 8.2.3).

A bond is a soft spring between two particles. It breaks when it is stretched too far, and heals
when its ends come close again. A blob can therefore split in two and merge later.
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
    this length, stretching it further adds less force: the stiffness is multiplied by the fraction
    ``share``, as in exercise 6.1. If the bond gets longer than ``break_length``, it breaks and
    exerts no force until it heals. It heals when the distance between its ends is ``rest_length``
    or less. ``holds`` is False while the bond is broken.

    All lengths are in m. Register the bond for both particles, because each call to
    ``update_force`` pulls on one end only.

    Raises:
        ValueError: if rest_length <= limit <= break_length does not hold, or ElasticLimitSpring
            rejects an argument.
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

        The registry calls this method once for each end. Check the length before you compute the
        force, so that the bond breaks or heals for both ends in the same step.
        """
        raise NotImplementedError("Exercise B8.8: Bonds that break and heal")


def spread(particles: Sequence[Particle]) -> float:
    """Measure the size of a blob in m, for example while it falls and spreads.

    The result is the root mean square distance of the particles from their center of mass. Each
    particle is weighted by its mass. You may assume that there is at least one particle, and that
    all of them can move. Don't change them.
    """
    raise NotImplementedError("Exercise B8.9: The spread of a blob")


class Blob:
    """A blob of particles, joined by bonds, that falls to the ground.

    ``world`` simulates the blob, which consists of ``particles`` and ``bonds``. The blob is flat,
    so all particles start at z = 0. Its center starts ``height`` m above the ground. A bond joins
    every pair of particles. If ``cables`` is True, a cable also joins every pair and keeps the bond
    from breaking. The length of the cable is the ``break_length`` of the bond.

    ``push`` is a force in N that acts on each particle in every step. Set it to push the blob.

    Raises:
        ValueError: if the height is not finite, or is less than ``RADIUS``. The blob would then
            start inside the ground.
    """

    def __init__(self, height: float = 2.0, cables: bool = False) -> None:
        if finite("height", height) < RADIUS:
            raise ValueError(f"height must be {RADIUS:g} or more, got {height!r}")
        middle = Vector3(0.0, height)
        places = [middle]
        for i in range(COUNT - 1):
            angle = math.tau * i / (COUNT - 1)
            places.append(middle + Vector3(math.cos(angle), math.sin(angle)) * RADIUS)
        self.particles = [
            Particle(place, acceleration=GRAVITY, mass=MASS, damping=DAMPING) for place in places
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
        """Apply the force ``push`` to every particle, and advance the blob by one time step.

        ``duration`` is in s. A push that is not finite is rejected by ``add_force``.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
            TypeError: if the duration is not a number. In that case nothing changes.
        """
        positive("duration", duration)
        self.world.start_frame()
        for particle in self.particles:
            particle.add_force(self.push)
        self.world.run_physics(duration)
