"""The tilting platform: B8.6, B8.7, and mini-project 8.1."""

from __future__ import annotations

import math
from itertools import combinations
from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import freed, places_after, platform_rods, tipped, weighed
from ch08_mass_aggregate.tilting_platform import balancing_mass
from draw import number, positive_number
from expect import (
    about,
    blame,
    cause_of,
    expect_between,
    expect_close,
    expect_error,
    expect_exactly,
    expect_that,
)
from rigidity import changed, motions
from unmoved import expect_all_kept

RODS = "the docstring of rods_of"
BALANCE = "the docstring of balancing_mass"
WEIGHT = "the docstring of TiltingPlatform.put_weight"
FREE = "mini-project 8.1, and the docstring of TiltingPlatform.free_pivot"
PLACES = [(x, y, z) for x, y in ((0.0, 0.0), (-3.0, 2.0), (4.0, 2.0)) for z in (-1.0, 1.0)]
G = 9.81  # m/s^2
PIVOT = range(6)  # the numbers of its coordinates


@pytest.mark.exercise("B8.6", asks="it can tilt but not move in any other way")
def test_a_platform_can_only_tilt() -> None:
    about("rods_of(six particles at PLACES)", read=RODS)
    about.cause = "Each rod must join two different particles, both among the six that are passed "
    about.cause += "in. Its length is a number."
    joined = [(i, j) for i, j, _ in platform_rods(PLACES)]
    strangers = [pair for pair in joined if min(pair) < 0 or pair[0] == pair[1]]
    expect_exactly(len(strangers), 0, then="; the rods that join other particles", unit="rods")
    left = motions(PLACES, joined, PIVOT)
    # The tilt turns all about the axis of the pivot, Z: (x, y) moves along (-y, x).
    tilt = [part for x, y, _ in PLACES for part in (-y, x, 0.0)]
    size = math.hypot(*tilt)
    for motion in left:
        share = math.fsum(a * b for a, b in zip(motion, tilt, strict=True)) / size**2
        rest = [a - share * b for a, b in zip(motion, tilt, strict=True)]
        if math.hypot(*rest) > 1e-9:
            i, j = changed(PLACES, rest)
            about.cause = f"The distance between particles {i} and {j} can still change, so the "
            about.cause += "platform can bend. Join these two particles with a rod."
            if joined and min(map(min, joined)) > 1:
                about.cause = "No rod joins the platform to its pivot. Leave out a rod only if "
                about.cause += "both of its ends are immovable, not if one of them is."
            pairs = ", ".join(f"{i}-{j}" for i, j in sorted(joined))
            about.call = f"rods_of(six particles at PLACES), which joins the pairs {pairs}; the "
            about.call += "platform's degrees of freedom, not counting the tilt"
            expect_exactly(len(left) - 1, 0)
    about.cause = "Your rods lock the platform. Remove those that keep it from tilting about its "
    about.cause += "pivot."
    expect_exactly(len(left), 1, then="; the platform's degrees of freedom, including the tilt")


@pytest.mark.exercise("B8.6", asks="is the current distance between its ends")
def test_rods_have_the_right_length(rng: Random) -> None:
    about.read = RODS
    turn = positive_number(rng, 0.2, 1.2)
    c, s = math.cos(turn), math.sin(turn)
    size = positive_number(rng, 0.5, 2.0)
    places = [(size * (c * x - s * y), size * (s * x + c * y), z) for x, y, z in PLACES]
    about.call = f"rods_of(six particles at PLACES, scaled by {size} and rotated by {turn} rad)"
    about.cause = "Your rod has the wrong length. It should be (b.position - "
    about.cause += "a.position).magnitude()."
    expect_all_kept("the position of particle {}", places_after("platform", places), places)
    rods = platform_rods(places)
    none = "Your list of rods is empty. Put the rods that join the particles into it."
    expect_that(len(rods) > 0, "no rods", "at least one rod", cause=none)
    if len(rods) > 1 and len({length for *_, length in rods}) == 1:
        about.cause = "You give all rods the same length. Make each rod as long as the current "
        about.cause += "distance between its two ends."
    for i, j, length in rods:
        wanted = math.dist(places[i], places[j])
        old = "You compute the length of the rod from PLACES, but the particles are somewhere "
        old += "else. Use their current positions."
        seen = cause_of(length, [(math.dist(PLACES[i], PLACES[j]), old)], about.cause)
        expect_close(
            length,
            wanted,
            then=f"; the length of the rod from particle {i} to particle {j}",
            unit="m",
            cause=seen,
            tolerance=1e-12,
        )


@pytest.mark.exercise("B8.7", asks="Compute the mass in kg that you must place")
def test_finds_the_balancing_mass(rng: Random) -> None:
    about(
        "four masses of 1 kg at -3, -3, 4 and 4 m; balancing_mass([1, 1, 1, 1], [-3, -3, 4, 4], "
        "-3)",
        read=BALANCE,
    )
    about.cause = "The platform balances when the sum of mass times position is 0. The four masses "
    about.cause += "give 2 kg m, so the new one has to give -2 kg m, and at -3 m that takes 2/3 kg."
    got = balancing_mass([1.0] * 4, [-3.0, -3.0, 4.0, 4.0], -3.0)
    mistakes = [
        (-2.0 / 3.0,
         "Your mass has the wrong sign. It should be -(sum of mass times position) / x."),
        (14.0 / 3.0, "You ignore the signs of the positions. Keep them, because positions to the "
                     "left of the pivot are negative."),
        (2.0 / 3.0 * G, "You multiply by g, which is in all torques alike. Leave it out."),
        (2.0, "You return the sum of mass times position, which is not a mass yet. Divide it by "
              "-x."),
        (-2.0, "You return minus the sum of mass times position. Divide it by x to get a mass."),
        (0.5, "You return the mass that balances the platform at the other end. Divide by x, which "
              "is -3 m."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, 2.0 / 3.0, unit="kg")
    masses = [positive_number(rng) for _ in range(4)]
    places = [number(rng) for _ in range(4)]
    turn = math.fsum(m * p for m, p in zip(masses, places, strict=True))
    x = -math.copysign(positive_number(rng), turn)
    about(
        f"balancing_mass(masses={masses}, places={places}, x={x})",
        cause="The platform balances when the new mass cancels the torque of the others, so it is "
        "-(sum of mass times position) / x.",
    )
    got = balancing_mass(masses, places, x)
    expect_close(got, -turn / x, unit="kg", tolerance=1e-12 * (1 - turn / x))
    masses, places, x = [0.0, *masses], [number(rng), *places], -2.0 * x
    about.call = f"balancing_mass(masses={masses}, places={[-place for place in places]}, x={x})"
    about.cause = "On either side of the pivot, the new mass is -(sum of mass times position) / x. "
    about.cause += "Masses of 0 kg are valid and add nothing to the sum."
    got = balancing_mass(masses, [-place for place in places], x)
    expect_close(got, turn / x, unit="kg", tolerance=1e-12 * (1 + turn / x))
    for place, x, wanted in (
        (0.5, -0.25, 2.0),
        (-0.5, 0.25, 2.0),
        (0.5, -1.0, 0.5),
        (-0.5, 1.0, 0.5),
    ):
        about.call = f"balancing_mass(masses=[1.0], places=[{place}], x={x})"
        about.cause = "A mass at x can balance the platform, because x is on the side that rises. "
        about.cause += "That is true even very close to the pivot, so don't raise an error."
        got = balancing_mass([1.0], [place], x)
        expect_close(got, wanted, unit="kg")
    for masses, places, x, why in (
        ([2.0, 1.0], [-1.0, 2.0], 5.0, "The platform is already balanced, so every x is allowed. "
         "Return a mass of 0."),
        ([2.0, 1.0], [-1.0, 2.0], 0.0, "You can't divide by x, which is 0. The platform is already "
        "balanced, so return a mass of 0 before you divide."),
        ([], [], 3.0, "There are no masses, so the platform is balanced and the answer is 0."),
    ):  # fmt: skip
        about(f"balancing_mass(masses={masses}, places={places}, x={x})", cause=why)
        got = balancing_mass(masses, places, x)
        expect_close(got, 0.0, unit="kg", tolerance=0.0)


@pytest.mark.exercise("B8.7", asks="if no mass of 0 or more at x balances")
@pytest.mark.robust
def test_rejects_what_cannot_be_balanced() -> None:
    about.read = BALANCE

    def allowed() -> None:
        balancing_mass([1.0, 2.0], [-1.0, 2.0], -3.0)

    for masses, places, x, cause in (
        ([1.0, 2.0], [-1.0, 2.0], 3.0, "x is on the right side, which sinks, so only a "
         "negative mass could balance the platform. Raise ValueError."),
        ([1.0, 2.0], [1.0, -2.0], -3.0, "x is on the left side, which sinks, so no "
         "mass at x can balance the platform. Raise ValueError."),
        ([1.0], [0.5], 0.25, "x is on the right side, which sinks, so no mass at x can "
         "balance the platform. Raise ValueError."),
        ([1.0], [-0.5], -0.25, "x is on the left side, which sinks, so no mass at x "
         "can balance the platform. Raise ValueError."),
        ([1.0, 2.0], [-1.0, 2.0], 0.0, "A mass at the pivot exerts no torque, so it "
                                                   "can't balance anything. Raise ValueError."),
    ):  # fmt: skip
        about(f"balancing_mass(masses={masses}, places={places}, x={x})", cause=cause)
        expect_error(
            lambda masses=masses, places=places, x=x: balancing_mass(masses, places, x),
            ValueError,
            allowed=allowed,
        )


def _masses(own: float, left: float, right: float) -> list[float]:
    """Return the masses of the ends' four particles, each with half of what its end carries."""
    return [own + 0.5 * share for share in (left, left, right, right)]


@pytest.mark.exercise("B8.7", asks="carries half of the mass at its end")
def test_both_ends_carry_the_weight(rng: Random) -> None:
    about.read = WEIGHT
    for x in (0.25, -3.0, 4.0, round(rng.uniform(-2.5, 3.5), 3)):
        mass = positive_number(rng)
        about.call = f"platform.put_weight(mass={mass}, x={x}); the masses of the four particles "
        about.call += "at the ends (left, left, right, right)"
        about.cause = "The right end carries mass * (x + 3) / 7, and the left end carries the "
        about.cause += "rest. Give each of an end's two particles half of that load in addition to "
        about.cause += "its own 1 kg."
        right = mass * (x + 3.0) / 7.0
        wanted = _masses(1.0, mass - right, right)
        got, _ = weighed([(mass, x)])
        left = mass - right
        near, far = (mass, 0.0) if x < 0.5 else (0.0, mass)
        part = mass * x / (4.0 if x > 0.0 else -3.0)  # the distance from the pivot, as a fraction
        others = ((mass - part, part), (0.0, part))  # the load of the other end
        others = others if x > 0.0 else [pair[::-1] for pair in others]
        mistakes = [
            (_masses(1.0, mass - mass * x - 3.0 / 7.0, mass * x + 3.0 / 7.0),
             "Parentheses are missing, because * and / come before -. Write mass * (x - LEFT) / "
             "(RIGHT - LEFT)."),
            (_masses(1.0, right, left), "You swapped the loads of the two ends. The end nearer "
                                        "the weight carries more."),
            (_masses(1.0, 2.0 * left, 2.0 * right), "You give each particle the whole load of its "
                                                    "end. Each end has two particles, so give each "
                                                    "of them half."),
            (_masses(0.0, left, right), "You leave out the particles' own mass. Add MASS to the "
                                        "load that each particle carries."),
            (_masses(0.5, left, right), "You halve the particles' own mass too. Add MASS to "
                                        "half of the load of the end."),
        ]  # fmt: skip
        if -3.0 < x < 4.0:  # otherwise, all of these are right
            mistakes.append(
                (
                    _masses(1.0, near, far),
                    "You put the whole weight on the nearer end. Divide it "
                    "between both ends: the closer it is to an end, the more that end carries.",
                )
            )
            mistakes += [
                (
                    _masses(1.0, *pair),
                    "You divide the weight by its distance from the "
                    "pivot. Take its distances from the two ends.",
                )
                for pair in others
            ]
        blame(got[2:], mistakes, tolerance=2e-3)  # a mass of 0 has become 1 g
        expect_close(got[2:], wanted, unit="kg", tolerance=1e-12)
        about.call = f"platform.put_weight(mass={mass}, x={x}); the masses of the pivot's two "
        about.call += "particles"
        about.cause = "You also change the masses of the pivot, which must stay immovable. Change "
        about.cause += "only the masses of the ends."
        expect_exactly(got[:2], [math.inf, math.inf], unit="kg")
        about.call = f"platform.put_weight(mass=7, x=1); platform.put_weight(mass={mass}, x={x}); "
        about.call += "the masses of the four particles at the ends (left, left, right, right)"
        about.cause = "You add the new weight to the old one. It should replace the old one, so "
        about.cause += "compute the masses from MASS and the new weight alone."
        got, _ = weighed([(7.0, 1.0), (mass, x)])
        expect_close(got[2:], wanted, unit="kg", tolerance=1e-12)
    about.call = "platform.put_weight(mass=3, x=1); platform.put_weight(mass=0, x=1); the masses "
    about.call += "of the four particles at the ends"
    got, _ = weighed([(3.0, 1.0), (0.0, 1.0)])
    expect_close(
        got[2:],
        [1.0] * 4,
        cause="The old weight still counts. A weight of 0 kg replaces it, so each particle at "
        "the ends must have only its own mass again.",
    )


@pytest.mark.exercise("B8.7", asks="so that the torque about the pivot is the same")
@pytest.mark.parametrize("side", ["too light", "heavy enough"])
def test_a_platform_tips_at_the_right_weight(rng: Random, side: str) -> None:
    x = -round(rng.uniform(1.5, 3.0), 3)
    limit = 2.0 / -x  # the ends turn it by 2 kg (4 m - 3 m) to the right
    mass = limit * (1.5 if side == "heavy enough" else 0.5)
    about(
        f"platform.put_weight(mass={mass:.6g}, x={x}), then 30 steps of 1/60 s; the left end",
        read=WEIGHT,
    )
    about.cause = (
        f"The left end should sink if the weight at {x} m is more than {limit:.3f} kg, and rise if "
        "it is less. Check how put_weight divides the mass between the ends."
    )
    places = tipped(mass, x, 30, 1.0 / 60.0)
    sinks = places[2][1] < places[4][1]
    seen, right = (
        f"{'below' if low else 'above'} the right end" for low in (sinks, side != "too light")
    )
    expect_that(seen == right, seen, right)
    length = math.dist(places[2], places[4])
    about.cause = "The length of your platform changes, because its rods have no effect. Add the "
    about.cause += "rods to the world's contact generators."
    expect_close(length, 7.0, then="; its distance from the right end", unit="m", tolerance=0.01)


@pytest.mark.exercise("8.1", asks="Give each of the pivot's two particles")
def test_a_free_pivot_is_like_the_other_particles() -> None:
    about(
        "platform.free_pivot(); the masses of all particles, of which the first two are the pivot",
        read=FREE,
    )
    done = freed(0, 0.1)
    about.cause = "You don't change the mass of the pivot. Set the mass of both particles to MASS."
    if done["masses"][:2].count(math.inf) == 1:
        about.cause = "You free only one particle of the pivot. Set the mass of both to MASS."
    elif math.inf not in done["masses"][:2]:
        about.cause = "The mass of each particle should be MASS, which is 1 kg. Set the masses of "
        about.cause += "the pivot to it, and leave the others alone."
    expect_close(done["masses"], [1.0] * 6, unit="kg", tolerance=1e-12)
    about.call = "platform.put_weight(mass=7, x=4), then free_pivot(); the masses of the six "
    about.call += "particles"
    about.cause = "Your free_pivot() changes the load that the ends carry. Change only the masses "
    about.cause += "of the two particles of the pivot."
    wanted = [1.0, 1.0, 1.0, 1.0, 4.5, 4.5]
    got = freed(0, 0.1, weight=7.0)["masses"]
    expect_close(got, wanted, unit="kg", tolerance=1e-12)
    got = [coordinate for place in done["before"] for coordinate in place]
    wanted = [coordinate for place in PLACES for coordinate in place]
    about(
        "platform.free_pivot(); the positions of its particles",
        cause="Your free_pivot() moves a particle. It should only change masses and add a rod, "
        "because the next step moves the platform.",
    )
    expect_close(got, wanted, unit="m", tolerance=0.0)
    for name in ("rods", "in world"):
        where = "platform.rods" if name == "rods" else "world.contact_generators"
        about.call = (
            "platform.free_pivot(); the number of independent ways to deform the platform without "
            f"changing the length of a rod in {where}"
        )
        joined = [(i, j) for i, j, _ in done[name]]
        # Six motions of a rigid body go where 0 is held, 2 moves along its way there, and 1 in a
        # plane: 0, 1 and 2 are no line.
        left = motions(PLACES, joined, (0, 1, 2, 3, 4, 7))
        about.cause = f"Some rods are missing from {where}. Keep all of the old rods, and "
        about.cause += "append the new one."
        axle = f"{where} has no rod between the pivot's two particles. Add it there too."
        seen, wanted_rod = "no rod joins particles 0 and 1", "a rod joins particles 0 and 1"
        call = f"platform.free_pivot(); the rods in {where}"
        expect_that((0, 1) in joined, seen, wanted_rod, call=call, cause=axle)
        expect_exactly(len(left), 0, unit="ways")
    for i, j, length in done["rods"]:
        about.cause = "Your rod has the wrong length. Make it as long as the distance between its "
        about.cause += "ends."
        blame(length, [(7.0, "You make the new rod as long as the platform. Make it as long as the "
                             "distance between its two ends.")])  # fmt: skip
        about.call = f"platform.free_pivot(); the length of the rod from particle {i} to particle "
        about.call += f"{j}"
        wanted = math.dist(PLACES[i], PLACES[j])
        expect_close(length, wanted, unit="m", tolerance=1e-12)


@pytest.mark.exercise("8.1", asks="The pivot can then slide")
def test_a_free_platform_slides_and_stays_rigid() -> None:
    about("platform.free_pivot(), then 45 steps of 1/60 s", read=FREE)
    about.cause = "Your platform's center of mass moves along X or Z, although the ground has no "
    about.cause += "friction. Check that free_pivot only changes masses and adds a rod."
    done = freed(45, 1.0 / 60.0)
    before, after = done["before"], done["after"]
    for axis, name in ((0, "x"), (2, "z")):
        got = math.fsum(place[axis] for place in after) / 6.0
        wanted = math.fsum(place[axis] for place in before) / 6.0
        # The impulses of rods are equal and opposite, to rounding, however many there are.
        expect_close(got, wanted, then=f"; {name} of the center of mass", unit="m", tolerance=1e-9)
    about.cause = (
        "Your platform changes its shape, so a rod is missing or has the wrong length. Together "
        "the rods should keep every distance between two particles the same."
    )
    off = max(
        abs(math.dist(after[i], after[j]) - math.dist(before[i], before[j]))
        for i, j in combinations(range(6), 2)
    )
    # A hundred iterations leave 0.4 mm with this time step.
    expect_between(off, 0.0, 0.01, then="; the largest change of a distance", unit="m")
    moved = after[0][0] - before[0][0]
    about.cause = (
        "The platform falls to the right, so its pivot should slide to the left along the ground. "
        "Check that both particles of the pivot can move."
    )
    expect_between(moved, -math.inf, -0.01, then="; how far the pivot moves along X", unit="m")
