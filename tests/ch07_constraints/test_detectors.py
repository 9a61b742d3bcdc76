"""Detectors of current contacts: the ground and pairs of spheres, 7.5 and B7.9."""

from __future__ import annotations

import math
from collections.abc import Set
from itertools import combinations
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import (
    ground_of_a_list,
    kind_of,
    looked,
    pairs_of_a_list,
    piled,
    thrown_down,
    told,
)
from draw import Components, components, direction, number, positive_number
from expect import about, blame, cause_of, expect_between, expect_close, expect_exactly, scoped, xyz
from impacts import expect_list, expect_particles
from unmoved import expect_all_kept

UP = (0.0, 1.0, 0.0)
GROUND = "exercise 7.5, and the docstring of GroundPlane.contacts"
PAIRS = "the docstring of ParticlePairs.contacts"
INDICES = "; the indices of the particles in the returned contacts"


@pytest.mark.exercise("7.5", asks="touches the ground or is below it")
def test_a_particle_on_the_ground_has_a_contact(rng: Random) -> None:
    about.read = GROUND
    height, c = number(rng), round(rng.uniform(0.1, 0.9), 3)
    lowest = "You returned no contact, but the particle is below the ground. Whatever its "
    lowest += "velocity is, compare y - radius with the height of the ground."
    for radius in (0.0, 0.25):
        about.call = f"GroundPlane([p], height={height}, radius={radius}, "
        about.call += f"restitution={c}).contacts()"
        # Eighths of a meter are exact beside a radius of a quarter.
        for above, depths, cause in (
            (
                0.125,
                [],
                "The particle is above the ground and doesn't touch it. Compare y - radius with "
                "the height of the ground, and return an empty list here.",
            ),
            (
                1e-6,
                [],
                "The particle is 1e-6 m above the ground and doesn't touch it. Return an empty "
                "list.",
            ),
            (-0.5, [0.5], lowest),
            (-0.125, [0.125], lowest),
            (
                0.0,
                [0.0],
                "You returned no contact, but the particle just touches the ground. Return a "
                "contact with a penetration of 0, so that a body at rest keeps its contact.",
            ),
            (
                -80.0,
                [80.0],
                "You returned no contact for a particle that is 80 m below the ground's height. "
                "The ground is infinitely deep, so return a contact for every particle below its "
                "surface.",
            ),
        ):
            about.cause = cause
            y = height + radius + above
            x, z = number(rng), number(rng)
            p = Particle(Vector3(x, y, z), Vector3(1.0, 50.0, 3.0), mass=3.0)
            found = GroundPlane([p], height, radius, c).contacts()
            expect_list(kind_of(found))
            got = told(found, [p])
            name = f"particle p at ({x:g}, {y:g}, {z:g}) with velocity (1, 50, 3); {about.call}"
            expect_exactly(len(got), len(depths), call=name, unit="contacts")
            for (a, b, normal, restitution, depth), wanted in zip(got, depths, strict=True):
                # Rounding of heights up to 10 m.
                shown = f"{name}; the penetration of the contact"
                mistakes = [
                    (wanted - radius, "You left out the radius, so you measured how deep the "
                                      "center of the particle is. Use its lowest point, which is "
                                      "at y - radius."),
                    (wanted - 2.0 * radius, "Your radius has the wrong sign, so you used the "
                                            "highest point of the particle. Use its lowest point, "
                                            "which is at y - radius."),
                    (c, "You passed the restitution as the penetration. The order of the arguments "
                        "is Contact(particle, other, normal, restitution, penetration)."),
                    (-wanted, "The penetration has the wrong sign. It must be positive when the "
                              "particle is inside the ground, so compute height + radius - y."),
                    (wanted - height,
                     "You computed the depth as if the ground were at a height of 0. Use the "
                     "detector's height: compute height + radius - y."),
                ]  # fmt: skip
                why = "The penetration is wrong. It is the depth of the particle's lowest point "
                why += "below the ground, height + radius - y."
                why = cause_of(depth, mistakes, why)
                expect_close(depth, wanted, call=shown, cause=why, tolerance=2e-14, unit="m")
                why = "The contact is between the wrong two bodies. Create it with the particle p, "
                why += "and pass None as its other, because the ground is not a particle."
                expect_particles((a, b), (0, -1), ["p"], call=name, cause=why)
                why = "Your normal points down, so the contact pushes the particle farther into "
                why += "the ground. Use the normal (0, 1, 0), which points out of the ground."
                why = cause_of(
                    normal,
                    [((0, -1, 0), why)],
                    "The normal is wrong. Use (0, 1, 0), which points out of the ground.",
                )
                shown = f"{name}; the normal of the contact"
                expect_close(normal, UP, call=shown, cause=why)
                why = "The contact has the wrong restitution. Pass the detector's restitution when "
                why += "you create the contact."
                shown = f"{name}; the restitution of the contact"
                expect_close(restitution, c, call=shown, cause=why, tolerance=1e-13)


@pytest.mark.exercise("7.5", asks="Immovable particles have no contacts")
def test_every_movable_particle_on_the_ground_has_a_contact(rng: Random) -> None:
    about.read = GROUND
    heights = [number(rng) for _ in range(6)]
    about.call = f"six particles at y = {heights}; ground = GroundPlane(particles); "
    about.call += "ground.contacts()"
    about.cause = "Return one contact for each particle at or below a height of 0, in the order of "
    about.cause += "the list."
    first, second, third = ground_of_a_list(heights)
    wanted = [i for i, y in enumerate(heights) if y <= 0.0]
    if len(first) == 1 < len(wanted):
        about.cause = "You returned only one contact. Collect the contacts of all particles, and "
        about.cause += "return them after the loop."
    expect_exactly(first, wanted, then=INDICES)
    about.call += "; p.position.y = -1 for every p in particles; particles[1].mass = math.inf; "
    about.call += "particles.append(Particle(Vector3(0, -1, 0))); ground.contacts()"
    about.cause = "The particles and the list have changed since the first call. Read the list "
    about.cause += "and the heights again on every call."
    if 1 in second:
        about.cause = "You returned a contact for particle 1, which has become immovable. Skip "
        about.cause += "every particle that is immovable at the time of the call."
    expect_exactly(second, [0, 2, 3, 4, 5, 6], then=INDICES)
    about.call += "; ground.height = -2; ground.radius = 0.5; ground.contacts()"
    about.cause = "The height and the radius have changed, so no particle touches the ground now. "
    about.cause += "Read both again on every call."
    expect_exactly(third, [], then=INDICES)


@pytest.mark.exercise("7.5", asks="even a very fast particle cannot pass")
def test_a_fast_particle_does_not_pass_through_the_ground(rng: Random) -> None:
    about.read = GROUND
    speed = positive_number(rng, 500.0, 2000.0)
    about.call = f"particle p, 1 m above the ground, falls at {speed} m/s for 1/60 s; "
    about.call += "GroundPlane([p]).contacts(); the height of p plus the penetration of its contact"
    about.cause = "The particle is several meters below the ground after this step. The ground is "
    about.cause += "infinitely deep, so return a contact for every particle below its surface."
    fallen, got = thrown_down(speed, 1.0 / 60.0)
    expect_close(got, 0.0, tolerance=1e-12, unit="m")
    name = f"a particle 1 m above the ground falls at {speed} m/s for 1/60 s; its height"
    expect_close(fallen, 1.0 - speed / 60.0, call=name, tolerance=1e-12, unit="m")


@pytest.mark.exercise("B7.9", asks="each pair of spheres that touch or overlap")
def test_spheres_touch_at_two_radii(rng: Random) -> None:
    about.read = PAIRS
    n, c = direction(rng), round(rng.uniform(0.1, 0.9), 3)
    q = components(rng)
    for radius, distance, wanted, cause in (
        (
            0.75,
            1.500001,
            None,
            "Their centers are more than two radii apart.",
        ),
        (
            0.75,
            1.25,
            0.25,
            "Their centers are 1.25 m apart, less than two radii (1.5 m), so they need one.",
        ),
        (
            4.0,
            0.5,
            7.5,
            "Their centers are 0.5 m apart, less than two radii (8 m), so they need one.",
        ),
    ):
        about.cause = cause
        p = tuple(x + distance * part for x, part in zip(q, n, strict=True))
        about.call = f"particle a at {p}; particle b at {q}; ParticlePairs([a, b], "
        about.call += f"radius={radius}, restitution={c}).contacts()"
        pair = [Particle(Vector3(*p)), Particle(Vector3(*q))]
        found = ParticlePairs(pair, radius, c).contacts()
        expect_list(kind_of(found))
        got = told(found, pair)
        expect_all_kept("the position of particle {}", [xyz(one.position) for one in pair], [p, q])
        expect_pairs(got, [] if wanted is None else [(0, 1, n, c, wanted)], 2 * radius)
    about.call = "particle a at (-2, 0, 0); particle b at (-1, 0, 0); ParticlePairs([a, b], "
    about.call += "radius=0.75).contacts()"
    about.cause = "They touch, because their centers are 1 m apart. If you use cells, compute "
    about.cause += "their indices with math.floor, because int rounds toward 0."
    pair = [Particle(Vector3(-2.0)), Particle(Vector3(-1.0))]
    got = told(ParticlePairs(pair, 0.75).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.5)], 1.5)
    about.call = "particle a at (3, 0, 0); particle b at (5, 0, 0); ParticlePairs([a, b], "
    about.call += "radius=1.0).contacts()"
    about.cause = "Their centers are exactly two radii apart, so they just touch. Return a "
    about.cause += "contact with a penetration of 0."
    pair = [Particle(Vector3(3.0)), Particle(Vector3(5.0))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.0)])
    about.call = "particle a at (-1e-17, 0, 0); particle b at (2, 0, 0); ParticlePairs([a, b], "
    about.call += "radius=1.0).contacts()"
    about.cause = "Apart from rounding, their centers are two radii apart, so they touch. If you "
    about.cause += "use cells, make them a little larger than two radii."
    pair = [Particle(Vector3(-1e-17)), Particle(Vector3(2.0))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, (-1.0, 0.0, 0.0), 0.0, 0.0)])
    about.call = f"particles a and b, both at {q}; ParticlePairs([a, b], radius=1.0).contacts()"
    about.cause = "Both centers are at the same position, so there is no direction between them. "
    about.cause += "Use +Y as the normal."
    pair = [Particle(Vector3(*q)), Particle(Vector3(*q))]
    got = told(ParticlePairs(pair, 1.0).contacts(), pair)
    expect_pairs(got, [(0, 1, UP, 0.0, 2.0)])


@scoped
def expect_pairs(
    got: list, wanted: list[tuple], size: float = 2.0, walls: Set[int] = frozenset()
) -> None:
    """Expect these contacts, in this order: both indices, normal, restitution, penetration.

    ``size`` is two radii, and the particles with the indices in ``walls`` are immovable.
    """
    seen, pairs = ([(a, b) for a, b, *_ in contacts] for contacts in (got, wanted))
    found, two = {frozenset(pair) for pair in seen}, "[a, b]" in about.call
    if len(found) < len(seen):
        about.cause = "You returned two contacts for the same pair of particles. Return only one "
        about.cause += "contact for each pair."
    elif missing := [pair for pair in pairs if frozenset(pair) not in found]:
        both = "a and b" if two else "particles {} and {}".format(*missing[0])
        about.cause = f"You returned no contact between {both}. {about.cause}"
        if walls & {*missing[0]}:
            about.cause = f"You returned no contact between {both}, but only one of them is "
            about.cause += "immovable. Skip a pair only if both particles are immovable."
    elif len(seen) > len(pairs):
        known = {frozenset(pair) for pair in pairs}
        extra = [pair for pair in seen if frozenset(pair) not in known]
        both = "a and b" if two else "particles {} and {}".format(*extra[0])
        about.cause = f"You returned a contact between {both}, which don't touch."
        if {*extra[0]} <= walls:
            about.cause = f"You returned a contact between {both}, but both are immovable, so no "
            about.cause += "contact can move them. Skip such pairs."
    else:
        about.cause = "You returned the right pairs in the wrong order. Sort them by the indices "
        about.cause += "of their particles, with the smaller index first in each pair."
    expect_exactly(len(got), len(wanted), unit="contacts")
    for i, (one, right) in enumerate(zip(seen, pairs, strict=True)):
        expect_exactly(one, right, then=f"; the indices of the particles in contact {i}")
    for (_, _, normal, restitution, depth), right in zip(got, wanted, strict=True):
        about.cause = "The normal of a contact is wrong. Use the unit vector from the second "
        about.cause += "particle of the pair to the first."
        why = "The normal points the wrong way. Use the unit vector from the second particle of "
        why += "the pair to the first."
        blame(normal, [(tuple(-part for part in right[2]), why)])
        # Differences of positions of up to 10 m, over a distance of half a meter or more.
        expect_close(normal, right[2], then="; the normal of a contact", tolerance=1e-13)
        about.cause = "A contact has the wrong restitution. Pass the detector's restitution to "
        about.cause += "each contact that you create."
        expect_close(restitution, right[3], then="; the restitution of a contact")
        apart = size - right[4]
        mistakes = [
            (size * size - apart * apart,
             "You subtracted squared lengths. Compute the penetration as two radii minus the "
             "distance itself."),
            (-right[4], "The penetration has the wrong sign. It must be positive for overlapping "
                        "particles, so subtract the distance from two radii."),
            (0.5 * size - apart, "You used only one radius, but the centers of touching particles "
                                 "are two radii apart. Subtract the distance from two radii."),
            (apart,
             "You used the distance between the centers as the penetration. Subtract this distance "
             "from two radii."),
        ]  # fmt: skip
        otherwise = "The penetration of a contact is wrong. Compute it as two radii minus the "
        otherwise += "distance between the centers."
        about.cause = cause_of(depth, mistakes, otherwise)
        name = "; the penetration of a contact"
        expect_close(depth, right[4], then=name, tolerance=1e-13, unit="m")


@pytest.mark.exercise("B7.9", asks="The contacts are in the order of the list")
def test_every_pair_is_found_once(rng: Random) -> None:
    about.read = PAIRS
    for count, size, radius in ((40, 1.0, 0.25), (60, 9.0, 0.8), (30, 0.5, 2.0)):
        places: list[Components] = [
            (rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size))
            for _ in range(count)
        ]
        walls = {3, 4, 5, 6}
        about.call = f"{count} particles in a cube with an edge of {2 * size:g} m, where particles "
        about.call += f"3 to 6 are immovable; ParticlePairs(particles, radius={radius}).contacts()"
        about.cause = "Your search doesn't compare them, although they touch. Extend it to every "
        about.cause += "pair that can touch."
        particles = [
            Particle(Vector3(*place), mass=math.inf if i in walls else 1.0)
            for i, place in enumerate(places)
        ]
        got = told(ParticlePairs(particles, radius).contacts(), particles)
        now = [xyz(particle.position) for particle in particles]
        expect_all_kept("the position of particle {}", now, places)
        wanted = []
        for i, j in combinations(range(count), 2):
            distance = math.dist(places[i], places[j])
            if distance <= 2.0 * radius and not {i, j} <= walls:
                n = tuple((p - q) / distance for p, q in zip(places[i], places[j], strict=True))
                wanted.append((i, j, n, 0.0, 2.0 * radius - distance))
        expect_pairs(got, wanted, 2.0 * radius, walls)


@pytest.mark.exercise("B7.9", asks="Do not compare every pair")
def test_not_every_pair_is_compared() -> None:
    about.read = PAIRS
    about.call = "400 particles in a cube with an edge of 40 m; ParticlePairs(particles, "
    about.call += "radius=0.5).contacts(); the number of times that x, y or z of a position is read"
    about.cause = "You compare far too many pairs. Put the particles in a grid, or sort them "
    about.cause += "along an axis, and compare only those that are near each other."
    asked, found, wanted = looked(400, 40.0)
    # A grid asks about 1,400 times, a sweep along an axis some 33,000 times.
    expect_between(asked, -math.inf, 100_000, unit="times")
    about.call = about.call.rpartition(";")[0]
    about.cause = "Two particles that touch have no contact. Compare particles in neighboring "
    about.cause += "cells too."
    expect_exactly(found, wanted, unit="contacts")


@pytest.mark.exercise("B7.9", asks="you may add particles to the list later")
def test_pairs_are_found_again_on_every_call(rng: Random) -> None:
    about.read = PAIRS
    radius = positive_number(rng, 0.5, 1.5)
    about.call = "four particles in a row, three radii apart; pairs = ParticlePairs(particles, "
    about.call += f"radius={radius}); pairs.contacts()"
    about.cause = "The particles are more than two radii apart, so they don't touch. Return no "
    about.cause += "contact."
    first, second, third = pairs_of_a_list(radius)
    expect_exactly(first, [], then=INDICES)
    about.call += "; particle 3 moved next to particle 0; particle 4 added between particles 1 "
    about.call += "and 2; pairs.contacts()"
    about.cause = "Particles have moved or joined the list since the first call. Read the list and "
    about.cause += "the positions again on every call."
    expect_exactly(second, [0, 3, 1, 4, 2, 4], then=INDICES)
    about.call += "; pairs.radius *= 2; pairs.contacts()"
    about.cause = "The detector's radius has changed since the first call. Read it again on every "
    about.cause += "call."
    expect_exactly(third, [0, 1, 0, 3, 1, 2, 1, 4, 2, 4], then=INDICES)


@pytest.mark.exercise("B7.9", asks="in the same cell or in neighboring cells")
def test_spheres_in_neighboring_cells_touch_too(rng: Random) -> None:
    about.read = PAIRS
    radius = positive_number(rng, 0.3, 0.9)
    about.cause = "Two neighbors in the row have no contact. Search all 26 cells around a "
    about.cause += "particle's own cell too."
    for way in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 1, 1), (-1, 1, 1)):
        length = math.hypot(*way)
        step = tuple(1.8 * radius * part / length for part in way)
        places = [tuple((i - 10) * part for part in step) for i in range(21)]
        about.call = f"21 particles in a straight row through (0, 0, 0), each {step} after the "
        about.call += f"previous one; ParticlePairs(particles, radius={radius}).contacts()"
        particles = [Particle(Vector3(*place)) for place in places]
        got = told(ParticlePairs(particles, radius).contacts(), particles)
        seen = [number for a, b, *_ in got for number in (a, b)]
        wanted = [number for i in range(20) for number in (i, i + 1)]
        expect_exactly(seen, wanted, then=INDICES)


@pytest.mark.exercise("B7.9", asks="each pair of spheres that touch or overlap")
def test_a_pile_of_six_holds() -> None:
    about.read = "book 7.3.1, and the docstring of ParticlePairs.contacts"
    about.call = "six spheres (1 kg, radius 0.5 m) stacked on the ground; 12 semi-implicit steps "
    about.call += "of 1/60 s with ParticlePairs(spheres, 0.5).contacts() and ContactResolver(500)"
    about.cause = "The spheres sink into each other. Check that each sphere has a contact with the "
    about.cause += "sphere below it in every step."
    particles = [
        Particle(Vector3(0.0, i + 0.5, 0.0), acceleration=Vector3(0.0, -9.81, 0.0))
        for i in range(6)
    ]
    heights, overlap = piled(
        particles, ParticlePairs(particles, 0.5), ContactResolver(500), 12, 1.0 / 60.0
    )
    wanted = tuple(i + 0.5 for i in range(6))
    # Measured: 0.02 m of overlap at most; 6 % of the diameter is allowed.
    name = "; the final heights of the centers"
    expect_close(heights, wanted, then=name, tolerance=0.06, unit="m")
    name = "; the largest overlap after any step"
    expect_between(overlap, -0.06, 0.06, then=name, unit="m")
