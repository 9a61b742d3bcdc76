"""The resolver of studies/, which finds the worst contact with a heap, against chapter 7's scan."""

from __future__ import annotations

import math
import random
from itertools import pairwise
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import AnchoredRod, Cable, Rod, TwoSidedRod
from studies.models.heap_resolver import HeapResolver

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0, 0.0)
RESOLVERS = [ContactResolver, HeapResolver]


def tangle(draw: random.Random, particles: int, count: int) -> tuple[list[Particle], list[Contact]]:
    """Return particles, some of them immovable, and contacts, some of them with the world."""

    def vector(size: float) -> Vector3:
        return Vector3(*(draw.uniform(-size, size) for _ in range(3)))

    bodies = [
        Particle(vector(2.0), vector(3.0), vector(10.0), mass=draw.uniform(0.2, 5.0))
        for _ in range(particles)
    ]
    for body in bodies[::7]:
        body.mass = math.inf
    contacts = []
    for i in range(count):
        a, b = draw.sample(bodies, 2)
        if i % 9 == 8:
            a, b = contacts[-1].particle, contacts[-1].other or b
        c, depth = draw.choice([0.0, 0.5, 1.0, draw.random()]), draw.uniform(-0.1, 0.2)
        other = None if i % 5 == 4 or a is b else b
        contacts.append(Contact(a, other, vector(1.0).normalized(), c, depth))
    return bodies, contacts


def rope(draw: random.Random, links: int) -> tuple[list[Particle], list[Contact]]:
    """Return a rope of rods and cables in motion with a heavy end."""
    bodies = [
        Particle(
            Vector3(0.3 * i, draw.uniform(-0.05, 0.05), 0.0),
            Vector3(draw.uniform(-1.0, 1.0), draw.uniform(-2.0, 1.0), 0.0),
            UP * -9.81,
        )
        for i in range(links + 1)
    ]
    bodies[-1].mass = 50.0
    kinds = [lambda a, b: Cable(a, b, 0.3, 0.2), lambda a, b: Rod(a, b, 0.3)]
    kinds += [lambda a, b: TwoSidedRod(a, b, 0.3)]
    held: list[Any] = [AnchoredRod(bodies[0], Vector3(-0.3), 0.3)]
    held += [draw.choice(kinds)(a, b) for a, b in pairwise(bodies)]
    return bodies, [contact for link in held for contact in link.contacts()]


def pile(draw: random.Random, balls: int) -> tuple[list[Particle], list[Contact]]:
    """Return equal balls in a grid that overlap slightly, so that there are many ties."""
    bodies = [
        Particle(Vector3(0.96 * (i % 6), 0.48 + 0.96 * (i // 6)), UP * -1.0, UP * -9.81)
        for i in range(balls)
    ]
    bodies[draw.randrange(balls)].mass = math.inf
    pairs, ground = ParticlePairs(bodies, 0.5, 0.4), GroundPlane(bodies, 0.0, 0.5, 0.4)
    return bodies, ground.contacts() + pairs.contacts()


SCENES = [
    *[(tangle, size, seed) for seed, size in enumerate((10, 10, 30, 60, 100, 200, 300))],
    *[(rope, size, seed) for seed, size in enumerate((10, 10, 20, 50, 100, 200))],
    *[(pile, size, seed) for seed, size in enumerate((6, 12, 24, 60, 120))],
]


@pytest.mark.parametrize("limit", [None, 10, 400])
@pytest.mark.parametrize(("make", "size", "seed"), SCENES)
def test_the_heap_ends_where_the_scan_does(make: Any, size: int, seed: int, limit: Any) -> None:
    ends = []
    for kind in RESOLVERS:
        draw = random.Random(f"{make.__name__} {seed}")
        bodies, contacts = tangle(draw, size // 3, size) if make is tangle else make(draw, size)
        resolver = kind(limit)
        resolver.resolve_contacts(contacts, FRAME)
        numbers = [x for body in bodies for x in (*body.position, *body.velocity)]
        ends.append((numbers + [contact.penetration for contact in contacts], resolver))
    (scanned, scan), (heaped, heap) = ends
    assert scan.iterations_used == heap.iterations_used > 5
    # At most 600 impulses of some 10 m/s in the same order, each with some roundings.
    assert heaped == pytest.approx(scanned, abs=1e-9)
