"""Going further: a chain that solves for the tensions of all its rods at once.

A resolver corrects one rod after another, and each correction disturbs the neighboring rods. In a
long chain, a pull therefore needs many iterations to travel from link to link. This chain finds all
tensions together instead, so no rod is too long afterward.

The tension of a rod changes only three lengths: the length of this rod, and the lengths of its two
neighbors. Each equation for the tensions therefore has at most three unknowns. Such equations can
be solved from the anchor to the free end and back. For each rod, this takes about as much work as
resolving the rod once.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

TOO_FAR = "rod {} turns too far in one step; use shorter steps"
# What the way back needs of a rod: position, velocity and gain of the particle at its far end, the
# vector along it, its pull in the last step, and its equation: change = value + factor * next one.
Row = tuple[Vector3, Vector3, float, float, float, float, float, float, float]


class DirectChain:
    def __init__(self, particles: Sequence[Particle], anchor: Vector3) -> None:
        self.particles = [*particles]
        if not self.particles:
            raise ValueError("particles must have at least one particle, got none")
        self.anchor = finite_vector("anchor", anchor)
        self.lengths: list[float] = []
        places = [self.anchor, *(particle.position for particle in self.particles)]
        for i, (start, end) in enumerate(pairwise(places)):
            is_other_end = i and i == len(self.particles) - 1
            if not (self.particles[i].inverse_mass or is_other_end):
                raise ValueError(f"particles[{i}] must have a finite mass, got inf")
            self.lengths.append(positive(f"the length of rod {i}", (end - start).magnitude()))
        # N/m: the pull of each rod in the last step, per m of its length
        self._pulls: list[float] = []

    @property
    def tensions(self) -> list[float]:
        return [pull * length for pull, length in zip(self._pulls, self.lengths, strict=False)]

    def step(self, duration: float) -> None:
        positive("duration", duration)
        time = duration if self._pulls else 0.5 * duration  # for which the step accelerates
        self._pulls = self._pull_and_drift(self._kick_and_eliminate(duration, time), duration)

    def _kick_and_eliminate(self, duration: float, time: float) -> list[Row]:
        rows: list[Row] = []
        half = 0.5 / duration
        particle, following = self.particles[0], [*self.particles[1:], self.particles[-1]]
        pull, *next_pulls = self._pulls or [0.0] * len(self.particles)
        next_pulls.append(0.0)
        start, place = self.anchor, particle.position
        x, y, z = place.x - start.x, place.y - start.y, place.z - start.z  # along the rod
        force_x, force_y, force_z = x * pull, y * pull, z * pull
        # Of the rod before it, and of the particle between the two; first the anchor, at rest.
        last_x = last_y = last_z = last_u = last_v = last_w = last_gain = value = factor = 0.0
        for length, other, next_pull in zip(self.lengths, following, next_pulls, strict=True):
            particle.kick(time)
            gain = particle.inverse_mass * time  # m/s per N
            velocity, end = particle.velocity, other.position
            next_x = end.x - place.x
            next_y = end.y - place.y
            next_z = end.z - place.z
            next_force_x = next_x * next_pull
            next_force_y = next_y * next_pull
            next_force_z = next_z * next_pull
            if gain:
                u = velocity.x + (next_force_x - force_x) * gain
                v = velocity.y + (next_force_y - force_y) * gain
                w = velocity.z + (next_force_z - force_z) * gain
            else:
                u = v = w = 0.0  # immovable: it stays, whatever its velocity is
            to_x = x + (u - last_u) * duration  # along the rod at the end of the step
            to_y = y + (v - last_v) * duration
            to_z = z + (w - last_w) * duration
            below = last_gain * (to_x * last_x + to_y * last_y + to_z * last_z)
            pivot = (last_gain + gain) * (to_x * x + to_y * y + to_z * z) - below * factor
            if not pivot > 0.0:  # NaN too
                raise ArithmeticError(TOO_FAR.format(len(rows)))
            excess = to_x * to_x + to_y * to_y + to_z * to_z - length * length
            value = (excess * half + below * value) / pivot
            factor = gain * (to_x * next_x + to_y * next_y + to_z * next_z) / pivot
            rows.append((place, velocity, gain, x, y, z, pull, value, factor))
            particle, place, pull = other, end, next_pull
            last_gain = gain
            last_u, last_v, last_w = u, v, w
            last_x, last_y, last_z = x, y, z
            x, y, z = next_x, next_y, next_z
            force_x, force_y, force_z = next_force_x, next_force_y, next_force_z
        return rows

    def _pull_and_drift(self, rows: list[Row], duration: float) -> list[float]:
        pulls = []
        change = next_x = next_y = next_z = 0.0
        for place, velocity, gain, x, y, z, pull, value, factor in reversed(rows):
            change = value + factor * change
            pull += change
            pulls.append(pull)
            x *= pull  # from here on the force of the rod
            y *= pull
            z *= pull
            if gain:
                velocity.x = u = velocity.x + (next_x - x) * gain
                velocity.y = v = velocity.y + (next_y - y) * gain
                velocity.z = w = velocity.z + (next_z - z) * gain
                place.x += u * duration
                place.y += v * duration
                place.z += w * duration
            next_x, next_y, next_z = x, y, z
        pulls.reverse()
        return pulls
