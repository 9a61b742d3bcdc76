"""Measure how long it takes to find contacts, resolve them, and simulate a chain of rods."""

from __future__ import annotations

import math
import random
import timeit
from collections.abc import Callable
from itertools import pairwise
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import ParticlePairs
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Cable
from scenes.chain import Chain
from scenes.clock import FRAME
from scenes.resolving import no_forces
from scenes.spheres import GRAVITY
from scenes.timing import Measurement, Target, Timer, timer, versus
from scenes.twin import twin_of
from studies.models.direct_net import DirectNet
from studies.models.heap_resolver import HeapResolver

LINKS, LINK = 30, 0.1  # rods, and the length of each in m
CHAIN = Chain([1.0] * LINKS, LINK, math.radians(30.0))
RATE = 240  # Hz, at which DirectChain keeps every rod to 1e-6 of its length


def lines() -> list[Measurement]:
    """Set up the benchmarks for finding and resolving contacts, and for chains of rods."""
    many, few = spread(1000), spread(100)
    rate = matching_rate()
    direct_chain = timer(lambda: by_direct_chain(RATE))
    return [
        *(
            Measurement(
                f"{count} contacts of a rope: scanning all / with a heap",
                versus(resolving(ContactResolver, count), resolving(HeapResolver, count)),
                11,
                Target("at least", least),
            )
            for count, least in ((100, 4), (300, 11))
        ),
        Measurement(
            "300 contacts of a rope / 30 contacts, both with a heap",
            versus(resolving(HeapResolver, 300), resolving(HeapResolver, 30)),
            31,
            Target("at most", 14),
        ),
        Measurement(
            "finding the touching pairs among 1,000 spread spheres / among 100",
            versus(timer(many.contacts), timer(few.contacts)),
            41,
            Target("at most", 15),
        ),
        Measurement(
            f"{LINKS} rods: pymunk's pin joints at {rate:,} Hz / DirectChain at {RATE} Hz, "
            "with the same error at the tip",
            versus(timer(lambda: by_pymunk(rate)), direct_chain),
            7,
            Target("at least", 2.5),
        ),
        Measurement(
            f"{LINKS} rods: DirectNet / DirectChain at {RATE} Hz, with the same error at the tip",
            versus(timer(lambda: by_direct_net(RATE)), direct_chain),
            7,
            Target("at least", 2.5),
        ),
    ]


def resolving(kind: type[ContactResolver], count: int) -> Timer:
    """Return a function that times a resolver, in s, on a rope of ``count`` stretched cables."""

    def once() -> float:
        down = Vector3(0.0, -GRAVITY)
        rope = [Particle(Vector3(1.02 * LINK * i), acceleration=down) for i in range(count + 1)]
        rope[0].mass = math.inf
        semi_implicit_euler(rope, no_forces, FRAME)
        links = [Cable(a, b, LINK) for a, b in pairwise(rope)]
        contacts = [contact for link in links for contact in link.contacts()]
        resolver = kind()
        return timeit.timeit(lambda: resolver.resolve_contacts(contacts, FRAME), number=1)

    return once


def spread(count: int) -> ParticlePairs:
    """Return the detector of ``count`` spheres in a cube, with one per 8 m^3 on average."""
    rng = random.Random(1)
    size = 2.0 * count ** (1.0 / 3.0)
    places = [[rng.uniform(0.0, size) for _ in range(3)] for _ in range(count)]
    return ParticlePairs([Particle(Vector3(*place)) for place in places], 0.5)


def tip(body: Any, step: Callable[[float], object], rate: int) -> tuple[float, float]:
    """Simulate a chain for 1 s with ``rate`` steps per second, and return x and y of a body."""
    for _ in range(rate):
        step(1.0 / rate)
    return body.position.x, body.position.y


def by_direct_chain(rate: int) -> tuple[float, float]:
    """Return where DirectChain puts the tip of the swinging chain."""
    particles = CHAIN.particles()
    return tip(particles[-1], DirectChain(particles, Vector3()).step, rate)


def by_direct_net(rate: int) -> tuple[float, float]:
    """Return where DirectNet puts the tip."""
    setup = CHAIN.setup()
    return tip(setup.particles[-1], DirectNet(setup.contacts).step, rate)


def by_pymunk(rate: int) -> tuple[float, float]:
    """Return where pymunk puts the tip, with pin joints as the rods and 10 iterations per step."""
    space, bodies = twin_of(CHAIN.setup())
    return tip(bodies[-1], space.step, rate)


def matching_rate() -> int:
    """Find how many steps per second pymunk needs to be as accurate as DirectChain at the tip."""
    true = by_direct_chain(16 * RATE)  # with an error 256 times smaller than at RATE
    ours = math.dist(by_direct_chain(RATE), true)
    rate = 4 * RATE
    while rate < 100_000 and math.dist(by_pymunk(rate), true) > ours:
        rate *= 2
    return rate
