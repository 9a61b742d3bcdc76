"""A firework from its rule, build task B4.4."""

from __future__ import annotations

import itertools
import math
import statistics
from random import Random

import pytest

from ch04_particle_engine import probes
from draw import components
from expect import about, blame, expect_between, expect_close, expect_exactly, scoped

# The book's first rule, without its payload.
FIRST: probes.RuleData = (
    1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ()
)  # fmt: skip
MANY = 400  # draws. Their mean is within 5 standard deviations of the middle
STILL = (0.0, 0.0, 0.0)


@scoped
def rounded_bounds(middle: float, reach: float) -> tuple[int, int]:
    """Return the least and the largest whole number within the reach of the middle."""
    return math.ceil(middle - reach), math.floor(middle + reach)


def expect_even(name: str, drawn: list[float], low: float, high: float) -> None:
    """Expect numbers that were drawn evenly between two limits."""
    __tracebackhide__ = True
    outside = sum(not low <= number <= high for number in drawn)
    expect_exactly(outside, 0, then=f"; how many of {name} are below {low} or above {high}")
    # The standard deviation of the mean of n even draws is their range / sqrt(12 n).
    tolerance = 5.0 * (high - low) / math.sqrt(12.0 * len(drawn))
    middle = (low + high) / 2.0
    mean = math.fsum(drawn) / len(drawn)
    least, most = middle - tolerance, middle + tolerance
    expect_between(mean, least, most, then=f"; the mean of {name}")
    # A quarter of even draws lies in each outer quarter. The standard deviation is sqrt(n 3 / 16).
    quarter = (high - low) / 4.0
    for part, inside in (
        ("lowest", sum(number < low + quarter for number in drawn)),
        ("highest", sum(number > high - quarter for number in drawn)),
    ):
        spread = 5.0 * math.sqrt(len(drawn) * 3.0 / 16.0)
        least, most = rounded_bounds(len(drawn) / 4.0, spread)
        words = f"; how many of {name} are in the {part} quarter of that range"
        expect_between(inside, least, most, then=words)


# B4.4 A firework from its rule


@pytest.mark.exercise("B4.4", asks="are drawn uniformly between the rule's limits")
def test_the_age_is_drawn_between_the_rule_s_limits(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = (
        f"a rule with min_age = 0.5 s and max_age = 1.4 s; random = Random({seed}); "
        f"make_firework(rule, random), called {MANY} times"
    )
    about.cause = (
        "Return a Firework. It takes the type, the age and the particle, in this order, and the "
        "Particle takes its three vectors first."
    )
    about.read = "the docstring of make_firework; book 4.2.2"
    ages = [firework[1] for firework in probes.lit(FIRST, seed, MANY)]
    about.cause = (
        "The ages are not spread evenly between min_age and max_age. Draw a new age for each "
        "firework with random.uniform(min_age, max_age)."
    )
    if all(age == round(age) for age in ages):
        about.cause = (
            "All of your ages are whole numbers of seconds. Draw them with random.uniform, which "
            "returns any number between its two limits."
        )
    elif max(ages) > 1.4 and min(ages) >= 0.5:
        about.cause = (
            "You draw some ages above max_age. If you draw a fraction yourself, multiply it by "
            "max_age - min_age before you add min_age."
        )
    elif min(ages) < 0.5:
        about.cause = (
            "You draw some ages below min_age. Use min_age as the lower limit of random.uniform."
        )
    elif min(ages) == max(ages):
        about.cause = (
            "You give every firework the same age. Draw a new age for each one with "
            "random.uniform(min_age, max_age)."
        )
    expect_even("the ages", ages, 0.5, 1.4)


@pytest.mark.exercise("B4.4", asks="rule's limits, independently of each other")
def test_each_component_of_the_velocity_is_drawn_on_its_own(rng: Random) -> None:
    seed = rng.randrange(10**6)
    low, high = FIRST[3], FIRST[4]
    about.call = (
        f"a rule with velocities from {low} to {high}; random = Random({seed}); "
        f"make_firework(rule, random), called {MANY} times"
    )
    about.read = "the docstring of make_firework; book 4.2.2"
    made = probes.lit(FIRST, seed, MANY)
    columns: dict[str, list[float]] = {}
    for i, axis in enumerate("XYZ"):
        about.cause = (
            "This component of the velocity is not spread evenly between its limits. Draw each "
            "component with random.uniform and the two limits of its own axis."
        )
        columns[axis] = drawn = [firework[5 + i] for firework in made]
        if min(drawn) == max(drawn):
            about.cause = (
                f"You give every firework the same {axis} component of the velocity. Draw it with "
                "random.uniform between the two limits of its axis."
            )
        expect_even(f"the {axis} components of the velocities", drawn, low[i], high[i])
    ages = [firework[1] for firework in made]
    if min(ages) < max(ages):  # another check tests whether ages are drawn at all
        columns["age"] = ages
    for one, other in itertools.combinations(columns, 2):
        pair = f"the {one} and {other} components of the velocity"
        if other == "age":
            pair = f"the {one} component of the velocity and the age"
        about.cause = (
            f"You use the same random number for {pair}. Draw the age and each component "
            "separately."
        )
        correlation = statistics.correlation(columns[one], columns[other])
        # The standard deviation of the correlation of n independent pairs is 1 / sqrt(n).
        tolerance = 5.0 / math.sqrt(MANY)
        name = f"; the correlation between {pair}"
        expect_between(correlation, -tolerance, tolerance, then=name)


@pytest.mark.exercise("B4.4", asks="at one of LAUNCH_PLACES, chosen at random")
def test_a_firework_without_a_parent_starts_at_a_launch_place(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = (
        f"random = Random({seed}); make_firework(rule, random), without a parent, called {MANY} "
        "times"
    )
    about.cause = (
        "A firework without a parent starts on the ground, at y = 0 and z = 0. Choose its x at "
        "random from the three LAUNCH_PLACES, all equally likely."
    )
    about.read = "the docstring of make_firework; book 4.2.3"
    places = [tuple(firework[2:5]) for firework in probes.lit(FIRST, seed, MANY)]
    strange = [place[0] for place in places if place[0] not in (-5.0, 0.0, 5.0)]
    if strange:
        about.cause = (
            f"One of your fireworks starts at x = {strange[0]:.6g}, which is not one of the three "
            "LAUNCH_PLACES. Choose x from them at random."
        )
    elif len({*places}) == 1:
        about.cause = (
            f"All of your fireworks start at x = {places[0][0]:.6g}. Choose x from the three "
            "LAUNCH_PLACES at random."
        )
    for x in (-5.0, 0.0, 5.0):
        # A third is expected, within five standard deviations of sqrt(n 2 / 9).
        spread = 5.0 * math.sqrt(MANY * 2.0 / 9.0)
        found = places.count((x, 0.0, 0.0))
        least, most = rounded_bounds(MANY / 3.0, spread)
        name = f"; the number of fireworks that start at ({x:g}, 0, 0)"
        expect_between(found, least, most, then=name)


@pytest.mark.exercise("B4.4", asks="the velocity of the parent is added")
def test_a_firework_gets_the_position_and_velocity_of_its_parent(rng: Random) -> None:
    seed, x, v, own = rng.randrange(10**6), components(rng), components(rng), components(rng)
    data: probes.RuleData = (3, 1.0, 1.0, own, own, 0.5, ())
    about.call = (
        f"a rule with the velocity {own}; parent = Particle(position=Vector3{x}, "
        f"velocity=Vector3{v}); make_firework(rule, random, parent)"
    )
    about.read = "the docstring of make_firework; book 4.2.3"
    (firework,) = probes.lit(data, seed, 1, (x, v))
    about.cause = (
        "A firework with a parent must start at the position of its parent. Copy that position "
        "instead of choosing from LAUNCH_PLACES."
    )
    expect_close(firework[2:5], x, then=".particle.position", unit="m")
    about.cause = (
        "You leave out the velocity of the parent. Add it to the velocity that you draw from the "
        "rule."
    )
    wanted = tuple(a + b for a, b in zip(v, own, strict=True))
    replaced = (
        "You replace the velocity that you draw by the velocity of the parent. Add the two "
        "velocities."
    )
    blame(firework[5:8], [(v, replaced)])
    expect_close(firework[5:8], wanted, then=".particle.velocity", unit="m/s")
    about.cause = (
        "Your function changes the velocity of the parent, so every later firework of this parent "
        "gets a wrong velocity. Add the two velocities in a new vector."
    )
    family = probes.lit(data, seed, 3, (x, v))
    third = ", called 3 times; the velocity of the third firework"
    expect_close(family[2][5:8], wanted, then=third, unit="m/s")


@pytest.mark.exercise("B4.4", asks="it has a mass of 1 kg, the acceleration GRAVITY")
def test_a_firework_gets_its_type_damping_gravity_and_mass(rng: Random) -> None:
    type, damping = rng.randrange(1, 10), round(rng.uniform(0.1, 0.9), 3)
    data: probes.RuleData = (type, 1.0, 2.0, STILL, STILL, damping, ())
    about.call = (
        f"a rule with type {type} and damping {damping}; firework = make_firework(rule, random)"
    )
    about.read = "the docstring of make_firework"
    for parent in (None, (components(rng), components(rng))):
        (firework,) = probes.lit(data, 1, 1, parent, parent_mass=4.0)
        about.cause = "Your firework does not get the type of its rule. Pass that type to Firework."
        expect_close(firework[0], type, then="; firework.type")
        about.cause = (
            "Your firework does not get the damping of its rule. Pass that damping to the new "
            "Particle."
        )
        expect_close(firework[12], damping, then="; firework.particle.damping")
        about.cause = (
            "Your firework does not get the acceleration GRAVITY, which is (0, -9.81, 0) m/s^2. "
            "Pass GRAVITY to the new Particle."
        )
        gravity, name = (0.0, -9.81, 0.0), "; firework.particle.acceleration"
        expect_close(firework[8:11], gravity, then=name, unit="m/s^2")
        about.cause = "Every firework has a mass of 1 kg. Don't take the mass from the parent."
        expect_close(firework[11], 1.0, then="; firework.particle.mass")


@pytest.mark.exercise("B4.4", asks="with random numbers from random")
def test_every_random_number_comes_from_the_given_generator(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = (
        f"make_firework(rule, random), called 5 times with random = Random({seed}); "
        f"make_firework(rule, random), called 5 more times with a new Random({seed})"
    )
    about.cause = (
        "You draw numbers from another generator, so the fireworks differ although the seed is the "
        "same. Draw every number from the argument random."
    )
    about.read = "the docstring of make_firework"
    once, again = (probes.lit(FIRST, seed, 5) for _ in range(2))
    differ = sum(a != b for a, b in zip(once, again, strict=True))
    name = "; the number of fireworks that differ between the two series"
    expect_exactly(differ, 0, then=name)
    about.call = (
        f"make_firework(rule, random), called 5 times with random = Random({seed}); "
        f"make_firework(rule, random), called 5 more times with random = Random({seed + 1}); the "
        "number of velocities that are the same in both series"
    )
    about.cause = (
        "Your fireworks are the same although the seeds differ. Draw every number from the "
        "argument random, in every call."
    )
    other = probes.lit(FIRST, seed + 1, 5)
    same = sum(a[5:8] == b[5:8] for a, b in zip(once, other, strict=True))
    expect_exactly(same, 0)
