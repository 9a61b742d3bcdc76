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

Numbers = tuple[float, float, float]


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
        for particle in particles:
            particle.kick(time)
        masses = [particle.inverse_mass for particle in particles]
        rods = self._rods()
        velocities = self._pulled(rods, masses, [pull * time for pull in pulls])

        # Row i says how the impulses of the rods i - 1, i and i + 1, for each m of their lengths,
        # change half the square of what rod i will be. Plain floats: vectors take twice the time.
        below, middle, above, excess = [], [], [], []
        before = last_x = last_y = last_z = last_u = last_v = last_w = 0.0
        following = [*rods[1:], (0.0, 0.0, 0.0)]
        for length, after, (rod_x, rod_y, rod_z), (u, v, w), (next_x, next_y, next_z) in zip(
            self.lengths, masses, rods, velocities, following, strict=True
        ):
            x = rod_x + (u - last_u) * duration
            y = rod_y + (v - last_v) * duration
            z = rod_z + (w - last_w) * duration
            below.append(-before * (x * last_x + y * last_y + z * last_z))
            middle.append((before + after) * (x * rod_x + y * rod_y + z * rod_z))
            above.append(-after * (x * next_x + y * next_y + z * next_z))
            excess.append((x * x + y * y + z * z - length * length) / (2.0 * duration))
            before, last_x, last_y, last_z = after, rod_x, rod_y, rod_z
            last_u, last_v, last_w = u, v, w
        changes = solve_tridiagonal(below, middle, above, excess)
        self._pulls = [pull + change / time for pull, change in zip(pulls, changes, strict=True)]
        self._pulled(rods, masses, changes)
        for particle in particles:
            particle.drift(duration)

    def _rods(self) -> list[Numbers]:
        """Return the vector along each rod, as numbers, from the anchor's end to the other."""
        rods = []
        last = self.anchor
        for particle in self.particles:
            place = particle.position
            rods.append((place.x - last.x, place.y - last.y, place.z - last.z))
            last = place
        return rods

    def _pulled(
        self, rods: list[Numbers], masses: list[float], impulses: list[float]
    ) -> list[Numbers]:
        """Pull at both ends of each rod, by an impulse in N s for each m of its length.

        ``masses`` are the inverse masses. Return the velocities afterwards.
        """
        velocities = []
        next_x = next_y = next_z = 0.0  # the impulse of the rod after this one, from the last on
        for i in range(len(rods) - 1, -1, -1):
            x, y, z = rods[i]
            impulse, inverse, velocity = impulses[i], masses[i], self.particles[i].velocity
            x *= impulse
            y *= impulse
            z *= impulse
            velocity.x = u = velocity.x + (next_x - x) * inverse
            velocity.y = v = velocity.y + (next_y - y) * inverse
            velocity.z = w = velocity.z + (next_z - z) * inverse
            velocities.append((u, v, w))
            next_x, next_y, next_z = x, y, z
        velocities.reverse()
        return velocities

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
    for b, m, a, r in zip((0.0, *below[1:]), middle, above, right, strict=True):
        pivot = m - b * factor
        if not pivot > 0.0:  # NaN too
            wanted = "shorter frames would help"
            raise ArithmeticError(f"rod {len(solved)} turns too far in one frame: {wanted}")
        value = (r - b * value) / pivot
        factor = a / pivot
        solved.append(value)
        factors.append(factor)
    for i in range(len(solved) - 2, -1, -1):
        solved[i] = value = solved[i] - factors[i] * value
    return solved
