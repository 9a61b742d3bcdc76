"""The resolver's order against exact fractions and geometry, and the heap against the scan."""

from __future__ import annotations

import copy
import math
import random
from collections.abc import Sequence
from fractions import Fraction
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


# The order


def on_a_line(
    masses: Sequence[int], speeds: Sequence[int], c: Fraction, limit: int, *, worst: bool
) -> list[Fraction]:
    """Return the speeds of touching balls in a row, resolved worst first or first in the list."""
    v = [Fraction(speed) for speed in speeds]
    for _ in range(limit):
        closing = [(right - left, i) for i, (left, right) in enumerate(pairwise(v))]
        found = [(speed, i) for speed, i in closing if speed < 0]
        if not found:
            break
        speed, i = min(found) if worst else found[0]
        impulse = -(1 + c) * speed / (Fraction(1, masses[i]) + Fraction(1, masses[i + 1]))
        v[i] -= impulse / masses[i]
        v[i + 1] += impulse / masses[i + 1]
    return v


def row(
    masses: Sequence[float], speeds: Sequence[float], c: float
) -> tuple[list[Particle], list[Contact]]:
    balls = [
        Particle(Vector3(i), Vector3(speed), mass=m)
        for i, (m, speed) in enumerate(zip(masses, speeds, strict=True))
    ]
    return balls, [Contact(a, b, Vector3(-1.0), c) for a, b in pairwise(balls)]


@pytest.mark.parametrize("kind", RESOLVERS)
def test_the_contact_that_closes_fastest_is_first_and_another_order_ends_elsewhere(
    kind: type[ContactResolver],
) -> None:
    draw, differ = random.Random(7), 0
    for _ in range(200):
        n = draw.randint(3, 8)
        masses = [draw.randint(1, 9) for _ in range(n)]
        speeds = [draw.randint(-20, 20) for _ in range(n)]
        half, limit = draw.randint(0, 2), draw.randint(1, 2 * n)
        c = Fraction(half, 2)
        balls, contacts = row(masses, speeds, half / 2)
        kind(limit).resolve_contacts(contacts, FRAME)
        wanted = on_a_line(masses, speeds, c, limit, worst=True)
        # At most 16 impulses, each with some roundings of 40 m/s. Closer ties are not generated.
        got = [ball.velocity.x for ball in balls]
        assert got == pytest.approx([float(v) for v in wanted], abs=1e-12)
        differ += wanted != on_a_line(masses, speeds, c, limit, worst=False)
    assert differ > 100


# The limits


@pytest.mark.parametrize("kind", RESOLVERS)
def test_no_contacts_are_no_work(kind: type[ContactResolver]) -> None:
    resolver = kind()
    resolver.iterations_used = 9
    resolver.resolve_contacts(iter(()), FRAME)
    assert resolver.iterations_used == 0


# Depths


@pytest.mark.parametrize("kind", RESOLVERS)
def test_depths_are_what_the_places_say_however_many_contacts_share_a_particle(
    kind: type[ContactResolver],
) -> None:
    """No move changes penetration + (pa - pb) . n. There are 60 contacts of 15 particles."""
    draw = random.Random(71)
    for limit in (1, 7, 60, None):
        _, contacts = tangle(draw, 15, 60)
        kept = [depth_and_place(contact) for contact in contacts]
        resolver = kind(limit)
        resolver.resolve_contacts(contacts, FRAME)
        assert resolver.iterations_used > 0
        # At most 120 moves of 1 m, each with a few roundings.
        assert [depth_and_place(contact) for contact in contacts] == pytest.approx(kept, abs=1e-12)


def depth_and_place(contact: Contact) -> float:
    apart = contact.particle.position
    if contact.other is not None:
        apart = apart - contact.other.position
    return contact.penetration + apart.dot(contact.normal)


# Random scenes


def tangle(draw: random.Random, particles: int, count: int) -> tuple[list[Particle], list[Contact]]:
    """Return moving particles, some of them immovable, and contacts between any of them.

    Some pairs appear twice with different normals. Every fifth contact is with the world.
    """

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


@pytest.mark.parametrize("kind", RESOLVERS)
def test_no_resolution_adds_kinetic_energy(kind: type[ContactResolver]) -> None:
    """This holds for every limit, and so for every part of the work, without moving walls."""
    for make, size, seed in SCENES[:4] + SCENES[7:10] + SCENES[13:16]:
        draw = random.Random(f"{make.__name__} {seed}")
        bodies, contacts = tangle(draw, size // 3, size) if make is tangle else make(draw, size)
        for body in bodies:
            if not body.inverse_mass:
                body.velocity.clear()
        before = math.fsum(body.kinetic_energy() for body in bodies)
        resolver, energies = kind(1), [before]
        for _ in range(2 * len(contacts)):
            resolver.resolve_contacts(copy.copy(contacts), FRAME)
            energies.append(math.fsum(body.kinetic_energy() for body in bodies))
        # Restitution 1 conserves the energy, with one rounding for each resolution.
        assert all(after <= now + 1e-15 * before for now, after in pairwise(energies))
        assert energies[-1] < 0.99 * before
