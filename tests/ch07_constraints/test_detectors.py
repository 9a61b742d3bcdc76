"""Detectors of current contacts: the ground and pairs of spheres, 7.5 and B7.9."""

from __future__ import annotations

import math
from collections.abc import Sequence, Set
from itertools import combinations
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import ground_of_a_list, kind_of, looked, pairs_of_a_list, piled, told
from draw import Triple, number, positive_number, unit_vector, vector
from expect import about, expect_between, expect_close, expect_exactly
from impacts import expect_list, expect_particles
from unmoved import expect_all_kept

LEFT, RIGHT, UP = Triple((-1.0, 0.0, 0.0)), Triple((1.0, 0.0, 0.0)), Triple((0.0, 1.0, 0.0))
GROUND = "exercise 7.5, and the docstring of GroundPlane.contacts"
PAIRS = "the docstring of ParticlePairs.contacts"
INDICES = "; the indices of the particles in the returned contacts"
DEEP = "The ground is infinitely deep, so return a contact for every particle below its surface."
RESTITUTION = "Pass the detector's restitution to each contact that you create."


@pytest.mark.exercise("7.5", asks="touches the ground or is below it", read=GROUND)
def test_a_particle_on_the_ground_has_a_contact(rng: Random) -> None:
    height, c = number(rng), round(rng.uniform(0.1, 0.9), 3)
    lowest = "Whatever its velocity is, compare y - radius with the height of the ground."
    for above, cause in (
        (0.125,
         "Compare y - radius with the height of the ground, and return an empty list here."),
        (1e-6, "It is 1e-6 m above the ground and doesn't touch it. Return an empty list."),
        (-0.5, lowest),
        (-0.125, lowest),
        (0.0, "A particle that just touches needs a contact, with a penetration of 0."),
        (-80.0, f"You returned no contact for a particle 80 m below the ground's height. {DEEP}"),
    ):  # fmt: skip
        for radius in (0.0, 0.25):
            # Eighths of a meter are exact beside a radius of a quarter.
            place, wanted = (number(rng), height + radius + above, number(rng)), -above
            with calls(cause):
                p = Particle(Vector3(*place), Vector3(1.0, 50.0, 3.0), mass=3.0)
                ground = GroundPlane([p], height=height, radius=radius, restitution=c)
                found = ground.contacts()
            expect_list(kind_of(found))
            got = told(found, [p])
            expect_exactly(len(got), 0 if above > 0.0 else 1, unit="contacts")
            for a, b, normal, restitution, depth in got:
                slips = {
                    "You left out the radius.": wanted - radius,
                    "Your radius has the wrong sign.": wanted - 2.0 * radius,
                    "You passed the restitution as the penetration. The order of the arguments is "
                    "Contact(particle, other, normal, restitution, penetration).": c,
                    "The penetration has the wrong sign.": -wanted,
                    "You computed the depth as if the ground were at a height of 0.":
                        wanted - height,
                }  # fmt: skip
                why = "Compute how deep the particle's lowest point is: height + radius - y."
                name = "; the penetration of the contact"
                # Rounding of heights up to 10 m.
                expect_close(depth, wanted, slips, then=name, cause=why, tolerance=2e-14, unit="m")
                why = "Create the contact with the particle p, and with None for the ground."
                expect_particles((a, b), (0, -1), ["p"], cause=why)
                slips = {"Your normal points down, so p is pushed farther into the ground.": -UP}
                name, why = "; the normal of the contact", "Use (0, 1, 0), which points up."
                expect_close(normal, UP, slips, then=name, cause=why)
                name = "; the restitution of the contact"
                expect_close(restitution, c, then=name, cause=RESTITUTION, tolerance=1e-13)


@pytest.mark.exercise("7.5", asks="Immovable particles have no contacts", read=GROUND)
def test_every_movable_particle_on_the_ground_has_a_contact(rng: Random) -> None:
    heights = [number(rng) for _ in range(6)]
    with calls(
        "Return one contact for each particle at or below a height of 0, in the order of the list. "
        "Collect the contacts of all particles, and return them after the loop.",
        f"six particles at y = {heights}; ground = GroundPlane(particles); ground.contacts()",
    ):
        first, second, third = ground_of_a_list(heights)
    expect_exactly(first, [i for i, y in enumerate(heights) if y <= 0.0], then=INDICES)
    why = "The list and the heights have changed since the first call. Read both on every call."
    if 1 in second:
        why = "Particle 1 has become immovable. Skip every particle that is immovable now."
    name = "; p.position.y = -1 for every p in particles; particles[1].mass = math.inf; "
    name += "particles.append(Particle(Vector3(0, -1, 0))); ground.contacts()"
    expect_exactly(second, [0, 2, 3, 4, 5, 6], then=f"{name}{INDICES}", cause=why)
    why = "The height and the radius have changed. Read both again on every call."
    name += "; ground.height = -2; ground.radius = 0.5; ground.contacts()"
    expect_exactly(third, [], then=f"{name}{INDICES}", cause=why)


@pytest.mark.exercise("7.5", asks="even a very fast particle cannot pass", read=GROUND)
def test_a_fast_particle_does_not_pass_through_the_ground(rng: Random) -> None:
    speed = positive_number(rng, 500.0, 2000.0)
    with calls(f"The particle is several meters below the ground after this step. {DEEP}"):
        p = Particle(Vector3(0.0, 1.0, 0.0), Vector3(0.0, -speed, 0.0))
        p.integrate(1.0 / 60.0)
        found = GroundPlane([p]).contacts()
    fallen, name = p.position.y, "; the height of p plus the penetration of its contact"
    got = fallen + sum(depth for *_, depth in told(found, [p]))
    expect_close(got, 0.0, tolerance=1e-12, then=name, unit="m")
    expect_close(fallen, 1.0 - speed / 60.0, tolerance=1e-12, then="; p.position.y", unit="m")


@pytest.mark.exercise("B7.9", asks="each pair of spheres that touch or overlap", read=PAIRS)
def test_spheres_touch_at_two_radii(rng: Random) -> None:
    m, c, place = unit_vector(rng), round(rng.uniform(0.1, 0.9), 3), vector(rng)
    for p, q, radius, n, depth, cause in (
        (place + m * 1.500001, place, 0.75, m, -1e-6,
         "Their centers are more than two radii apart."),
        (place + m * 1.25, place, 0.75, m, 0.25,
         "Their centers are 1.25 m apart, less than two radii (1.5 m), so they need one."),
        (place + m * 0.5, place, 4.0, m, 7.5,
         "Their centers are 0.5 m apart, less than two radii (8 m), so they need one."),
        (LEFT * 2.0, LEFT, 0.75, LEFT, 0.5,
         "They touch, because their centers are 1 m apart. If you use cells, compute their "
         "indices with math.floor, because int rounds toward 0."),
        (RIGHT * 3.0, RIGHT * 5.0, 1.0, LEFT, 0.0,
         "Their centers are exactly two radii apart. Their penetration is 0."),
        (LEFT * 1e-17, RIGHT * 2.0, 1.0, LEFT, 0.0,
         "Apart from rounding, they touch. If you use cells, make them a little larger."),
        (place, place, 1.0, UP, 2.0,
         "Both centers are at the same position. Use +Y as the normal."),
    ):  # fmt: skip
        with calls(cause):
            a, b = Particle(Vector3(*p)), Particle(Vector3(*q))
            found = ParticlePairs([a, b], radius=radius, restitution=c).contacts()
        expect_list(kind_of(found))
        expect_all_kept("the position of particle {}", [a.position, b.position], [p, q])
        wanted = [(0, 1, n, c, depth)] if depth >= 0.0 else []
        expect_pairs(told(found, [a, b]), wanted, 2.0 * radius)


def expect_pairs(
    got: list, wanted: Sequence[tuple], size: float, walls: Set[int] = frozenset()
) -> None:
    """Expect these contacts, in this order: both indices, normal, restitution, penetration.

    ``size`` is two radii, and the particles with the indices in ``walls`` are immovable.
    """

    def named(pair: tuple) -> str:
        return "a and b" if "[a, b]" in about.call else "particles {} and {}".format(*pair)

    seen, pairs = ([(a, b) for a, b, *_ in contacts] for contacts in (got, wanted))
    found, known = ({frozenset(pair) for pair in each} for each in (seen, pairs))
    missing = [pair for pair in pairs if frozenset(pair) not in found]
    extra = [pair for pair in seen if frozenset(pair) not in known]
    why = "Sort the pairs by the indices of their particles, with the smaller index first."
    if len(found) < len(seen):
        why = "You returned two contacts for the same pair. Return only one for each pair."
    elif missing and walls & {*missing[0]}:
        why = f"You returned no contact between {named(missing[0])}, but only one of them is "
        why += "immovable. Skip a pair only if both particles are immovable."
    elif missing:
        why = f"You returned no contact between {named(missing[0])}. {about.cause}"
    elif extra and {*extra[0]} <= walls:
        why = f"You returned a contact between {named(extra[0])}, but both are immovable. Skip it."
    elif extra:
        why = f"You returned a contact between {named(extra[0])}, which don't touch."
    expect_exactly(len(got), len(wanted), cause=why, unit="contacts")
    for i, (one, right) in enumerate(zip(seen, pairs, strict=True)):
        name = f"; the indices of the particles in contact {i}"
        expect_exactly(one, right, then=name, cause=why)
    for (_, _, normal, restitution, depth), (_, _, n, c, deep) in zip(got, wanted, strict=True):
        why = "Use the unit vector from the second particle of the pair to the first."
        name, slips = "; the normal of a contact", {"The normal points the wrong way.": -n}
        why = about.cause if n == UP else why
        # Differences of positions of up to 10 m, over a distance of half a meter or more.
        expect_close(normal, n, slips, then=name, cause=why, tolerance=1e-13)
        name, apart = "; the restitution of a contact", size - deep
        expect_close(restitution, c, then=name, cause=RESTITUTION)
        slips = {
            "You subtracted squared lengths.": size * size - apart * apart,
            "The penetration has the wrong sign.": -deep,
            "You used only one radius.": 0.5 * size - apart,
            "You used the distance between the centers as the penetration.": apart,
        }
        name = "; the penetration of a contact"
        why = "Compute the penetration as two radii minus the distance between the centers."
        expect_close(depth, deep, slips, then=name, cause=why, tolerance=1e-13, unit="m")


@pytest.mark.exercise("B7.9", asks="The contacts are in the order of the list", read=PAIRS)
def test_every_pair_is_found_once(rng: Random) -> None:
    walls = {3, 4, 5, 6}
    for count, size, radius in ((40, 1.0, 0.25), (60, 9.0, 0.8), (30, 0.5, 2.0)):
        places = [Triple(rng.uniform(-size, size) for _ in range(3)) for _ in range(count)]
        with calls(
            "Your search doesn't compare them, although they touch. Extend it to every pair that "
            "can touch.",
            f"{count} particles in a cube with an edge of {2 * size:g} m, where particles 3 to 6 "
            f"are immovable; ParticlePairs(particles, radius={radius}).contacts()",
        ):
            masses = [math.inf if i in walls else 1.0 for i in range(count)]
            particles = [Particle(Vector3(*p), mass=m) for p, m in zip(places, masses, strict=True)]
            got = told(ParticlePairs(particles, radius).contacts(), particles)
        now = [particle.position for particle in particles]
        expect_all_kept("the position of particle {}", now, places)
        wanted = []
        for i, j in combinations(range(count), 2):
            line = places[i] - places[j]
            if abs(line) <= 2.0 * radius and not {i, j} <= walls:
                wanted.append((i, j, line / abs(line), 0.0, 2.0 * radius - abs(line)))
        expect_pairs(got, wanted, 2.0 * radius, walls)


@pytest.mark.exercise("B7.9", asks="Do not compare every pair", read=PAIRS)
def test_not_every_pair_is_compared() -> None:
    with calls(
        "You compare far too many pairs. Put the particles in a grid, or sort them along an axis, "
        "and compare only those that are near each other.",
        "400 particles in a cube with an edge of 40 m; ParticlePairs(particles, "
        "radius=0.5).contacts()",
    ):
        asked, found, wanted = looked(400, 40.0)
    # A grid asks about 1,400 times, a sweep along an axis some 33,000 times.
    name = "; the number of times that x, y or z of a position is read"
    expect_between(asked, -math.inf, 100_000, then=name, unit="times")
    why = "Two particles that touch have no contact. Compare particles in neighboring cells too."
    expect_exactly(found, wanted, cause=why, unit="contacts")


@pytest.mark.exercise("B7.9", asks="you may add particles to the list later", read=PAIRS)
def test_pairs_are_found_again_on_every_call(rng: Random) -> None:
    radius = positive_number(rng, 0.5, 1.5)
    with calls(
        "The particles are more than two radii apart, so they don't touch. Return no contact.",
        "four particles in a row, three radii apart; pairs = ParticlePairs(particles, "
        f"radius={radius}); pairs.contacts()",
    ):
        first, second, third = pairs_of_a_list(radius)
    expect_exactly(first, [], then=INDICES)
    why = "The particles or the radius have changed. Read the list and the radius on every call."
    name = "; particle 3 moved next to particle 0; particle 4 added between particles 1 and 2; "
    name += "pairs.contacts()"
    expect_exactly(second, [0, 3, 1, 4, 2, 4], then=f"{name}{INDICES}", cause=why)
    name += f"; pairs.radius *= 2; pairs.contacts(){INDICES}"
    expect_exactly(third, [0, 1, 0, 3, 1, 2, 1, 4, 2, 4], then=name, cause=why)


@pytest.mark.exercise("B7.9", asks="in the same cell or in neighboring cells", read=PAIRS)
def test_spheres_in_neighboring_cells_touch_too(rng: Random) -> None:
    radius = positive_number(rng, 0.3, 0.9)
    for way in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 1, 1), (-1, 1, 1)):
        step = Triple(way) * (1.8 * radius / abs(Triple(way)))
        with calls(
            "Two neighbors in the row have no contact. Search all 26 cells around a particle's own "
            "cell too.",
            f"21 particles in a straight row through (0, 0, 0), each {step} after the previous "
            f"one; ParticlePairs(particles, radius={radius}).contacts()",
        ):
            particles = [Particle(Vector3(*(step * (i - 10)))) for i in range(21)]
            got = told(ParticlePairs(particles, radius).contacts(), particles)
        seen = [number for a, b, *_ in got for number in (a, b)]
        wanted = [number for i in range(20) for number in (i, i + 1)]
        expect_exactly(seen, wanted, then=INDICES)


@pytest.mark.exercise("B7.9", asks="each pair of spheres that touch or overlap", read=PAIRS)
def test_a_pile_of_six_holds() -> None:
    """Only here contacts are found again in every step, while the resolver moves the spheres."""
    with calls(
        "The spheres sink into each other. Check that each sphere has a contact with the sphere "
        "below it in every step.",
        "six spheres (1 kg, radius 0.5 m) stacked on the ground; 12 semi-implicit steps of 1/60 s "
        "with ParticlePairs(spheres, 0.5).contacts() and ContactResolver(500)",
    ):
        heights, overlap = piled(6, 500, 12, detect=True)
    # Measured: 0.02 m of overlap at most; 6 % of the diameter is allowed.
    name = "; the final heights of the centers"
    expect_close(heights, tuple(i + 0.5 for i in range(6)), then=name, tolerance=0.06, unit="m")
    name = "; the largest overlap after any step"
    expect_between(overlap, -0.06, 0.06, then=name, unit="m")
