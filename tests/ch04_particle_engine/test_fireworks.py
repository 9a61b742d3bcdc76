"""A firework from its rule, build task B4.4."""

from __future__ import annotations

import itertools
import math
import statistics
from random import Random

import pytest

from calls import calls
from ch04_particle_engine import probes
from ch04_particle_engine.probes import FIRST, STILL
from draw import vector
from expect import expect_between, expect_close, expect_exactly

READ = "the docstring of make_firework"
DRAWN, PARENT = f"{READ}; book 4.2.2", f"{READ}; book 4.2.3"
MANY = 400  # draws. Their mean is within 5 standard deviations of the middle


def expect_count(found: int, share: float, then: str, cause: str) -> None:
    """Expect about this share of MANY draws, within 5 standard deviations."""
    __tracebackhide__ = True
    middle, spread = MANY * share, 5.0 * math.sqrt(MANY * share * (1.0 - share))
    least, most = math.ceil(middle - spread), math.floor(middle + spread)
    expect_between(found, least, most, then=then, cause=cause)


def expect_even(name: str, drawn: list[float], low: float, high: float, cause: str) -> None:
    """Expect MANY numbers that were drawn evenly between two limits."""
    __tracebackhide__ = True
    outside = sum(not low <= number <= high for number in drawn)
    then = f"; how many of {name} are below {low} or above {high}"
    expect_exactly(outside, 0, then=then, cause=cause)
    # The standard deviation of the mean of n even draws is their range / sqrt(12 n).
    middle, tolerance = (low + high) / 2.0, 5.0 * (high - low) / math.sqrt(12.0 * MANY)
    mean, then = math.fsum(drawn) / len(drawn), f"; the mean of {name}"
    expect_between(mean, middle - tolerance, middle + tolerance, then=then, cause=cause)
    # A quarter of even draws lies in each outer quarter.
    quarter = (high - low) / 4.0
    for part, inside in (
        ("lowest", sum(number < low + quarter for number in drawn)),
        ("highest", sum(number > high - quarter for number in drawn)),
    ):
        then = f"; how many of {name} are in the {part} quarter of that range"
        expect_count(inside, 0.25, then, cause)


@pytest.mark.exercise("B4.4", asks="are drawn uniformly between the rule's limits", read=DRAWN)
def test_the_age_is_drawn_between_the_rule_s_limits(rng: Random) -> None:
    seed = rng.randrange(10**6)
    with calls(
        "Return a Firework. It takes the type, the age and the particle, in this order, and the "
        "Particle takes its three vectors first.",
        f"a rule with min_age = 0.5 s and max_age = 1.4 s; random = Random({seed}); "
        f"make_firework(rule, random), called {MANY} times",
    ):
        ages = [firework[1] for firework in probes.lit(FIRST, seed, MANY)]
    draw = "Draw a new age for each firework with random.uniform(min_age, max_age)."
    cause = f"The ages are not spread evenly between min_age and max_age. {draw}"
    if all(age == round(age) for age in ages):
        cause = "All of your ages are whole numbers of seconds. Draw them with random.uniform."
    elif max(ages) > 1.4 and min(ages) >= 0.5:
        cause = f"You draw some ages above max_age. {draw}"
    elif min(ages) < 0.5:
        cause = f"You draw some ages below min_age. {draw}"
    elif min(ages) == max(ages):
        cause = f"You give every firework the same age. {draw}"
    expect_even("the ages", ages, 0.5, 1.4, cause)


@pytest.mark.exercise("B4.4", asks="rule's limits, independently of each other", read=DRAWN)
def test_each_component_of_the_velocity_is_drawn_on_its_own(rng: Random) -> None:
    seed = rng.randrange(10**6)
    low, high = FIRST[3], FIRST[4]
    with calls(
        "Draw each component of the velocity with random.uniform between the two limits of its own "
        "axis.",
        f"a rule with velocities from {low} to {high}; random = Random({seed}); "
        f"make_firework(rule, random), called {MANY} times",
    ):
        made = probes.lit(FIRST, seed, MANY)
    columns: dict[str, list[float]] = {}
    for i, axis in enumerate("XYZ"):
        columns[axis] = drawn = [firework[5 + i] for firework in made]
        how = "not spread evenly between its limits"
        if min(drawn) == max(drawn):
            how = "the same in every firework"
        cause = f"The {axis} component is {how}. Draw each one between the limits of its own axis."
        name = f"the {axis} components of the velocities"
        expect_even(name, drawn, low[i], high[i], cause)
    ages = [firework[1] for firework in made]
    if min(ages) < max(ages):  # another check tests whether ages are drawn at all
        columns["age"] = ages
    for one, other in itertools.combinations(columns, 2):
        pair = f"the {one} and {other} components of the velocity"
        if other == "age":
            pair = f"the {one} component of the velocity and the age"
        # The standard deviation of the correlation of n independent pairs is 1 / sqrt(n).
        tolerance = 5.0 / math.sqrt(MANY)
        expect_between(
            statistics.correlation(columns[one], columns[other]),
            -tolerance,
            tolerance,
            then=f"; the correlation between {pair}",
            cause=f"You use the same random number for {pair}. Draw each of them separately.",
        )


@pytest.mark.exercise("B4.4", asks="at one of LAUNCH_PLACES, chosen at random", read=PARENT)
def test_a_firework_without_a_parent_starts_at_a_launch_place(rng: Random) -> None:
    seed = rng.randrange(10**6)
    cause = "A firework without a parent starts at one of the LAUNCH_PLACES, with y = 0 and z = 0."
    with calls(
        cause,
        f"random = Random({seed}); make_firework(rule, random) without a parent, {MANY} times",
    ):
        places = [tuple(firework[2:5]) for firework in probes.lit(FIRST, seed, MANY)]
    strange = [place[0] for place in places if place[0] not in (-5.0, 0.0, 5.0)]
    if strange:
        cause = f"x = {strange[0]:.6g} is not one of the three LAUNCH_PLACES. Choose x from them."
    elif len({*places}) == 1:
        cause = f"All your fireworks start at x = {places[0][0]:.6g}. Choose x from LAUNCH_PLACES."
    for x in (-5.0, 0.0, 5.0):
        then = f"; the number of fireworks that start at ({x:g}, 0, 0)"
        expect_count(places.count((x, 0.0, 0.0)), 1.0 / 3.0, then, cause)


@pytest.mark.exercise("B4.4", asks="the velocity of the parent is added", read=PARENT)
def test_a_firework_gets_the_position_and_velocity_of_its_parent(rng: Random) -> None:
    seed, x, v, own = rng.randrange(10**6), vector(rng), vector(rng), vector(rng)
    with calls(
        "A firework with a parent must start at the position of its parent. Copy that position "
        "instead of choosing from LAUNCH_PLACES.",
        f"a rule with the velocity {own}; parent = Particle(position=Vector3{x}, "
        f"velocity=Vector3{v}); make_firework(rule, random, parent)",
    ):
        first, _, third = probes.lit(probes.fixed(3, 1.0, own), seed, 3, (x, v))
    expect_close(first[2:5], x, then=".particle.position", unit="m")
    slips = {"You replace the velocity that you draw by the parent's. Add the two velocities.": v}
    added = "You leave out the velocity of the parent. Add it to the velocity from the rule."
    then = ".particle.velocity"
    expect_close(first[5:8], v + own, slips, then=then, unit="m/s", cause=added)
    changed = "Your function changes the parent's velocity. Add the two velocities in a new vector."
    then = ", called 3 times; the velocity of the third firework"
    expect_close(third[5:8], v + own, then=then, unit="m/s", cause=changed)


@pytest.mark.exercise("B4.4", asks="it has a mass of 1 kg, the acceleration GRAVITY", read=READ)
def test_a_firework_gets_its_type_damping_gravity_and_mass(rng: Random) -> None:
    type, damping = rng.randrange(1, 10), round(rng.uniform(0.1, 0.9), 3)
    for parent in (None, (vector(rng), vector(rng))):
        with calls(
            "Your firework does not get the type of its rule. Pass that type to Firework.",
            f"a rule of type {type}, damping {damping}; firework = make_firework(rule, random)",
        ):
            rule = (type, 1.0, 2.0, STILL, STILL, damping, ())
            (firework,) = probes.lit(rule, 1, 1, parent, parent_mass=4.0)
        expect_close(firework[0], type, then="; firework.type")
        for field, got, wanted, unit, cause in (
            ("damping", firework[12], damping, "",
             "Your firework does not get the damping of its rule. Pass it to the new Particle."),
            ("acceleration", firework[8:11], (0.0, -9.81, 0.0), "m/s^2",
             "Your firework does not get the acceleration GRAVITY. Pass it to the new Particle."),
            ("mass", firework[11], 1.0, "",
             "Every firework has a mass of 1 kg. Don't take the mass from the parent."),
        ):  # fmt: skip
            then = f"; firework.particle.{field}"
            expect_close(got, wanted, then=then, unit=unit, cause=cause)


@pytest.mark.exercise("B4.4", asks="with random numbers from random", read=READ)
def test_every_random_number_comes_from_the_given_generator(rng: Random) -> None:
    seed = rng.randrange(10**6)
    first = f"make_firework(rule, random), called 5 times with random = Random({seed})"
    with calls(
        "You draw numbers from another generator, so the fireworks differ although the seed is the "
        "same. Draw every number from the argument random.",
        f"{first}; make_firework(rule, random), called 5 more times with a new Random({seed})",
    ):
        once, again, other = (probes.lit(FIRST, s, 5) for s in (seed, seed, seed + 1))
    differ = sum(a != b for a, b in zip(once, again, strict=True))
    then = "; the number of fireworks that differ between the two series"
    expect_exactly(differ, 0, then=then)
    expect_exactly(
        sum(a[5:8] == b[5:8] for a, b in zip(once, other, strict=True)),
        0,
        call=f"{first}; make_firework(rule, random), called 5 more times with random = "
        f"Random({seed + 1}); the number of velocities that are the same in both series",
        cause="Your fireworks don't depend on the seed. Draw every number from random.",
    )
