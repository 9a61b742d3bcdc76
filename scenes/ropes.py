"""Simulate a rope that hangs between two nails, and compute its exact shape.

The rope has the length LENGTH, and is simulated as a chain of rods or as a DirectChain. Neighboring
links are connected by particles of 1 kg. Both nails are at height 0, and the distance between them
is SPAN.
"""

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
from scenes.readings import numbers

SPAN, LENGTH = 2.0, 3.0  # m
DAMPING = 0.1  # strong, so that the rope soon comes to rest
GRAVITY = Vector3(0.0, -9.81, 0.0)

Place = tuple[float, float]


@dataclass(frozen=True)
class Hanging:
    """The final shape of a hanging rope, with its sag and its excess length in m.

    ``work`` is the number of contacts that were resolved in the simulation. For a DirectChain, it
    is the number of rod forces that were computed.
    """

    places: list[Place]
    sag: float
    stretch: float
    work: int


def catenary_sag(span: float = SPAN, length: float = LENGTH) -> float:
    """Compute the exact sag in m of a rope with infinitely many links, which forms a catenary."""
    a = catenary_radius(span, length)
    return a * (math.cosh(0.5 * span / a) - 1.0)


def catenary_radius(span: float = SPAN, length: float = LENGTH) -> float:
    """Compute the parameter a, in m, of the catenary y = a cosh(x / a) that a rope forms."""
    return _solve(lambda a: 2.0 * a * math.sinh(0.5 * span / a) - length, 0.05 * span, 100.0 * span)


def polygon(links: int, span: float = SPAN, length: float = LENGTH) -> list[Place]:
    """Compute the exact positions of the particles of a rope that hangs at rest.

    All links have the same length. At rest, the horizontal pull is the same in every link. The
    vertical pull changes by the weight of one particle from link to link, so the slopes are evenly
    spaced.
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
    """Compute the exact sag in m of a rope that hangs at rest and has ``links`` links."""
    return -min(y for _, y in polygon(links, span, length))


def straight_v(links: int) -> list[Place]:
    """Compute the positions of a rope's particles when its middle is pulled straight down.

    The rope then has the shape of a V. A simulation can start from this shape to test whether the
    rope comes to rest in its exact shape.
    """
    depth = math.sqrt(0.25 * LENGTH * LENGTH - 0.25 * SPAN * SPAN)
    shares = [i / links for i in range(links + 1)]
    return [(SPAN * share, -depth * (1.0 - abs(2.0 * share - 1.0))) for share in shares]


def rope_particles(places: list[Place]) -> list[Particle]:
    """Create the particles of a rope at the given positions. The first and the last cannot move."""
    particles = [
        Particle(Vector3(x, y), acceleration=GRAVITY, mass=1.0, damping=DAMPING) for x, y in places
    ]
    particles[0].mass = particles[-1].mass = math.inf
    return particles


def hang_by_rods(
    links: int, rate: int, substeps: int, seconds: float, resolver: ContactResolver | None = None
) -> Hanging:
    """Simulate a hanging rope with a TwoSidedRod for each link, and measure its sag.

    The rope starts in its exact shape at rest, so it should not sag any further. There are ``rate``
    time steps per second, each divided into ``substeps``. If ``resolver`` is None, the world's own
    ContactResolver resolves the contacts.
    """
    particles = rope_particles(polygon(links))
    rods = [TwoSidedRod(a, b, LENGTH / links) for a, b in pairwise(particles)]
    world = ParticleWorld(particles, rods)
    world.resolver = resolver or world.resolver
    work = 0
    for _ in range(round(seconds * rate) * substeps):
        world.step(1.0 / (rate * substeps))
        work += world.resolver.iterations_used
    return _measured(particles, work)


def hang_by_direct_chain(links: int, rate: int, seconds: float, from_v: bool = False) -> Hanging:
    """Simulate a hanging rope with a DirectChain, which keeps the length of every link.

    If ``from_v`` is true, the rope starts in the shape of a V. Otherwise it starts in its exact
    shape at rest.
    """
    particles = rope_particles(straight_v(links) if from_v else polygon(links))
    chain = DirectChain(particles[1:], particles[0].position)
    frames = round(seconds * rate)
    for _ in range(frames):
        chain.step(1.0 / rate)
    return _measured(particles, frames * links)


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
