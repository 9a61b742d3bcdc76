"""Going further: a chain whose rods are all put right at once, by one solve of linear equations.

The pull of each rod changes the lengths of three: its own, and those beside it. So the equations
for all pulls have three numbers a row, and are solved from one end to the other and back, with
about as much work for each rod as to resolve it once. Nothing has to be passed on from link to
link, and no rod is left too long.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class DirectChain:
    """A chain of rods from an anchor through particles, in their order, that makes their steps.

    Each rod keeps the length in m that it has when the chain is made. The last of several
    particles may be immovable: it holds the other end. ValueError where a rod has no length, or
    another particle is immovable.
    """

    def __init__(self, particles: Sequence[Particle], anchor: Vector3) -> None:
        self.particles = [*particles]
        self.anchor = finite_vector("anchor", anchor)
        self.lengths: list[float] = []
        for i, (start, end) in enumerate(pairwise(self._places())):
            is_other_end = i and i == len(self.particles) - 1
            if not (self.particles[i].inverse_mass or is_other_end):
                raise ValueError(f"particles[{i}] must be one that can move, got mass inf")
            self.lengths.append(positive(f"the length of rod {i}", (end - start).magnitude()))
        # N/m: what each rod pulled with in the last frame, for each m of its length
        self._pulls: list[float] = []

    @property
    def tensions(self) -> list[float]:
        """What each rod pulled with in the last frame, in N; negative where it pushed."""
        return [pull * length for pull, length in zip(self._pulls, self.lengths, strict=False)]

    def step(self, duration: float) -> None:
        """Move the chain on by a frame of a duration in s, with the forces in the accumulators.

        Velocities come first, as in semi-implicit Euler, with the impulses of the rods: each acts
        along where its rod is at the beginning of the frame, and makes it as long at the end as it
        should be. That is linear but for a small square, for which the last frame's pulls are a
        good guess; so one solve is enough. The first frame accelerates for half its time only. From
        then on velocities are those of the middle of the frame that is over, and the places are of
        order 2 (leapfrog), as long as all frames have the same duration.

        Raises ValueError where the duration is not positive and finite, and ArithmeticError where
        it is so long that a rod would turn round in it; the chain is then somewhere on its way.
        """
        positive("duration", duration)
        particles, count = self.particles, len(self.particles)
        first = not self._pulls
        pulls = self._pulls or [0.0] * count
        time = 0.5 * duration if first else duration  # for which the frame accelerates
        rods = [end - start for start, end in pairwise(self._places())]
        for particle in particles:
            x, y, z = particle.position
            particle.integrate(duration)
            place = particle.position
            place.x, place.y, place.z = x, y, z
            if first and particle.inverse_mass:
                particle.velocity.add_scaled(particle.last_acceleration, time - duration)
        self._pull(rods, [pull * time for pull in pulls])

        # Row i says how the impulses of the rods i - 1, i and i + 1, for each m of their lengths,
        # change half the square of what rod i will be.
        below, middle, above, excess = [], [], [], []
        inverse, still = 0.0, Vector3()
        for i, particle in enumerate(particles):
            start = particles[i - 1].velocity if i else still
            rod, length, v = rods[i], self.lengths[i], particle.velocity
            x = rod.x + (v.x - start.x) * duration
            y = rod.y + (v.y - start.y) * duration
            z = rod.z + (v.z - start.z) * duration
            before, after = inverse, particle.inverse_mass
            middle.append((before + after) * (x * rod.x + y * rod.y + z * rod.z))
            last = rods[i - 1]
            below.append(-before * (x * last.x + y * last.y + z * last.z))
            following = rods[(i + 1) % count]
            above.append(-after * (x * following.x + y * following.y + z * following.z))
            excess.append((x * x + y * y + z * z - length * length) / (2.0 * duration))
            inverse = after
        changes = solve_tridiagonal(below, middle, above, excess)
        self._pull(rods, changes)
        self._pulls = [pull + change / time for pull, change in zip(pulls, changes, strict=True)]
        for particle in particles:
            particle.position.add_scaled(particle.velocity, duration)

    def _pull(self, rods: list[Vector3], impulses: list[float]) -> None:
        """Pull at both ends of each rod, by an impulse in N s for each m of its length."""
        for i, (particle, rod, impulse) in enumerate(
            zip(self.particles, rods, impulses, strict=True)
        ):
            particle.velocity.add_scaled(rod, -impulse * particle.inverse_mass)
            if i:
                before = self.particles[i - 1]
                before.velocity.add_scaled(rod, impulse * before.inverse_mass)

    def _places(self) -> list[Vector3]:
        return [self.anchor, *(particle.position for particle in self.particles)]


def solve_tridiagonal(
    below: Sequence[float], middle: Sequence[float], above: Sequence[float], right: Sequence[float]
) -> list[float]:
    """Return x for below[i] x[i-1] + middle[i] x[i] + above[i] x[i+1] = right[i] (Thomas, 1949).

    below[0] and the last of above stand outside, and are not read. Raises ArithmeticError where
    what a row is divided by is not positive: it is for chains whose rods turn by less than a
    quarter.
    """
    factors: list[float] = []
    solved: list[float] = []
    factor, value = 0.0, 0.0
    for i, (b, m, a, r) in enumerate(zip(below, middle, above, right, strict=True)):
        pivot = m - b * factor if i else m
        if not pivot > 0.0:  # NaN too
            raise ArithmeticError(f"rod {i} turns too far in one frame: shorter frames would help")
        value = (r - b * value if i else r) / pivot
        factor = a / pivot
        solved.append(value)
        factors.append(factor)
    for i in range(len(solved) - 2, -1, -1):
        solved[i] -= factors[i] * solved[i + 1]
    return solved
