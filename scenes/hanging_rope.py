"""A rope that hangs between two nails at height 0, as particles of 1 kg between equal links."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from scenes.readings import numbers

SPAN, LENGTH = 2.0, 3.0  # m, between the nails and of the rope
DAMPING = 0.1  # strong, so that the rope soon comes to rest
GRAVITY = Vector3(0.0, -9.81, 0.0)

Place = tuple[float, float]


@dataclass(frozen=True)
class Hanging:
    """The final shape of a hanging rope, with its sag and its excess length in m."""

    places: list[Place]
    sag: float
    stretch: float
    work: int  # contacts resolved, or rod forces computed


def catenary(span: float = SPAN, length: float = LENGTH) -> Callable[[float], float]:
    """Return the height in m of a rope with infinitely many links, by the distance from a nail."""
    a = _solve(lambda a: 2.0 * a * math.sinh(0.5 * span / a) - length, 0.05 * span, 100.0 * span)
    return lambda x: a * (math.cosh((x - 0.5 * span) / a) - math.cosh(0.5 * span / a))


def polygon(links: int, span: float = SPAN, length: float = LENGTH) -> list[Place]:
    """Compute the exact positions of a rope's particles at rest.

    All links have the same horizontal pull. Their vertical pulls differ by a particle's weight.
    """
    link = length / links
    weights = [i + 0.5 - 0.5 * links for i in range(links)]  # upward pull of each link

    def width(pull: float) -> float:
        return math.fsum(link * pull / math.hypot(pull, weight) for weight in weights)

    pull = _solve(lambda pull: width(pull) - span, 1e-6, 1e6)
    places = [(0.0, 0.0)]
    for weight in weights:
        x, y = places[-1]
        share = link / math.hypot(pull, weight)
        places.append((x + share * pull, y + share * weight))
    return places


def polygon_sag(links: int, span: float = SPAN, length: float = LENGTH) -> float:
    """Compute the exact sag in m of a rope with ``links`` links."""
    return -min(y for _, y in polygon(links, span, length))


def hang_by_rods(
    links: int, substeps: int, seconds: float, resolver: ContactResolver | None = None
) -> Hanging:
    """Simulate a rope of TwoSidedRods from its exact shape, in ``substeps`` steps per frame."""
    particles = _particles(polygon(links))
    rods = [TwoSidedRod(a, b, LENGTH / links) for a, b in pairwise(particles)]
    world = ParticleWorld(particles, rods)
    world.resolver = resolver or world.resolver
    work = 0
    for _ in range(round(seconds * RATE) * substeps):
        world.step(1.0 / (RATE * substeps))
        work += world.resolver.iterations_used
    return _measured(particles, work)


def hang_by_direct_chain(links: int, rate: int, seconds: float, from_v: bool = False) -> Hanging:
    """Simulate a rope as a DirectChain, from its exact shape or from the shape of a V."""
    particles = _particles(_straight_v(links) if from_v else polygon(links))
    chain = DirectChain(particles[1:], particles[0].position)
    steps = round(seconds * rate)
    for _ in range(steps):
        chain.step(1.0 / rate)
    return _measured(particles, steps * links)


def _straight_v(links: int) -> list[Place]:
    """Compute the positions of a rope's particles when its middle is pulled straight down."""
    depth = math.sqrt(0.25 * LENGTH * LENGTH - 0.25 * SPAN * SPAN)
    shares = [i / links for i in range(links + 1)]
    return [(SPAN * share, -depth * (1.0 - abs(2.0 * share - 1.0))) for share in shares]


def _particles(places: list[Place]) -> list[Particle]:
    """Create the particles of a rope. The first and the last one cannot move."""
    particles = [Particle(Vector3(*place), None, GRAVITY, damping=DAMPING) for place in places]
    particles[0].mass = particles[-1].mass = math.inf
    return particles


def _measured(particles: list[Particle], work: int) -> Hanging:
    places = [numbers(particle.position)[:2] for particle in particles]
    total = math.fsum(math.dist(a, b) for a, b in pairwise(places))
    return Hanging(places, -min(y for _, y in places), total - LENGTH, work)


def _solve(of: Callable[[float], float], low: float, high: float) -> float:
    """Find by bisection where a function changes its sign between two positive numbers."""
    rises = of(high) > 0.0
    for _ in range(200):
        middle = math.sqrt(low * high)
        if (of(middle) > 0.0) == rises:
            high = middle
        else:
            low = middle
    return math.sqrt(low * high)
