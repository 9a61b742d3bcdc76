"""Detectors of current contacts: the ground and pairs of spheres, 7.5 and B7.9."""

from __future__ import annotations

import math
from itertools import combinations
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import (
    ground_of_a_list,
    looked,
    pairs_of_a_list,
    piled,
    thrown_down,
    told,
)
from draw import Components, components, direction, number, positive_number
from expect import about, cause_of, expect_between, expect_close, expect_exactly, scoped

UP = (0.0, 1.0, 0.0)
GROUND = "exercise 7.5, and the docstring of GroundPlane.contacts"
PAIRS = "the docstring of ParticlePairs.contacts"


@pytest.mark.exercise("7.5")
def test_what_touches_the_ground_is_in_contact(rng: Random) -> None:
    about.read = GROUND
    height, c = number(rng), round(rng.uniform(0.1, 0.9), 3)
    lowest = "The lowest point of the sphere, y - radius, is below the height of the ground. "
    lowest += "Return a contact of that depth, whatever the velocity is: only the position decides "
    lowest += "whether a sphere touches the ground."
    for radius in (0.0, 0.25):
        about.call = f"GroundPlane([p], {height}, {radius}, {c}).contacts()"
        # Eighths of a meter are exact beside a radius of a quarter.
        for above, depths, cause in (
            (
                0.125,
                [],
                "The sphere is above the ground and doesn't touch it, so there is no contact.",
            ),
            (
                1e-6,
                [],
                "The sphere is just above the ground but doesn't touch it yet, so there is no "
                "contact.",
            ),
            (-0.5, [0.5], lowest),
            (-0.125, [0.125], lowest),
            (
                0.0,
                [0.0],
                "This sphere just touches the ground. Return a contact with a "
                "penetration of 0, so that a body at rest keeps its contact.",
            ),
            (
                -80.0,
                [80.0],
                "This sphere is far below the surface, but everything below the "
                "height is ground. Return a contact, however deep the sphere is.",
            ),
        ):
            about.cause = cause
            y = height + radius + above
            x, z = number(rng), number(rng)
            p = Particle(Vector3(x, y, z), Vector3(1.0, 50.0, 3.0), mass=3.0)
            got = told(GroundPlane([p], height, radius, c).contacts(), [p])
            name = f"p at ({x}, {y}, {z}); {about.call}"
            expect_exactly(len(got), len(depths), call=f"{name}: number of contacts")
            for (a, b, normal, restitution, depth), wanted in zip(got, depths, strict=True):
                # Rounding of heights up to 10 m.
                shown = f"{name}: penetration"
                mistakes = [
                    (wanted - radius, "You left out the radius, so the sphere touches the ground "
                                      "only when its center does. Use its lowest point, which is "
                                      "at y - radius."),
                    (wanted - 2.0 * radius, "Your radius has the wrong sign, so this is the "
                                            "highest point of the sphere. The lowest point is at y "
                                            "- radius."),
                    (-wanted, "The penetration has the wrong sign. It is positive when the sphere "
                              "is inside the ground, so compute height + radius - y."),
                    (wanted - height,
                     "You computed the depth as if the ground were at a height of 0. Compute "
                     "height + radius - y instead."),
                ]  # fmt: skip
                why = cause_of(depth, mistakes, about.cause)
                expect_close(depth, wanted, call=shown, cause=why, tolerance=2e-14)
                seen = (a, b, *normal, restitution)
                why = "The depth is right, but the contact isn't. Create it with the particle, "
                why += "None as its other, the normal (0, 1, 0), the detector's restitution and "
                why += "the depth."
                down = (0, -1, 0, -1, 0, c)
                why = cause_of(
                    seen,
                    [
                        (
                            down,
                            "Your normal points down, so the contact would push the sphere farther "
                            "into the ground. It should point up, out of the ground.",
                        )
                    ],
                    why,
                )
                shown = f"{name}: index of particle and other (-1 is None), normal, restitution"
                expect_close(seen, (0, -1, *UP, c), call=shown, cause=why)


@pytest.mark.exercise("7.5")
def test_the_ground_is_for_all_that_moves(rng: Random) -> None:
    about.read = GROUND
    heights = [number(rng) for _ in range(6)]
    about.call = f"particles at the heights {heights}; g = GroundPlane(particles); g.contacts(): "
    about.call += "the indices of the particles"
    about.cause = "Return one contact for each particle at or below the surface, in list order."
    first, second, third = ground_of_a_list(heights)
    wanted = [i for i, y in enumerate(heights) if y <= 0.0]
    expect_exactly(first, wanted)
    about.call += "; all moved to -1, the second made immovable, one more appended; "
    about.call += "g.contacts(): the indices"
    about.cause = "Since the first call the check has moved some particles, made one immovable, "
    about.cause += "and added one to the list. Read the list again on every call, and skip "
    about.cause += "immovable particles."
    expect_exactly(second, [0, 2, 3, 4, 5, 6])
    about.call += "; g.height, g.radius changed to -2 and 0.5; g.contacts(): the indices"
    about.cause = "The check changed height and radius, but nothing happened. Read both on every "
    about.cause += "call instead of caching anything computed from them."
    expect_exactly(third, [])


@pytest.mark.exercise("7.5")
def test_nothing_is_too_fast_for_the_ground(rng: Random) -> None:
    about.read = GROUND
    speed = positive_number(rng, 500.0, 2000.0)
    about.call = f"a particle 1 m above the ground falls at {speed} m/s for 1/60 s; the "
    about.call += "penetration from GroundPlane([p]).contacts() is added to its height"
    about.cause = "The particle is now meters below the surface and should still be in contact. "
    about.cause += "Everything below the height is ground, not just a line to cross."
    fallen, got = thrown_down(speed, 1.0 / 60.0)
    expect_close(got, 0.0, tolerance=1e-12)
    name = f"a particle 1 m above the ground falls at {speed} m/s for 1/60 s: its height"
    expect_close(fallen, 1.0 - speed / 60.0, call=name, tolerance=1e-12)


@pytest.mark.exercise("B7.9")
def test_spheres_touch_at_two_radii(rng: Random) -> None:
    about.read = PAIRS
    n, c = direction(rng), round(rng.uniform(0.1, 0.9), 3)
    q = components(rng)
    cells = "If you use cells, compute their indices with math.floor, because int rounds toward 0."
    for radius, distance, wanted, cause in (
        (
            0.75,
            1.500001,
            None,
            "The centers are more than two radii apart, so the spheres don't touch. Return no "
            "contact.",
        ),
        (
            0.75,
            1.25,
            0.25,
            "The centers are 1.25 m apart, which is less than two radii (1.5 m), "
            f"so the spheres touch. {cells}",
        ),
        (
            4.0,
            0.5,
            7.5,
            "The centers are 0.5 m apart, which is less than two radii (8 m), so the "
            f"spheres touch. {cells}",
        ),
    ):
        about.cause = cause
        p = tuple(x + distance * part for x, part in zip(q, n, strict=True))
        about.call = f"a at {p}, b at {q}; ParticlePairs([a, b], {radius}, {c}).contacts()"
        pair = [Particle(Vector3(*p)), Particle(Vector3(*q))]
        got = told(ParticlePairs(pair, radius, c).contacts(), pair)
        expect_pairs(got, [] if wanted is None else [(0, 1, n, c, wanted)], 2 * radius)
    about.call = "a at (-2, 0, 0), b at (-1, 0, 0); ParticlePairs([a, b], 0.75).contacts()"
    about.cause = "The centers are 1 m apart, which is less than two radii (1.5 m), so the spheres "
    about.cause += f"touch. {cells}"
    pair = [Particle(Vector3(-2.0)), Particle(Vector3(-1.0))]
    got = told(ParticlePairs(pair, 0.75).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.5)], 1.5)
    about.call = "a at (3, 0, 0), b at (5, 0, 0); ParticlePairs([a, b], 1.0).contacts()"
    about.cause = "The centers are exactly two radii apart, so the spheres just touch. Return a "
    about.cause += "contact with a penetration of 0."
    pair = [Particle(Vector3(3.0)), Particle(Vector3(5.0))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.0)])
    about.call = "a at (-1e-17, 0, 0), b at (2, 0, 0); ParticlePairs([a, b], 1.0).contacts()"
    about.cause = "Up to rounding, the centers are two radii apart, so the spheres touch. If you "
    about.cause += "use cells, make them a little larger than two radii, or there can be an empty "
    about.cause += "cell between the spheres."
    pair = [Particle(Vector3(-1e-17)), Particle(Vector3(2.0))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.0)])
    about.call = f"a and b at {q}; ParticlePairs([a, b], 1.0).contacts()"
    about.cause = "Both centers are at the same position, so the normal has no natural direction. "
    about.cause += "Use +Y."
    pair = [Particle(Vector3(*q)), Particle(Vector3(*q))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, UP, 0.0, 2.0)])


@scoped
def expect_pairs(got: list, wanted: list[tuple], size: float = 2.0) -> None:
    """Expect these contacts, in this order: both indices, normal, restitution, penetration.

    ``size`` is two radii.
    """
    seen, pairs = ([(a, b) for a, b, *_ in contacts] for contacts in (got, wanted))
    found = {frozenset(pair) for pair in seen}
    if len(found) < len(seen):
        about.cause = "You returned the same pair twice, perhaps once for each of its particles "
        about.cause += "or cells. Return each pair only once: a second contact costs the resolver "
        about.cause += "time and changes nothing."
    elif missing := [pair for pair in pairs if frozenset(pair) not in found]:
        about.cause = f"The contact of the pair {missing[0]} is missing. {about.cause}"
    elif len(seen) > len(pairs):
        extra = [pair for pair in seen if pair not in pairs]
        about.cause = f"The pair {extra[0]} should not have a contact. {about.cause}"
    else:
        about.cause = "You found the right pairs but returned them in the wrong order. Sort them "
        about.cause += "by the indices of their particles, with the smaller index first in each "
        about.cause += "pair."
    expect_exactly(len(got), len(wanted), then=": number of pairs")
    expect_exactly(seen, pairs, then=": the pairs, by index")
    for (_, _, normal, restitution, depth), right in zip(got, wanted, strict=True):
        about.cause = "The normal of a contact is wrong. It should be the unit vector from the "
        about.cause += "second particle of the pair to the first."
        # Differences of positions of up to 10 m, over a distance of half a meter or more.
        expect_close(normal, right[2], then=": normal", tolerance=1e-13)
        about.cause = "A contact has the wrong restitution. Pass the detector's restitution to "
        about.cause += "each contact that you create."
        expect_close(restitution, right[3], then=": restitution")
        apart = size - right[4]
        mistakes = [
            (size * size - apart * apart,
             "You subtracted squared lengths, which gives an area. Subtract the distance itself "
             "from two radii."),
            (-right[4], "The penetration has the wrong sign. It is positive for overlapping "
                        "spheres, so subtract the distance from two radii."),
            (0.5 * size - apart, "You used only one radius, but the centers of touching spheres "
                                 "are two radii apart. Subtract the distance from two radii."),
            (apart,
             "Your penetration is the distance between the centers, which shrinks as the overlap "
             "gets deeper. Subtract that distance from two radii."),
        ]  # fmt: skip
        otherwise = "The penetration of a contact is wrong. Compute it as two radii minus the "
        otherwise += "distance between the centers."
        about.cause = cause_of(depth, mistakes, otherwise)
        expect_close(depth, right[4], then=": penetration", tolerance=1e-13)


@pytest.mark.exercise("B7.9")
def test_every_pair_is_found_once(rng: Random) -> None:
    about.read = PAIRS
    for count, size, radius in ((40, 1.0, 0.25), (60, 9.0, 0.8), (30, 0.5, 2.0)):
        places: list[Components] = [
            (rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size))
            for _ in range(count)
        ]
        walls = {3, 4, 5, 6}
        about.call = f"{count} particles in a cube of {2 * size:g} m, numbers 3 to 6 immovable; "
        about.call += f"ParticlePairs(particles, {radius}).contacts()"
        about.cause = "Every pair of touching spheres needs a contact, unless both are immovable, "
        about.cause += "as particles 3 to 6 are here."
        particles = [
            Particle(Vector3(*place), mass=math.inf if i in walls else 1.0)
            for i, place in enumerate(places)
        ]
        got = told(ParticlePairs(particles, radius).contacts(), particles)
        wanted = []
        for i, j in combinations(range(count), 2):
            distance = math.dist(places[i], places[j])
            if distance <= 2.0 * radius and not {i, j} <= walls:
                n = tuple((p - q) / distance for p, q in zip(places[i], places[j], strict=True))
                wanted.append((i, j, n, 0.0, 2.0 * radius - distance))
        expect_pairs(got, wanted, 2.0 * radius)


@pytest.mark.exercise("B7.9")
def test_not_every_pair_is_looked_at() -> None:
    about("400 spheres of radius 0.5 m in a cube of 40 m; ParticlePairs(spheres, ", read=PAIRS)
    about.call += "0.5).contacts(): accesses to positions"
    about.cause = "Comparing all 79,800 pairs reads the positions more than 400,000 times, which "
    about.cause += "is too slow. Put the particles in a grid, or sort them along an axis, and "
    about.cause += "compare only those that are near each other."
    asked, found, wanted = looked(400, 40.0)
    # A grid asks about 1,400 times, a sweep along an axis some 33,000 times.
    expect_between(asked, 0, 100_000)
    name = "the same: number of touching pairs"
    expect_exactly(
        found,
        wanted,
        call=name,
        cause="A pair of touching spheres has no contact. Perhaps they are in neighboring cells "
        "that your search doesn't compare.",
    )


@pytest.mark.exercise("B7.9")
def test_pairs_are_those_of_now(rng: Random) -> None:
    about.read = PAIRS
    radius = positive_number(rng, 0.5, 1.5)
    about.call = f"four particles in a row, three radii apart, radius {radius} m; p = "
    about.call += f"ParticlePairs(particles, {radius}); p.contacts(): the pairs, by index"
    about.cause = "The spheres are more than two radii apart, so they don't touch. Return no "
    about.cause += "contact."
    first, second, third = pairs_of_a_list(radius)
    expect_exactly(first, [])
    about.call += "; the last one moved next to the first, and one more put between the two others"
    about.cause = "You missed particles that have moved or joined the list since the first call. "
    about.cause += "Read the list and the positions again on every call."
    expect_exactly(second, [0, 3, 1, 4, 2, 4])
    about.call += "; p.radius doubled"
    about.cause = "The check has changed the detector's radius since the first call. Read it again "
    about.cause += "on every call."
    expect_exactly(third, [0, 1, 0, 3, 1, 2, 1, 4, 2, 4])


@pytest.mark.exercise("B7.9")
def test_a_grid_has_no_seams(rng: Random) -> None:
    about.read = PAIRS
    radius = positive_number(rng, 0.3, 0.9)
    about.cause = "A sphere can touch spheres in its own cell and in any of the 26 cells around "
    about.cause += "it. Compute the cell with math.floor, because int rounds negative coordinates "
    about.cause += "toward 0."
    for way in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 1, 1), (-1, 1, 1)):
        length = math.hypot(*way)
        step = tuple(1.8 * radius * part / length for part in way)
        places = [tuple((i - 10) * part for part in step) for i in range(21)]
        about.call = f"21 particles in a row through (0, 0, 0), {step} apart; "
        about.call += f"ParticlePairs(particles, {radius}).contacts(): the pairs, by index"
        particles = [Particle(Vector3(*place)) for place in places]
        got = told(ParticlePairs(particles, radius).contacts(), particles)
        seen = [number for a, b, *_ in got for number in (a, b)]
        wanted = [number for i in range(20) for number in (i, i + 1)]
        expect_exactly(seen, wanted)


@pytest.mark.exercise("B7.9")
def test_a_pile_of_six_holds() -> None:
    about.read = "book 7.3.1, and the docstring of ParticlePairs.contacts"
    about.call = "six spheres of 1 kg, radius 0.5 m, stacked on the ground; 12 semi-implicit steps "
    about.call += "of 1/60 s with ParticlePairs and a ContactResolver of 500 iterations"
    about.cause = "The spheres should not sink into each other. Check that in every step each "
    about.cause += "sphere has a contact with the one below it."
    particles = [
        Particle(Vector3(0.0, i + 0.5, 0.0), acceleration=Vector3(0.0, -9.81, 0.0))
        for i in range(6)
    ]
    heights, overlap = piled(
        particles, ParticlePairs(particles, 0.5), ContactResolver(500), 12, 1.0 / 60.0
    )
    wanted = tuple(i + 0.5 for i in range(6))
    # Measured: 0.02 m of overlap at most; 6 % of the diameter is allowed.
    expect_close(heights, wanted, then=": heights", tolerance=0.06)
    expect_between(overlap, -0.06, 0.06, then=": the largest overlap after a step, m")
