"""Detectors compared with a test of every pair, their work, and stacks that stand or sink."""

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


# The ground


@pytest.mark.parametrize("radius", [0.0, 0.5])
def test_the_ground_finds_what_touches_it_and_what_is_below(radius: float) -> None:
    """Test at 2 m: exactly touching, one bit above, deep in the ground, and immovable."""
    level = 2.0 + radius
    heights = [level, math.nextafter(level, 9.0), level - 0.75, -1e6]
    particles = [Particle(Vector3(3.0, y, -4.0)) for y in heights]
    particles[2:2] = [Particle(Vector3(), mass=math.inf)]
    found = GroundPlane(particles, 2.0, radius, 0.25).contacts()
    assert [contact.particle for contact in found] == [particles[i] for i in (0, 3, 4)]
    assert [contact.penetration for contact in found] == [0.0, 0.75, 1e6 + level]
    assert {(contact.other, tuple(contact.normal), contact.restitution) for contact in found} == {
        (None, (0.0, 1.0, 0.0), 0.25)
    }


@pytest.mark.parametrize("radius", [0.0, 0.02])
def test_what_comes_at_1000_m_s_is_never_found_below_after_its_frame(radius: float) -> None:
    draw, resolver = random.Random(74), ContactResolver()
    balls = [
        Particle(Vector3(i, draw.uniform(0.1, 40.0)), Vector3(0.0, -1000.0), UP * -10.0)
        for i in range(50)
    ]
    ground, hits = GroundPlane(balls, 0.0, radius, 0.5), 0
    for _ in range(60):
        semi_implicit_euler(balls, lambda _: None, FRAME)
        contacts = ground.contacts()
        hits += len(contacts)
        resolver.resolve_contacts(contacts, FRAME)
        # Two roundings: of the depth of 17 m, and of its addition to the position.
        assert min(ball.position.y for ball in balls) >= radius - 1e-14
    assert hits >= 50


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


def lattice(draw: random.Random, n: int, radius: float) -> list[Particle]:
    """Return neighbors on a grid around the origin that touch exactly, in random order."""
    places = [
        Vector3(*(2.0 * radius * i for i in cell))
        for cell in ((x, y, z) for x in range(-n, n) for y in range(-n, n) for z in range(-n, n))
    ]
    draw.shuffle(places)
    return [Particle(place) for place in places]


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


@pytest.mark.parametrize("radius", [0.5, 0.25, 1.0, 0.1, 0.3])
def test_what_touches_exactly_is_found_also_across_cells_and_below_zero(radius: float) -> None:
    """A grid of 6 by 6 by 6 has 3 * 5 * 36 pairs of neighbors. The first radii are exact."""
    particles = lattice(random.Random(75), 3, radius)
    found = ParticlePairs(particles, radius).contacts()
    assert len(found) == len(touching(particles, radius))
    if radius in (0.5, 0.25, 1.0):
        assert len(found) == 3 * 5 * 36
        assert {contact.penetration for contact in found} == {0.0}


def test_two_at_one_place_part_upwards() -> None:
    a, b = Particle(Vector3(1.0)), Particle(Vector3(1.0))
    (contact,) = ParticlePairs([a, b], 0.5).contacts()
    assert (contact.normal, contact.penetration, contact.particle) == (UP, 1.0, a)


def test_the_work_grows_with_the_number_of_particles_and_not_with_its_square(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The work is the number of pairs tested. At one density it grows with the number: 10 times.

    15 allows for chance and for the edge of the cloud, where a particle has fewer neighbors.
    """
    looked: list[int] = []
    near = ParticlePairs._near_pairs

    def counted(self: ParticlePairs) -> list[tuple[int, int]]:
        pairs = near(self)
        looked.append(len(pairs))
        return pairs

    monkeypatch.setattr(ParticlePairs, "_near_pairs", counted)
    for n in (100, 1000):
        side = n ** (1.0 / 3.0)
        particles = cloud(random.Random(76), n, side)  # one per 8 m^3
        assert len(ParticlePairs(particles, 0.5).contacts()) == len(touching(particles, 0.5))
    few, many = looked
    assert few >= 20
    assert many <= 15 * few
    assert many < 1000 * 999 / 2 / 20  # 19 in 20 of all pairs are not tested


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


def settle(n: int, iterations: int | None, *, per_contact: bool = False) -> tuple[list[float], Any]:
    """Return the heights after 10 s of balls of 1 m that were stacked so that they touch."""
    balls = [Particle(Vector3(0.0, 0.5 + i), acceleration=UP * -9.81) for i in range(n)]
    both = Detectors(GroundPlane(balls, 0.0, 0.5), ParticlePairs(balls, 0.5))
    worst = 0.0
    for _ in range(600):
        semi_implicit_euler(balls, lambda _: None, FRAME)
        contacts = both.contacts()
        limit = iterations and iterations * (len(contacts) if per_contact else 1)
        ContactResolver(limit).resolve_contacts(contacts, FRAME)
        heights = [ball.position.y for ball in balls]
        gaps = [
            heights[0] - 0.5 + 1.0,
            *(b - a for a, b in pairwise(heights)),
        ]
        worst = max(worst, *(1.0 - gap for gap in gaps))
    return heights, worst


def test_three_on_each_other_stay_with_the_default_number_of_iterations() -> None:
    heights, worst = settle(3, None)
    assert worst < 0.06
    assert heights == pytest.approx([0.5, 1.5, 2.5], abs=0.06)


def test_ten_on_each_other_want_fifty_iterations_a_contact() -> None:
    heights, worst = settle(10, 50, per_contact=True)
    assert worst < 0.06
    assert heights[-1] == pytest.approx(9.5, abs=0.3)


def test_ten_on_each_other_sink_with_the_default_number_of_iterations() -> None:
    """The default of two iterations per contact does not carry the weight of ten balls."""
    heights, worst = settle(10, None)
    assert worst > 0.5
    assert heights[-1] < 8.5  # 8.27 was measured, so more than one diameter in ten is lost


# Rejected arguments


@pytest.mark.parametrize(
    ("make", "error", "match"),
    [
        (lambda: GroundPlane(Particle()), TypeError, "particles must be a list"),
        (lambda: GroundPlane([None]), TypeError, r"particles\[0\]"),
        (lambda: GroundPlane([], math.nan), ValueError, "height"),
        (lambda: GroundPlane([], 0.0, -0.1), ValueError, "radius"),
        (lambda: GroundPlane([], 0.0, 0.1, 1.1), ValueError, "restitution"),
        (lambda: ParticlePairs((Particle(), 3), 0.5), TypeError, r"particles\[1\]"),
        (lambda: ParticlePairs([], 0.0), ValueError, "radius"),
        (lambda: ParticlePairs([], math.inf), ValueError, "radius"),
        (lambda: ParticlePairs([], 0.5, -0.1), ValueError, "restitution"),
        (lambda: ParticlePairs([], None), TypeError, "radius"),
        (lambda: GroundPlane([]).next_impact(-1.0), ValueError, "duration"),
        (lambda: ParticlePairs([], 0.5).next_impact(math.nan), ValueError, "duration"),
    ],
)
def test_what_a_detector_cannot_be_made_of_is_named(
    make: Any, error: type[Exception], match: str
) -> None:
    with pytest.raises(error, match=match):
        make()


def test_a_list_is_kept_and_grows() -> None:
    particles: list[Particle] = []
    ground, pairs = GroundPlane(particles), ParticlePairs(particles, 0.5)
    particles += [Particle(), Particle()]
    assert (len(ground.contacts()), len(pairs.contacts())) == (2, 1)
