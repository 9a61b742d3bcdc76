"""Forces and contacts for sleeping worlds; the autograder runs it beside the student."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch08_mass_aggregate.sleeping import SleepingWorld


class Push:
    """A force per kg that can be changed; it counts how often it was asked."""

    def __init__(self, x: float = 0.0) -> None:
        self.x, self.y = x, 0.0
        self.asked = 0
        self.durations: list[float] = []

    def update_force(self, particle: Particle, duration: float) -> None:
        self.asked += 1
        self.durations.append(duration)
        particle.add_force(Vector3(self.x * particle.mass, self.y * particle.mass))


class Touch:
    """A generator of contacts of depth 0 between pairs of numbered particles; -1 is a wall."""

    def __init__(self, particles: Sequence[Particle], pairs: Sequence[tuple[int, int]]) -> None:
        self.particles, self.pairs = particles, pairs

    def contacts(self) -> list[Contact]:
        right = Vector3(1.0)
        one = [*self.particles, None]
        return [Contact(self.particles[i], one[j], right) for i, j in self.pairs]


class Wall:
    """A wall that keeps a particle at x of 0 or less."""

    def __init__(self, particle: Particle) -> None:
        self.particle = particle

    def contacts(self) -> list[Contact]:
        x = self.particle.position.x
        if x < 0.0 or not self.particle.inverse_mass:
            return []
        return [Contact(self.particle, None, Vector3(-1.0), 0.0, x)]


def asleep(world: SleepingWorld, particles: Sequence[Particle]) -> list[int]:
    """Return the numbers of those that sleep."""
    return [i for i, particle in enumerate(particles) if particle in world.asleep]


def stepped(world: SleepingWorld, particles: Sequence[Particle], steps: int) -> list[list[int]]:
    """Return the numbers of the particles that sleep after each of some steps of 1/60 s."""
    seen = []
    for _ in range(steps):
        world.step(1.0 / 60.0)
        seen.append(asleep(world, particles))
    return seen
