"""Pairs compared with a test of every pair, and stacks that stand or sink."""

from __future__ import annotations

import math
import random
from itertools import combinations, pairwise
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints import detectors
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0, 0.0)


# Pairs


def touching(particles: list[Particle], radius: float) -> list[tuple[int, int, float]]:
    """Return the indices and depths of all touching pairs, by testing every pair."""
    found = []
    for i, j in combinations(range(len(particles)), 2):
        a, b = particles[i], particles[j]
        depth = 2.0 * radius - math.dist(tuple(a.position), tuple(b.position))
        if depth >= 0.0 and (a.inverse_mass or b.inverse_mass):
            found.append((i, j, depth))
    return found


def cloud(draw: random.Random, n: int, size: float, flat: int = 0) -> list[Particle]:
    def place() -> Vector3:
        numbers = [draw.uniform(-size, size) for _ in range(3)]
        return Vector3(*(0.0 if axis < flat else x for axis, x in enumerate(numbers)))

    return [Particle(place(), mass=math.inf if i % 6 == 0 else 1.0) for i in range(n)]


@pytest.mark.parametrize("seed", range(12))
def test_pairs_are_what_looking_at_every_pair_finds_in_their_order(seed: int) -> None:
    draw = random.Random(f"pairs {seed}")
    radius = draw.choice([0.5, 0.1, 3.0, 1e-3, 40.0])
    size = radius * draw.choice([0.1, 2.0, 6.0, 12.0])  # all in one cell, crowded, or spread out
    particles = cloud(draw, 150, size, seed % 3)
    found = ParticlePairs(particles, radius, 0.3).contacts()
    wanted = touching(particles, radius)
    number = {id(particle): i for i, particle in enumerate(particles)}
    got = [(number[id(c.particle)], number[id(c.other)]) for c in found]
    assert got == [(i, j) for i, j, _ in wanted]
    assert got
    for contact, (i, j, depth) in zip(found, wanted, strict=True):
        # Some roundings of twice the radius.
        assert contact.penetration == pytest.approx(depth, abs=1e-14 * radius)
        apart = particles[i].position - particles[j].position
        assert contact.normal.dot(apart) == pytest.approx(apart.magnitude(), rel=1e-14)


def test_contacts_are_made_for_what_touches_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    made = []
    contact = detectors.Contact

    def counted(*args: Any) -> Any:
        made.append(args)
        return contact(*args)

    monkeypatch.setattr(detectors, "Contact", counted)
    particles = cloud(random.Random(77), 200, 3.0)
    assert len(ParticlePairs(particles, 0.3).contacts()) == len(made) > 50


# Stacks


def settle(n: int) -> tuple[list[float], float]:
    """Stack balls of 1 m. Return their heights after 10 s, and the largest overlap."""
    balls = [Particle(Vector3(0.0, 0.5 + i), acceleration=UP * -9.81) for i in range(n)]
    both = Detectors(GroundPlane(balls, 0.0, 0.5), ParticlePairs(balls, 0.5))
    worst = 0.0
    for _ in range(600):
        semi_implicit_euler(balls, lambda _: None, FRAME)
        ContactResolver().resolve_contacts(both.contacts(), FRAME)
        heights = [ball.position.y for ball in balls]
        gaps = [heights[0] - 0.5 + 1.0, *(b - a for a, b in pairwise(heights))]
        worst = max(worst, *(1.0 - gap for gap in gaps))
    return heights, worst


def test_three_on_each_other_stay_with_the_default_number_of_iterations() -> None:
    heights, worst = settle(3)
    assert worst < 0.06
    assert heights == pytest.approx([0.5, 1.5, 2.5], abs=0.06)


def test_ten_on_each_other_sink_with_the_default_number_of_iterations() -> None:
    """The default of two iterations per contact does not carry the weight of ten balls."""
    heights, worst = settle(10)
    assert worst > 0.5
    assert heights[-1] < 8.5  # 8.27 was measured, so more than one diameter in ten is lost
