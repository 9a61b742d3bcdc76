"""Draw random worlds, to test laws of physics that must hold in every world.

As a script, print the final positions in some, so that versions of Python can be compared.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from random import Random

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import connect
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import Cable, Rod
from ch08_mass_aggregate.world import ParticleWorld

STEP = 1.0 / 60.0  # s
MOST = 50  # particles
RADIUS = 0.3  # m
Triple = tuple[float, float, float]


@dataclass(frozen=True)
class Plan:
    """The numbers that describe a world. Springs and links refer to their ends by index."""

    masses: list[float]
    places: list[Triple]
    velocities: list[Triple]
    restitution: float
    gravity: Triple = (0.0, 0.0, 0.0)
    springs: list[tuple[int, int, float, float]] = field(default_factory=list)  # stiffness, length
    links: list[tuple[str, int, int, float]] = field(default_factory=list)  # kind, ends, length
    ground: bool = False
    collide: bool = False

    def moved(self, way: Callable[[Triple], Triple]) -> Plan:
        """Return the plan with all of its vectors mirrored or rotated by ``way``."""
        return replace(
            self,
            places=[*map(way, self.places)],
            velocities=[*map(way, self.velocities)],
            gravity=way(self.gravity),
        )

    def build(self, integrator: Callable[..., None] = semi_implicit_euler) -> ParticleWorld:
        down = Vector3(*self.gravity)
        particles = [
            Particle(Vector3(*place), Vector3(*velocity), down, mass=mass)
            for mass, place, velocity in zip(self.masses, self.places, self.velocities, strict=True)
        ]
        kinds = {"rod": Rod, "cable": Cable}
        generators = [kinds[kind](particles[i], particles[j], n) for kind, i, j, n in self.links]
        if self.collide:
            generators.append(ParticlePairs(particles, RADIUS, self.restitution))
        if self.ground:
            generators.append(GroundPlane(particles, -2.0, RADIUS, self.restitution))
        world = ParticleWorld(particles, generators, integrator=integrator)
        for i, j, stiffness, length in self.springs:
            connect(world.registry, particles[i], particles[j], stiffness, length)
        return world


def draw(seed: int, *, springs: bool = False, contacts: bool = False, falls: bool = False) -> Plan:
    """Draw a plan with 2 to MOST particles. If ``falls`` is true, it has gravity and a ground."""
    rng = Random(f"a world {seed}")
    count = round(2.0 * (MOST / 2.0) ** rng.random())
    size = 0.6 * count ** (1.0 / 3.0)  # m, so dense that some spheres touch

    def vector(most: float) -> Triple:
        return (rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most))

    places = [vector(size) for _ in range(count)]
    some = [rng.sample(range(count), 2) for _ in range(count)]
    kinds = [rng.choice(("rod", "cable")) for _ in some]
    lengths = [rng.uniform(0.8, 1.2) * _apart(places[i], places[j]) for i, j in some]
    plan = Plan(
        [10.0 ** rng.uniform(-1.0, 1.0) for _ in range(count)],
        places,
        [vector(3.0) for _ in range(count)],
        rng.random(),
        (0.0, -9.81 if falls else 0.0, 0.0),
        ground=falls,
        collide=contacts,
    )
    ends = [(i, j, length) for (i, j), length in zip(some, lengths, strict=True)]
    if springs:
        plan.springs.extend((i, j, rng.uniform(1.0, 30.0), length) for i, j, length in ends)
    if contacts:
        links = [(kind, *end) for kind, end in zip(kinds, ends, strict=True)]
        plan.links.extend(links[::2])
    return plan


def _apart(a: Triple, b: Triple) -> float:
    return (Vector3(*a) - Vector3(*b)).magnitude()


def triple(vector: Vector3) -> Triple:
    return vector.x, vector.y, vector.z


def places_after(world: ParticleWorld, steps: int) -> list[Triple]:
    """Run a world for a number of steps, and return the positions of its particles."""
    for _ in range(steps):
        world.step(STEP)
    return [triple(particle.position) for particle in world.particles]


def some_ends(count: int) -> list[list[Triple]]:
    """Return the positions after 10 steps in some worlds that contain everything."""
    plans = (draw(seed, springs=True, contacts=True, falls=True) for seed in range(count))
    return [places_after(plan.build(), 10) for plan in plans]


if __name__ == "__main__":
    print(repr(some_ends(int(sys.argv[1]))))
