"""A rope that hangs between two nails: by rods, by a chain solved at once, and by closed forms.

It is SPAN wide and LENGTH long, of links with a particle of 1 kg wherever two of them meet.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.direct_chain import DirectChain
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

SPAN, LENGTH = 2.0, 3.0  # m
DAMPING = 0.1  # so that it hangs still soon
GRAVITY = Vector3(0.0, -9.81, 0.0)


def catenary_sag(span: float = SPAN, length: float = LENGTH) -> float:
    """Return how low in m a rope of countless links hangs: a (cosh(span / 2a) - 1)."""
    a = _solve(lambda a: 2.0 * a * math.sinh(0.5 * span / a) - length, 0.05 * span, 100.0 * span)
    return a * (math.cosh(0.5 * span / a) - 1.0)


def polygon_sag(links: int, span: float = SPAN, length: float = LENGTH) -> float:
    """Return how low in m a rope of an even number of links hangs, with equal particles between.

    At rest the horizontal pull is the same in all links, and the vertical one changes by a weight
    from each link to the next: so the slopes of the links are evenly spaced.
    """
    link = length / links
    weights = [i + 0.5 for i in range(links // 2)]  # a link bears, from the middle to a nail

    def width(pull: float) -> float:
        return 2.0 * math.fsum(link * pull / math.hypot(pull, weight) for weight in weights)

    pull = _solve(lambda pull: width(pull) - span, 1e-6, 1e6)
    return math.fsum(link * weight / math.hypot(pull, weight) for weight in weights)


def _solve(of: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function that changes sign between two positive numbers does so."""
    rises = of(high) > 0.0
    for _ in range(200):
        middle = math.sqrt(low * high)
        if (of(middle) > 0.0) == rises:
            high = middle
        else:
            low = middle
    return math.sqrt(low * high)


def rope_particles(links: int) -> list[Particle]:
    """Return the particles of a rope, from nail to nail, on the straight V that it begins as."""
    depth = math.sqrt(0.25 * LENGTH * LENGTH - 0.25 * SPAN * SPAN)
    particles = []
    for i in range(links + 1):
        share = i / links
        place = Vector3(SPAN * share, -depth * (1.0 - abs(2.0 * share - 1.0)))
        mass = math.inf if i in (0, links) else 1.0
        particles.append(Particle(place, acceleration=GRAVITY, mass=mass, damping=DAMPING))
    return particles


@dataclass(frozen=True)
class Hanging:
    """A rope that hangs: how low in m, and by how much in m all of its links are too long."""

    sag: float
    stretch: float


def hang_by_rods(links: int, rate: int, substeps: int, seconds: float) -> Hanging:
    """Let a rope of two-sided rods hang in a ParticleWorld, with substeps in each frame."""
    particles = rope_particles(links)
    link = LENGTH / links
    world = ParticleWorld(particles, [TwoSidedRod(a, b, link) for a, b in pairwise(particles)])
    for _ in range(round(seconds * rate * substeps)):
        world.step(1.0 / (rate * substeps))
    return _measure(particles)


def hang_by_direct_chain(links: int, rate: int, seconds: float) -> Hanging:
    """Let the same rope hang by DirectChain."""
    particles = rope_particles(links)
    chain = DirectChain(particles[1:], particles[0].position)
    for _ in range(round(seconds * rate)):
        chain.step(1.0 / rate)
    return _measure(particles)


def _measure(particles: list[Particle]) -> Hanging:
    lengths = [(b.position - a.position).magnitude() for a, b in pairwise(particles)]
    return Hanging(-min(particle.position.y for particle in particles), sum(lengths) - LENGTH)
