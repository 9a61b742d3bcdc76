"""The tilting platform: B8.6, B8.7, and mini-project 8.1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.scene_probes import rods
from ch08_mass_aggregate.tilting_platform import TiltingPlatform, balancing_mass, rods_of
from draw import Components, number, positive_number
from expect import (
    expect_between,
    expect_close,
    expect_error,
    expect_exactly,
    expect_that,
    named,
    xyz,
)
from rigidity import changed, motions
from unmoved import expect_all_kept

RODS = "the docstring of rods_of"
BALANCE = "the docstring of balancing_mass"
WEIGHT = "the docstring of TiltingPlatform.put_weight"
FREE = "mini-project 8.1, and the docstring of TiltingPlatform.free_pivot"
PLACES = [(x, y, z) for x, y in ((0.0, 0.0), (-3.0, 2.0), (4.0, 2.0)) for z in (-1.0, 1.0)]
MASSES = [math.inf, math.inf, 1.0, 1.0, 1.0, 1.0]
PIVOT = range(6)  # the numbers of its coordinates
SINKS = "x is on the {} side, which sinks, so no mass at x can balance the platform."
LENGTH = "Make a rod as long as its ends are apart: (b.position - a.position).magnitude()."
G, FRAME = 9.81, 1.0 / 60.0


@pytest.mark.exercise("B8.6", asks="it can tilt but not move in any other way", read=RODS)
def test_a_platform_can_only_tilt() -> None:
    likely = "Each rod must join two different particles, both among the six that are passed in."
    with calls(likely, "rods_of(six particles at PLACES)"):
        particles = [Particle(Vector3(*p), mass=m) for p, m in zip(PLACES, MASSES, strict=True)]
        joined = sorted((i, j) for i, j, _ in rods(rods_of(particles), particles))
    strangers = [pair for pair in joined if min(pair) < 0 or pair[0] == pair[1]]
    expect_exactly(len(strangers), 0, then="; the rods that join other particles", unit="rods")
    left = motions(PLACES, joined, PIVOT)
    # The tilt turns all about the axis of the pivot, Z: (x, y) moves along (-y, x).
    tilt = [part for x, y, _ in PLACES for part in (-y, x, 0.0)]
    for motion in left:
        share = math.fsum(a * b for a, b in zip(motion, tilt, strict=True)) / math.hypot(*tilt) ** 2
        rest = [a - share * b for a, b in zip(motion, tilt, strict=True)]
        if math.hypot(*rest) > 1e-9:
            i, j = changed(PLACES, rest)
            why = f"The distance of particles {i} and {j} can still change. Join them with a rod."
            if joined and min(map(min, joined)) > 1:
                why = "No rod joins the platform to its pivot. Leave out a rod only if both of its "
                why += "ends are immovable, not if one of them is."
            name = f", which joins the pairs {', '.join(f'{i}-{j}' for i, j in joined)}; the "
            name += "platform's degrees of freedom, not counting the tilt"
            expect_exactly(len(left) - 1, 0, then=name, cause=why)
    why = "Your rods lock the platform. Remove those that keep it from tilting about its pivot."
    name = "; the platform's degrees of freedom, including the tilt"
    expect_exactly(len(left), 1, then=name, cause=why)


@pytest.mark.exercise("B8.6", asks="is the current distance between its ends", read=RODS)
def test_rods_have_the_right_length(rng: Random) -> None:
    turn, size = positive_number(rng, 0.2, 1.2), positive_number(rng, 0.5, 2.0)
    c, s = size * math.cos(turn), size * math.sin(turn)
    places = [(c * x - s * y, s * x + c * y, z) for x, y, z in PLACES]
    with calls(LENGTH, f"rods_of(six particles at PLACES, times {size}, turned by {turn} rad)"):
        particles = [Particle(Vector3(*p), mass=m) for p, m in zip(places, MASSES, strict=True)]
        made = rods(rods_of(particles), particles)
    expect_all_kept("the position of particle {}", [p.position for p in particles], places)
    none = "Your list of rods is empty. Put the rods that join the particles into it."
    expect_that(len(made) > 0, "no rods", "at least one rod", cause=none)
    same = len(made) > 1 and len({length for *_, length in made}) == 1
    why = f"You give all rods the same length. {LENGTH}" if same else LENGTH
    old = "You compute the length of the rod from PLACES. Use the current positions."
    for i, j, length in made:
        cause = named(length, why, {old: math.dist(PLACES[i], PLACES[j])})
        expect_rod(places, i, j, length, cause)


def expect_rod(places: Sequence[Components], i: int, j: int, length: Any, cause: str) -> None:
    """Expect a rod to be as long as its ends are apart."""
    wanted, name = math.dist(places[i], places[j]), f"; the length of the rod from {i} to {j}"
    expect_close(length, wanted, then=name, unit="m", tolerance=1e-12, cause=cause)


@pytest.mark.exercise("B8.7", asks="Compute the mass in kg that you must place", read=BALANCE)
def test_finds_the_balancing_mass(rng: Random) -> None:
    with calls(
        "The platform balances when the sum of mass times position is 0. The four masses give 2 "
        "kg m, so the new one has to give -2 kg m, and at -3 m that takes 2/3 kg."
    ):
        got = balancing_mass(masses=[1.0] * 4, places=[-3.0, -3.0, 4.0, 4.0], x=-3.0)
    slips = {
        "Your mass has the wrong sign. It should be -(sum of mass times position) / x.": -2.0 / 3.0,
        "You ignore the signs of the positions. Left of the pivot, they are negative.": 14.0 / 3.0,
        "You multiply by g, which is in all torques alike. Leave it out.": 2.0 / 3.0 * G,
        "You return the sum of mass times position, which is not a mass yet. Divide it by -x.": 2.0,
        "You return minus the sum of mass times position. Divide it by x to get a mass.": -2.0,
        "You return the mass that balances the platform at the other end. Divide by x.": 0.5,
    }
    expect_close(got, 2.0 / 3.0, slips, unit="kg")
    masses, places = ([draw(rng) for _ in range(4)] for draw in (positive_number, number))
    turn = math.fsum(m * p for m, p in zip(masses, places, strict=True))
    x = -math.copysign(positive_number(rng), turn)
    more = [number(rng), *places]
    cancels = "On either side of the pivot, the new mass is -(sum of mass times position) / x. "
    cancels += "Masses of 0 kg are valid and add nothing to the sum."
    near = "A mass at x can balance the platform, because x is on the side that rises."
    balanced = "The platform is already balanced, so every x is allowed. Return a mass of 0."
    for some, at, place, wanted, cause in (
        (masses, places, x, -turn / x, cancels),
        ([0.0, *masses], [-place for place in more], -2.0 * x, -0.5 * turn / x, cancels),
        ([1.0], [0.5], -0.25, 2.0, near),
        ([1.0], [-0.5], 0.25, 2.0, near),
        ([1.0], [0.5], -1.0, 0.5, near),
        ([1.0], [-0.5], 1.0, 0.5, near),
        ([2.0, 1.0], [-1.0, 2.0], 5.0, 0.0, balanced),
        ([2.0, 1.0], [-1.0, 2.0], 0.0, 0.0, f"You can't divide by x, which is 0. {balanced}"),
        ([], [], 3.0, 0.0, "There are no masses, so the platform is balanced and the answer is 0."),
    ):  # fmt: skip
        with calls(cause):
            got = balancing_mass(masses=some, places=at, x=place)
        expect_close(got, wanted, unit="kg", tolerance=1e-12 * (1.0 + wanted) if wanted else 0.0)


@pytest.mark.exercise("B8.7", asks="if no mass of 0 or more at x balances", read=BALANCE)
@pytest.mark.robust
def test_rejects_what_cannot_be_balanced() -> None:
    for masses, places, x, cause in (
        ([1.0, 2.0], [-1.0, 2.0], 3.0, "x is on the right side, which sinks, so only a negative "
                                       "mass could balance the platform."),
        ([1.0, 2.0], [1.0, -2.0], -3.0, SINKS.format("left")),
        ([1.0], [0.5], 0.25, SINKS.format("right")),
        ([1.0], [-0.5], -0.25, SINKS.format("left")),
        ([1.0, 2.0], [-1.0, 2.0], 0.0, "A mass at the pivot exerts no torque."),
    ):  # fmt: skip
        expect_error(
            lambda masses=masses, places=places, x=x: balancing_mass(masses, places, x),
            ValueError,
            allowed=lambda: balancing_mass([1.0, 2.0], [-1.0, 2.0], -3.0),
            call=f"balancing_mass(masses={masses}, places={places}, x={x})",
            cause=f"{cause} Raise ValueError.",
        )


def ends(own: float, left: float, right: float) -> list[float]:
    """Return the masses of the ends' four particles, each with half of what its end carries."""
    return [own + 0.5 * share for share in (left, left, right, right)]


@pytest.mark.exercise("B8.7", asks="carries half of the mass at its end", read=WEIGHT)
def test_both_ends_carry_the_weight(rng: Random) -> None:
    four = "; the masses of the four particles at the ends (left, left, right, right)"
    for x in (0.25, -3.0, 4.0, round(rng.uniform(-2.5, 3.5), 3)):
        mass = positive_number(rng)
        with calls(
            "The right end carries mass * (x + 3) / 7, and the left end carries the rest. Give "
            "each of an end's two particles half of that load in addition to its own 1 kg."
        ):
            platform = TiltingPlatform()
            platform.put_weight(mass=mass, x=x)
        got = [particle.mass for particle in platform.particles]
        right = mass * (x + 3.0) / 7.0
        left = mass - right
        slips = {
            "Parentheses are missing, because * and / come before -. Write mass * (x - LEFT) / "
            "(RIGHT - LEFT).": ends(1.0, mass - mass * x - 3.0 / 7.0, mass * x + 3.0 / 7.0),
            "You swapped the loads of the two ends. The end nearer the weight carries more.":
                ends(1.0, right, left),
            "You give each particle the whole load of its end.":
                ends(1.0, 2.0 * left, 2.0 * right),
            "You leave out the particles' own mass. Add MASS to the load of each.":
                ends(0.0, left, right),
            "You halve the particles' own mass too. Add MASS to half of the load of the end.":
                ends(0.5, left, right),
        }  # fmt: skip
        if -3.0 < x < 4.0:  # otherwise, all of these are right
            far = mass * x / (4.0 if x > 0.0 else -3.0)  # by the distance from the pivot
            pivot = "You divide the weight by its distance from the pivot. "
            loads = [(mass - far, far), (0.0, far)]  # of the other end, and of that of the weight
            loads = loads if x > 0.0 else [pair[::-1] for pair in loads]
            slips |= {
                "You put the whole weight on the nearer end. Divide it between both ends.":
                    ends(1.0, mass, 0.0) if x < 0.5 else ends(1.0, 0.0, mass),
                f"{pivot}Take its distances from the two ends.": ends(1.0, *loads[0]),
                f"{pivot}Take its distances from both ends.": ends(1.0, *loads[1]),
            }  # fmt: skip
        wanted = ends(1.0, left, right)
        expect_close(got[2:], wanted, slips, then=four, unit="kg", tolerance=1e-12)
        why = "You also change the masses of the pivot, which must stay immovable."
        name = "; the masses of the pivot's two particles"
        expect_exactly(got[:2], [math.inf, math.inf], then=name, unit="kg", cause=why)
        for first, load, now in ((7.0, mass, wanted), (3.0, 0.0, [1.0] * 4)):
            with calls(
                "You add the new weight to the old one. A new weight replaces the old one, also if "
                "it is 0 kg, so compute the masses from MASS and the new weight alone."
            ):
                platform = TiltingPlatform()
                platform.put_weight(mass=first, x=1.0)
                platform.put_weight(mass=load, x=x)
            got = [particle.mass for particle in platform.particles[2:]]
            expect_close(got, now, then=four, unit="kg", tolerance=1e-12)


@pytest.mark.exercise("B8.7", asks="so that the torque about the pivot is the same", read=WEIGHT)
@pytest.mark.parametrize("side", ["too light", "heavy enough"])
def test_a_platform_tips_at_the_right_weight(rng: Random, side: str) -> None:
    """Only here the weight moves the platform, to the side that the torques say."""
    x = -round(rng.uniform(1.5, 3.0), 3)
    limit = 2.0 / -x  # the ends turn it by 2 kg (4 m - 3 m) to the right
    mass = limit * (1.5 if side == "heavy enough" else 0.5)
    with calls(
        f"The left end should sink if the weight at {x} m is more than {limit:.3f} kg, and rise if "
        "it is less. Check how put_weight divides the mass between the ends.",
        f"platform.put_weight(mass={mass:.6g}, x={x}), then 30 steps of 1/60 s; the left end",
    ):
        platform = TiltingPlatform()
        platform.put_weight(mass, x)
        for _ in range(30):
            platform.step(FRAME)
        left, right = (xyz(platform.particles[i].position) for i in (2, 4))
    seen, wanted = (
        f"{'below' if low else 'above'} the right end"
        for low in (left[1] < right[1], side != "too light")
    )
    expect_that(seen == wanted, seen, wanted)
    why = "Your platform changes its length. Add its rods to world.contact_generators."
    name, long = "; its distance from the right end", math.dist(left, right)
    expect_close(long, 7.0, then=name, unit="m", tolerance=0.01, cause=why)


@pytest.mark.exercise("8.1", asks="Give each of the pivot's two particles", read=FREE)
def test_a_free_pivot_is_like_the_other_particles() -> None:
    six = "; the masses of all particles, of which the first two are the pivot"
    why = "Set the mass of both particles of the pivot to MASS, and leave the others alone."
    for load, wanted in ((1.0, [1.0] * 6), (4.5, [1.0, 1.0, 1.0, 1.0, 4.5, 4.5])):
        with calls(why):
            platform = TiltingPlatform()
            platform.particles[4].mass = platform.particles[5].mass = load
            platform.free_pivot()
        masses = [particle.mass for particle in platform.particles]
        fixed = masses[:2].count(math.inf)
        slip = "You don't change the mass of the pivot. " if fixed else ""
        slip = "You free only one particle of the pivot. " if fixed == 1 else slip
        expect_close(masses, wanted, then=six, unit="kg", tolerance=1e-12, cause=slip + why)
    particles = platform.particles
    moved = "Your free_pivot() moves a particle. It should only change masses and add a rod."
    for i, place in enumerate(PLACES):
        name, got = f"; the position of particle {i}", particles[i].position
        expect_close(got, place, then=name, unit="m", tolerance=0.0, cause=moved)
    in_list = rods(platform.rods, particles)
    generators = [some for some in platform.world.contact_generators if hasattr(some, "length")]
    for where, made in (
        ("platform.rods", in_list),
        ("world.contact_generators", rods(generators, particles)),
    ):
        joined = [(i, j) for i, j, _ in made]
        why = f"{where} has no rod between the pivot's two particles. Add it there too."
        seen, wanted = "no rod joins particles 0 and 1", "a rod joins particles 0 and 1"
        expect_that((0, 1) in joined, seen, wanted, then=f"; the rods in {where}", cause=why)
        # Six motions of a rigid body go where 0 is held, 2 moves along its way there, and 1 in a
        # plane: 0, 1 and 2 are no line.
        left = motions(PLACES, joined, (0, 1, 2, 3, 4, 7))
        why = f"Some rods are missing from {where}. Keep the old ones, and append the new one."
        name = "; the number of independent ways to deform the platform without changing the "
        name += f"length of a rod in {where}"
        expect_exactly(len(left), 0, then=name, unit="ways", cause=why)
    for i, j, length in in_list:
        slip = {"You make the new rod as long as the platform.": 7.0}
        expect_rod(PLACES, i, j, length, named(length, LENGTH, slip))


@pytest.mark.exercise("8.1", asks="The pivot can then slide", read=FREE)
def test_a_free_platform_slides_and_stays_rigid() -> None:
    likely = "Your platform's center of mass moves along X or Z, although the ground has no "
    likely += "friction. Check that free_pivot only changes masses and adds a rod."
    with calls(likely, "platform.free_pivot(), then 45 steps of 1/60 s"):
        platform = TiltingPlatform()
        platform.free_pivot()
        for _ in range(45):
            platform.step(FRAME)
        after = [xyz(particle.position) for particle in platform.particles]
    for axis, name in ((0, "x"), (2, "z")):
        got, wanted = (math.fsum(place[axis] for place in some) / 6.0 for some in (after, PLACES))
        # The impulses of rods are equal and opposite, to rounding, however many there are.
        expect_close(got, wanted, then=f"; {name} of the center of mass", unit="m", tolerance=1e-9)
    off = max(
        abs(math.dist(after[i], after[j]) - math.dist(PLACES[i], PLACES[j]))
        for i, j in combinations(range(6), 2)
    )
    # A hundred iterations leave 0.4 mm with this time step.
    for name, got, low, high, cause in (
        ("the largest change of a distance", off, 0.0, 0.01,
         "Your platform changes its shape, so a rod is missing or has the wrong length."),
        ("how far the pivot moves along X", after[0][0] - PLACES[0][0], -math.inf, -0.01,
         "The pivot should slide to the left. Check that both of its particles can move."),
    ):  # fmt: skip
        expect_between(got, low, high, then=f"; {name}", unit="m", cause=cause)
