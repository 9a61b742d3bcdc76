"""Going further: a chain that solves for the tensions of all its rods at once.

A resolver corrects one rod after another, and each correction disturbs the neighboring rods. In a
long chain, a pull therefore needs many iterations to travel from link to link. This chain finds all
tensions together instead, so no rod is too long afterward.

A rod r with the tension T pulls with the force k r at both ends, where k = T / |r| is its *pull* in
N/m. For ``time`` seconds, the particle at its far end feels this rod and the next one, so its
velocity changes by (k' r' - k r) ``time`` / m. If the pulls are those of the last step, rod r
becomes e, which is a little too long or too short. The changes c of the pulls must correct that:

    e . (change of e) = -(|e|^2 - length^2) / 2

The pull of a rod changes only three lengths: its own, and those of its two neighbors. Each equation
has at most three unknowns, so all of them can be solved by going once from the anchor to the free
end and back. For each rod, this takes about as much work as resolving the rod once.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class DirectChain:
    """A chain of rods that starts at ``anchor`` and joins ``particles`` in their order.

    The chain moves its particles itself, so call ``step`` instead of an integrator. Each rod keeps
    the length in m that it has when the chain is created. If there are several particles, the last
    one may be immovable, to hold the other end.

    Raises:
        ValueError: if there are no particles, if the length of a rod is 0, or if a particle other
            than the last is immovable.
    """

    def __init__(self, particles: Sequence[Particle], anchor: Vector3) -> None:
        self.particles = [*particles]
        if not self.particles:
            raise ValueError("particles must have at least one particle, got none")
        self.anchor = finite_vector("anchor", anchor)
        for i, particle in enumerate(self.particles):
            is_other_end = i and i == len(self.particles) - 1
            if not (particle.inverse_mass or is_other_end):
                raise ValueError(f"particles[{i}] must have a finite mass, got inf")
        self.lengths = [
            positive(f"the length of rod {i}", rod.magnitude())
            for i, rod in enumerate(self._rods())
        ]
        self._pulls: list[float] = []  # N/m, of the last step

    @property
    def tensions(self) -> list[float]:
        """The tension of each rod in the last step, in N. It is negative if the rod pushed."""
        return [pull * length for pull, length in zip(self._pulls, self.lengths, strict=False)]

    def step(self, duration: float) -> None:
        """Move the chain by one step of ``duration`` s under the forces in the accumulators.

        Velocities change before positions, as in semi-implicit Euler. The first step accelerates
        for only half of its duration. From then on the velocities belong to the middle of the
        previous step, as in leapfrog. This gives the positions order 2, as long as all steps have
        the same duration. The equations leave out the square of a change, which is small, because
        the pulls of the last step are a good estimate.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
            ArithmeticError: if a rod would rotate too far in the step. The chain is then in the
                middle of the step, and cannot be used any more.
        """
        positive("duration", duration)
        time = duration if self._pulls else 0.5 * duration
        pulls = self._pulls or [0.0] * len(self.particles)
        rods = self._rods()
        for particle in self.particles:
            particle.kick(time)
        guess = pairwise([Vector3(), *self._velocities(rods, pulls, time)])
        ends = [rod + (v - u) * duration for rod, (u, v) in zip(rods, guess, strict=True)]
        changes = self._changes(rods, ends, time, duration)
        self._pulls = [pull + change for pull, change in zip(pulls, changes, strict=True)]
        velocities = self._velocities(rods, self._pulls, time)
        for particle, velocity in zip(self.particles, velocities, strict=True):
            if particle.inverse_mass:
                particle.velocity = velocity
                particle.drift(duration)

    def _rods(self) -> list[Vector3]:
        """Return the vector along each rod, from its near end to its far end."""
        positions = [self.anchor, *(particle.position for particle in self.particles)]
        return [far - near for near, far in pairwise(positions)]

    def _velocities(self, rods: list[Vector3], pulls: list[float], time: float) -> list[Vector3]:
        """Return the velocity of each particle after the rods have pulled for ``time`` s."""
        forces = [rod * pull for rod, pull in zip(rods, pulls, strict=True)]
        return [
            particle.velocity + (after - before) * (particle.inverse_mass * time)
            if particle.inverse_mass
            else Vector3()
            for particle, before, after in zip(
                self.particles, forces, [*forces[1:], Vector3()], strict=True
            )
        ]

    def _changes(
        self, rods: list[Vector3], ends: list[Vector3], time: float, duration: float
    ) -> list[float]:
        """Return the change of each pull that gives every rod its length at the end of the step.

        With the change c of this rod, c- of the rod before it and c+ of the next one, and with
        ``time`` / m = g- at its near end and g at its far end, the equation of a rod is

            (g- + g) (e . r) c = (|e|^2 - length^2) / (2 duration) + g- (e . r-) c- + g (e . r+) c+
        """
        gains = [particle.inverse_mass * time for particle in self.particles]
        wrong = [
            (end.squared_magnitude() - length**2) / (2.0 * duration)
            for end, length in zip(ends, self.lengths, strict=True)
        ]
        own = [
            (near + far) * end.dot(rod)
            for near, far, end, rod in zip([0.0, *gains[:-1]], gains, ends, rods, strict=True)
        ]
        before = [g * e.dot(r) for g, e, r in zip(gains, ends[1:], rods, strict=False)]
        after = [g * e.dot(r) for g, e, r in zip(gains, ends, rods[1:], strict=False)]
        return solve(own, [0.0, *before], [*after, 0.0], wrong)


def solve(
    own: list[float], before: list[float], after: list[float], right: list[float]
) -> list[float]:
    """Solve own[i] c[i] = right[i] + before[i] c[i - 1] + after[i] c[i + 1] (Thomas, 1949).

    On the way out, c[i - 1] is eliminated from equation i, which leaves c[i] = value + factor *
    c[i + 1]. On the way back, c[i + 1] is known.
    """
    rows: list[tuple[float, float]] = []
    value = factor = 0.0
    for i in range(len(own)):
        pivot = own[i] - before[i] * factor
        if not pivot > 0.0:  # NaN too
            raise ArithmeticError(f"rod {i} turns too far in one step; use shorter steps")
        value, factor = (right[i] + before[i] * value) / pivot, after[i] / pivot
        rows.append((value, factor))
    found = [0.0]
    for value, factor in reversed(rows):
        found.append(value + factor * found[-1])
    return found[:0:-1]
