"""The tilting platform: B8.6, B8.7, and mini-project 8.1."""

from __future__ import annotations

import math
from itertools import combinations
from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import freed, platform_rods, tipped, weighed
from ch08_mass_aggregate.tilting_platform import balancing_mass
from draw import number, positive_number
from expect import about, blame, cause_of, expect_close, expect_error, expect_exactly
from rigidity import motions, told

RODS = "the docstring of rods_of"
BALANCE = "the docstring of balancing_mass"
WEIGHT = "the docstring of TiltingPlatform.put_weight"
FREE = "mini-project 8.1, and the docstring of TiltingPlatform.free_pivot"
PLACES = [(x, y, z) for x, y in ((0.0, 0.0), (-3.0, 2.0), (4.0, 2.0)) for z in (-1.0, 1.0)]
PIVOT = range(6)  # the numbers of its coordinates


@pytest.mark.exercise("B8.6")
def test_a_platform_can_only_tilt() -> None:
    about("rods_of(six particles at PLACES): motions that the rods allow", read=RODS)
    about.cause = "each rod joins two of the six particles"
    joined = [(i, j) for i, j, _ in platform_rods(PLACES)]
    strangers = [pair for pair in joined if min(pair) < 0 or pair[0] == pair[1]]
    expect_exactly(len(strangers), 0, then=": rods to others")
    left = motions(PLACES, joined, PIVOT)
    # The tilt turns all about the axis of the pivot, Z: (x, y) moves along (-y, x).
    tilt = [part for x, y, _ in PLACES for part in (-y, x, 0.0)]
    size = math.hypot(*tilt)
    for motion in left:
        share = math.fsum(a * b for a, b in zip(motion, tilt, strict=True)) / size**2
        rest = [a - share * b for a, b in zip(motion, tilt, strict=True)]
        if math.hypot(*rest) > 1e-9:
            about.cause = f"besides the tilt, they allow this: {told(rest, 'particle')}"
            expect_exactly(len(left) - 1, 0, then=", besides the tilt")
    about.cause = "the platform must be able to tilt about its pivot"
    expect_exactly(len(left), 1, then=": how many")


@pytest.mark.exercise("B8.6")
def test_rods_are_as_long_as_their_ends_are_apart(rng: Random) -> None:
    about.read = RODS
    turn = positive_number(rng, 0.2, 1.2)
    c, s = math.cos(turn), math.sin(turn)
    size = positive_number(rng, 0.5, 2.0)
    places = [(size * (c * x - s * y), size * (s * x + c * y), z) for x, y, z in PLACES]
    about.call = f"rods_of(six particles at PLACES, {size} times as large, and turned by {turn}): "
    about.call += "lengths"
    about.cause = "a rod's length is the distance of its ends now, (b.position - "
    about.cause += "a.position).magnitude()"
    rods = platform_rods(places)
    expect_exactly(len(rods) > 0, True, then=": is there a rod")
    for i, j, length in rods:
        wanted = math.dist(places[i], places[j])
        old = "that is the distance in PLACES: the particles may be elsewhere by now"
        seen = cause_of(length, [(math.dist(PLACES[i], PLACES[j]), old)], about.cause)
        expect_close(
            length, wanted, then=f" of the one from {i} to {j}", cause=seen, tolerance=1e-12
        )


@pytest.mark.exercise("B8.7")
def test_what_balances_a_platform(rng: Random) -> None:
    about("balancing_mass([1, 1, 1, 1], [-3, -3, 4, 4], -3)", read=BALANCE)
    about.cause = "sum of mass times place, with the new mass in it, is 0: 2 kg m by 3 m"
    got = balancing_mass([1.0] * 4, [-3.0, -3.0, 4.0, 4.0], -3.0)
    mistakes = [
        (-2.0 / 3.0, "the sign: what the new mass turns is opposite to the sum of the others"),
        (14.0 / 3.0, "places have a side: those left of the pivot are negative"),
        (2.0, "that is the sum of mass times place: divide it by how far away x is"),
        (-2.0, "that is the sum of mass times place: divide it by x"),
        (0.5, "that is for a mass at the other end: divide by x, which is -3 m"),
    ]
    blame(got, mistakes)
    expect_close(got, 2.0 / 3.0)
    masses = [positive_number(rng) for _ in range(4)]
    places = [number(rng) for _ in range(4)]
    turn = math.fsum(m * p for m, p in zip(masses, places, strict=True))
    x = -math.copysign(positive_number(rng), turn)
    about(f"balancing_mass({masses}, {places}, {x})", cause="m = -(sum of mass times place) / x")
    got = balancing_mass(masses, places, x)
    expect_close(got, -turn / x, tolerance=1e-12 * (1 - turn / x))
    masses, places, x = [0.0, *masses], [number(rng), *places], -2.0 * x
    about.call = f"balancing_mass({masses}, {places}, {-x}), with the signs of all places turned "
    about.call += "round"
    about.cause = "on either side of the pivot, m = -(sum of mass times place) / x; 0 kg turn "
    about.cause += "nothing"
    got = balancing_mass(masses, [-place for place in places], x)
    expect_close(got, turn / x, tolerance=1e-12 * (1 + turn / x))
    for place, x, wanted in (
        (0.5, -0.25, 2.0),
        (-0.5, 0.25, 2.0),
        (0.5, -1.0, 0.5),
        (-0.5, 1.0, 0.5),
    ):
        about.call = f"balancing_mass([1.0], [{place}], {x})"
        about.cause = "however near the pivot, what is on the other side of it balances"
        got = balancing_mass([1.0], [place], x)
        expect_close(got, wanted)
    for masses, places, x, why in (
        ([2.0, 1.0], [-1.0, 2.0], 5.0, "what is balanced already needs no mass"),
        ([2.0, 1.0], [-1.0, 2.0], 0.0, "what is balanced already needs none at the pivot either"),
        ([], [], 3.0, "nothing is balanced"),
    ):
        about.call = f"balancing_mass({masses}, {places}, {x})"
        got = balancing_mass(masses, places, x)
        expect_close(got, 0.0, cause=why, tolerance=0.0)


@pytest.mark.exercise("B8.7")
@pytest.mark.robust
def test_what_cannot_be_balanced_is_refused() -> None:
    about.read = BALANCE

    def allowed() -> None:
        balancing_mass([1.0, 2.0], [-1.0, 2.0], -3.0)

    for masses, places, x, error, cause in (
        (
            [1.0, 2.0],
            [-1.0, 2.0],
            3.0,
            ValueError,
            "it would have to be -1 kg: a mass on the side that sinks balances nothing",
        ),
        ([1.0, 2.0], [1.0, -2.0], -3.0, ValueError, "on the left side it sinks as well"),
        ([1.0], [0.5], 0.25, ValueError, "near the pivot it is on the side that sinks as well"),
        ([1.0], [-0.5], -0.25, ValueError, "near the pivot it is on the side that sinks as well"),
        ([1.0, 2.0], [-1.0, 2.0], 0.0, ValueError, "a mass at the pivot turns nothing"),
        ([1.0, -2.0], [5.0, 2.0], -3.0, ValueError, "a negative mass is refused"),
        ([1.0, math.nan], [-1.0, 2.0], -3.0, ValueError, "NaN is no mass"),
        ([1.0, 2.0], [-1.0, math.nan], -3.0, ValueError, "NaN is no place"),
        ([1.0, 2.0], [-1.0, math.inf], -3.0, ValueError, "a place must be finite"),
        ([1.0, math.inf], [-1.0, 2.0], -3.0, ValueError, "a mass must be finite"),
        ([1.0, 2.0], [-1.0, 2.0], -math.inf, ValueError, "a place must be finite"),
        ([1.0, 2.0], [-1.0, 2.0], math.nan, ValueError, "NaN is no place"),
        ([2.0, 1.0], [-1.0, 2.0], math.inf, ValueError, "look at x where all is balanced as well"),
        ([1.0, 2.0], [1.0], -3.0, ValueError, "there must be a place for every mass"),
        ([1.0], [-1.0, 2.0], 3.0, ValueError, "there must be a mass for every place"),
        ([1.0, "2"], [-1.0, 2.0], -3.0, TypeError, "a text is no number"),
    ):
        about(f"balancing_mass({masses}, {places}, {x})", cause=cause)
        expect_error(
            lambda masses=masses, places=places, x=x: balancing_mass(masses, places, x),
            error,
            allowed=allowed,
        )


def _masses(own: float, left: float, right: float) -> list[float]:
    """Return the masses of the ends' four particles, each with half of what its end bears."""
    return [own + 0.5 * share for share in (left, left, right, right)]


@pytest.mark.exercise("B8.7")
def test_the_ends_share_a_weight(rng: Random) -> None:
    about.read = WEIGHT
    for x in (-3.0, 4.0, round(rng.uniform(-2.5, 3.5), 3)):
        mass = positive_number(rng)
        about.call = f"platform.put_weight({mass}, {x}): masses of the left end, and of the right "
        about.call += "one"
        about.cause = "the right end bears mass * (x + 3) / 7, the left one the rest; half of it "
        about.cause += "each particle, beside its own 1 kg"
        right = mass * (x + 3.0) / 7.0
        wanted = _masses(1.0, mass - right, right)
        got, _ = weighed([(mass, x)])
        left = mass - right
        near, far = (mass, 0.0) if x < 0.5 else (0.0, mass)
        mistakes = [
            (_masses(1.0, right, left), "the ends are exchanged: the nearer one bears more"),
            (_masses(1.0, 2.0 * left, 2.0 * right), "an end is two particles: half of it for each"),
            (_masses(0.0, left, right), "each particle has its own 1 kg as well"),
            (_masses(1.0, near, far), "the ends share it, by how near they are to it"),
        ]
        blame(got[2:], mistakes, tolerance=2e-3)  # a mass of 0 has become 1 g
        expect_close(got[2:], wanted, tolerance=1e-12)
        about.call = f"platform.put_weight({mass}, {x}): masses of the pivot"
        about.cause = "the ends carry it: the pivot stays immovable"
        expect_exactly(got[:2], [math.inf, math.inf])
        about.call = f"platform.put_weight(7.0, 1.0); put_weight({mass}, {x}): the masses of the "
        about.call += "ends"
        about.cause = "there is one weight: a new one takes the place of the old one"
        got, _ = weighed([(7.0, 1.0), (mass, x)])
        expect_close(got[2:], wanted, tolerance=1e-12)
    about.call = "platform.put_weight(3.0, 1.0); put_weight(0.0, 1.0): the masses of the ends"
    got, _ = weighed([(3.0, 1.0), (0.0, 1.0)])
    expect_close(got[2:], [1.0] * 4, cause="no weight is one of 0 kg")


@pytest.mark.exercise("B8.7")
@pytest.mark.robust
def test_a_weight_that_is_none_is_refused() -> None:
    about.read = WEIGHT
    about.call, about.cause = (
        "platform.put_weight(3.0, 1.0)",
        "a weight of 0 kg or more is none to refuse",
    )
    before, error = weighed([(3.0, 1.0)])
    expect_exactly(error, "", then=": the error, '' for none")
    for mass, x, error in (
        (-1.0, 1.0, "ValueError"),
        (math.nan, 1.0, "ValueError"),
        (math.inf, 1.0, "ValueError"),
        (1.0, -3.0001, "ValueError"),
        (1.0, 4.0001, "ValueError"),
        (1.0, math.nan, "ValueError"),
        ("1", 1.0, "TypeError"),
    ):
        about.call = f"platform.put_weight(3.0, 1.0); put_weight({mass!r}, {x!r})"
        about.cause = "a weight is 0 or more, and x from LEFT to RIGHT"
        got, name = weighed([(3.0, 1.0), (mass, x)])
        expect_exactly(name, error, then=": the error, '' for none")
        about.cause = "look at both arguments before you change a mass: the old weight stays"
        expect_exactly(got, before, then=": the masses")


@pytest.mark.exercise("B8.7")
@pytest.mark.parametrize("side", ["too light", "heavy enough"])
def test_a_platform_tips_at_the_right_weight(rng: Random, side: str) -> None:
    about.read = WEIGHT
    x = -round(rng.uniform(1.5, 3.0), 3)
    limit = 2.0 / -x  # the ends turn it by 2 kg (4 m - 3 m) to the right
    mass = limit * (1.5 if side == "heavy enough" else 0.5)
    about.call = f"platform.put_weight({mass}, {x}); 45 frames of 1/60 s: the left end's height"
    about.cause = f"from {limit:.3f} kg at {x} m on, the left end sinks: mass times place, on both "
    about.cause += "sides"
    places = tipped(mass, x, 45, 1.0 / 60.0)
    sinks = places[2][1] < places[4][1]
    expect_exactly(sinks, side == "heavy enough", then=": is it below the right one")
    length = math.dist(places[2], places[4])
    about.cause = "the platform stays as long as it is: do the world's rods hold it?"
    expect_close(length, 7.0, then=": how long it is, to 1 cm", tolerance=0.01)


@pytest.mark.exercise("8.1")
def test_a_free_pivot_is_like_the_other_particles() -> None:
    about("platform.free_pivot(); the masses of the six particles", read=FREE)
    done = freed(0, 0.1)
    about.cause = "the pivot's two particles, both of them, get MASS: what is immovable does not "
    about.cause += "slide"
    expect_close(done["masses"], [1.0] * 6, tolerance=1e-12)
    about.call = "platform.put_weight(7.0, 4.0); free_pivot(); the masses of the six particles"
    about.cause = "the pivot's two particles get MASS, and the ends bear their weight as before"
    wanted = [1.0, 1.0, 1.0, 1.0, 4.5, 4.5]
    got = freed(0, 0.1, weight=7.0)["masses"]
    expect_close(got, wanted, tolerance=1e-12)
    got = [coordinate for place in done["before"] for coordinate in place]
    wanted = [coordinate for place in PLACES for coordinate in place]
    about.call, about.cause = "platform.free_pivot(); where its particles are", "nothing moves yet"
    expect_close(got, wanted, tolerance=0.0)
    for name in ("rods", "in world"):
        where = "platform.rods" if name == "rods" else "world.contact_generators"
        about.call = f"platform.free_pivot(); motions that the rods of {where} allow, but those of "
        about.call += "a rigid body"
        joined = [(i, j) for i, j, _ in done[name]]
        # Six motions of a rigid body go where 0 is held, 2 moves along its way there, and 1 in a
        # plane: 0, 1 and 2 are no line.
        left = motions(PLACES, joined, (0, 1, 2, 3, 4, 7))
        about.cause = "all rods have to be in both lists, and where none was between the two "
        about.cause += "particles of the pivot, one more"
        if left:
            about.cause = f"they allow this: {told(left[0], 'particle')}; {about.cause}"
        expect_exactly(len(left), 0)
    about.cause = "a rod is as long as its ends are apart"
    for i, j, length in done["rods"]:
        about.call = f"platform.free_pivot(); the length of the rod from {i} to {j}"
        wanted = math.dist(PLACES[i], PLACES[j])
        expect_close(length, wanted, tolerance=1e-12)


@pytest.mark.exercise("8.1")
def test_a_free_platform_slides_and_stays_rigid() -> None:
    about("platform.free_pivot(); 90 frames of 1/120 s", read=FREE)
    about.cause = "nothing pushes it along X or Z, for the ground has no friction: its centre of "
    about.cause += "mass only moves down"
    done = freed(90, 1.0 / 120.0)
    before, after = done["before"], done["after"]
    for axis, name in ((0, "x"), (2, "z")):
        got = math.fsum(place[axis] for place in after) / 6.0
        wanted = math.fsum(place[axis] for place in before) / 6.0
        # The impulses of rods are equal and opposite, to rounding, however many there are.
        expect_close(got, wanted, then=f": {name} of the centre of mass", tolerance=1e-9)
    about.cause = "every distance stays what it was: it is rigid"
    off = max(
        abs(math.dist(after[i], after[j]) - math.dist(before[i], before[j]))
        for i, j in combinations(range(6), 2)
    )
    # A hundred iterations leave 0.2 mm at this frame rate.
    expect_exactly(off < 0.01, True, then=": does no distance change by more than 1 cm")
    moved = after[0][0] - before[0][0]
    about.cause = "it falls to the right, and its pivot slides to the left"
    expect_exactly(moved < -0.01, True, then=": has the pivot moved to the left by more than 1 cm")
