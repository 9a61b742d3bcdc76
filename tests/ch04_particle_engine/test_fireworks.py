"""A firework from its rule, B4.4, and the slots of a show, B4.5."""

from __future__ import annotations

import itertools
import math
import statistics
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from draw import components
from expect import about, expect_between, expect_close, expect_error, expect_exactly, scoped

# The book's first rule, without its payload.
FIRST: probes.RuleData = (
    1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ()
)  # fmt: skip
MANY = 400  # draws. Their mean is within 5 standard deviations of the middle
STILL = (0.0, 0.0, 0.0)


def simple(type: int, *payloads: tuple[int, int]) -> probes.RuleData:
    """Return a rule without randomness: 2 s, straight up."""
    return (type, 2.0, 2.0, (0.0, 9.0, 0.0), (0.0, 9.0, 0.0), 1.0, payloads)


def show(capacity: int, when_full: str, types: int = 4) -> Any:
    """Return a show with rules of the types 1 to 4 without payloads."""
    rules = [simple(type) for type in range(1, types + 1)]
    return probes.show_of(rules, capacity, when_full, 1)


def burning(a_show: Any) -> list[int]:
    """Return the types that burn, oldest first."""
    return [firework.type for firework in a_show.fireworks]


@scoped
def rounded_bounds(middle: float, reach: float) -> tuple[int, int]:
    """Return the least and the largest whole number within the reach of the middle."""
    return math.ceil(middle - reach), math.floor(middle + reach)


def expect_even(call: str, drawn: list[float], low: float, high: float) -> None:
    """Expect numbers that were drawn evenly between two limits."""
    about.call = call
    __tracebackhide__ = True
    outside = sum(not low <= number <= high for number in drawn)
    expect_exactly(outside, 0, then=f": how many of {len(drawn)} are outside {low} to {high}")
    # The standard deviation of the mean of n even draws is their range / sqrt(12 n).
    tolerance = 5.0 * (high - low) / math.sqrt(12.0 * len(drawn))
    middle = (low + high) / 2.0
    mean = math.fsum(drawn) / len(drawn)
    least, most = middle - tolerance, middle + tolerance
    expect_between(mean, least, most, then=f": the mean of {len(drawn)}")
    # A quarter of even draws lies in each outer quarter. The standard deviation is sqrt(n 3 / 16).
    quarter = (high - low) / 4.0
    for part, inside in (
        ("lowest", sum(number < low + quarter for number in drawn)),
        ("highest", sum(number > high - quarter for number in drawn)),
    ):
        spread = 5.0 * math.sqrt(len(drawn) * 3.0 / 16.0)
        least, most = rounded_bounds(len(drawn) / 4.0, spread)
        name = f": how many of {len(drawn)} are in the {part} quarter"
        expect_between(inside, least, most, then=name)


# B4.4 A firework from its rule


@pytest.mark.exercise("B4.4")
def test_the_age_is_drawn_between_the_rule_s_limits(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = f"make_firework(rule, Random({seed})).age, min_age=0.5, max_age=1.4"
    about.cause = "Draw random.uniform(min_age, max_age) for each firework."
    about.read = "the docstring of make_firework; book 4.2.1"
    ages = [firework[1] for firework in probes.lit(FIRST, seed, MANY)]
    expect_even(about.call, ages, 0.5, 1.4)


@pytest.mark.exercise("B4.4")
def test_each_component_of_the_velocity_is_drawn_on_its_own(rng: Random) -> None:
    seed = rng.randrange(10**6)
    low, high = FIRST[3], FIRST[4]
    about.call = f"make_firework(rule, Random({seed})).particle.velocity, from {low} to {high}"
    about.read = "the docstring of make_firework; book 4.2.1"
    made = probes.lit(FIRST, seed, MANY)
    columns = {}
    for i, axis in enumerate("XYZ"):
        about.cause = "Draw random.uniform(min, max) with the limits of this axis."
        columns[axis] = [firework[5 + i] for firework in made]
        expect_even(f"{about.call}, on {axis}", columns[axis], low[i], high[i])
    ages = [firework[1] for firework in made]
    if min(ages) < max(ages):  # another check tests whether ages are drawn at all
        columns["the age"] = ages
    about.cause = (
        "One random number was used for several quantities. Draw each component and the age "
    )
    about.cause += "separately."
    for one, other in itertools.combinations(columns, 2):
        correlation = statistics.correlation(columns[one], columns[other])
        # The standard deviation of the correlation of n independent pairs is 1 / sqrt(n).
        tolerance = 5.0 / math.sqrt(MANY)
        name = f": correlation of {one} and {other}"
        expect_between(correlation, -tolerance, tolerance, then=name)


@pytest.mark.exercise("B4.4")
def test_without_a_parent_it_starts_on_the_ground_at_one_of_three_places(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = f"make_firework(rule, Random({seed})).particle.position"
    about.cause = "Choose x from LAUNCH_PLACES, each with the same probability. y and z are 0."
    about.read = "the docstring of make_firework; book 4.2.3"
    places = [tuple(firework[2:5]) for firework in probes.lit(FIRST, seed, MANY)]
    for x in (-5.0, 0.0, 5.0):
        # A third is expected, within five standard deviations of sqrt(n 2 / 9).
        spread = 5.0 * math.sqrt(MANY * 2.0 / 9.0)
        found = places.count((x, 0.0, 0.0))
        least, most = rounded_bounds(MANY / 3.0, spread)
        name = f": how many of {MANY} are at ({x}, 0, 0)"
        expect_between(found, least, most, then=name)


@pytest.mark.exercise("B4.4")
def test_a_parent_gives_its_place_and_adds_its_velocity(rng: Random) -> None:
    seed, x, v, own = rng.randrange(10**6), components(rng), components(rng), components(rng)
    data: probes.RuleData = (3, 1.0, 1.0, own, own, 0.5, ())
    about.call = f"make_firework(rule, random, Particle(Vector3{x}, Vector3{v})), velocities of "
    about.call += f"{own}"
    about.read = "the docstring of make_firework; book 4.2.3"
    (firework,) = probes.lit(data, seed, 1, (x, v))
    about.cause = "A firework with a parent must start at the parent's position."
    expect_close(firework[2:5], x, then=".particle.position")
    about.cause = "The velocity is the drawn one plus the parent's."
    wanted = tuple(a + b for a, b in zip(v, own, strict=True))
    expect_close(firework[5:8], wanted, then=".particle.velocity")
    about.cause = (
        "The parent was changed. Copy its vectors, because one parent can have many children."
    )
    family = probes.lit(data, seed, 3, (x, v))
    expect_close(family[2][5:8], wanted, then=", the third")


@pytest.mark.exercise("B4.4")
def test_its_type_and_damping_are_the_rule_s_and_gravity_pulls_at_a_kilogram(rng: Random) -> None:
    type, damping = rng.randrange(1, 10), round(rng.uniform(0.1, 0.9), 3)
    data: probes.RuleData = (type, 1.0, 2.0, STILL, STILL, damping, ())
    about.call = f"make_firework(rule, random), type {type} and damping {damping}"
    about.read = "the docstring of make_firework"
    for parent in (None, (components(rng), components(rng))):
        (firework,) = probes.lit(data, 1, 1, parent, parent_mass=4.0)
        about.cause = "Use the type and the damping of the rule."
        expect_close(firework[0], type, then="; its type")
        expect_close(firework[12], damping, then="; its damping")
        about.cause = "Every firework has mass 1 and the acceleration GRAVITY, (0, -9.81, 0)."
        gravity = (0.0, -9.81, 0.0)
        expect_close(firework[8:11], gravity, then="; acceleration")
        expect_close(firework[11], 1.0, then="; its mass")


@pytest.mark.exercise("B4.4")
def test_all_that_is_drawn_comes_from_the_random_that_is_given(rng: Random) -> None:
    seed = rng.randrange(10**6)
    about.call = f"make_firework(rule, Random({seed})) 5 times, and all of it again"
    about.cause = "Draw from the argument random, not from the module, so that a seed repeats a "
    about.cause += "show."
    about.read = "the docstring of make_firework"
    once, again = (probes.lit(FIRST, seed, 5) for _ in range(2))
    differ = sum(a != b for a, b in zip(once, again, strict=True))
    expect_exactly(differ, 0, then=": how many fireworks differ")
    about.call = f"make_firework(rule, Random({seed})) and with Random({seed + 1}): how many "
    about.call += "velocities are equal"
    about.cause = "A different seed must give different numbers."
    other = probes.lit(FIRST, seed + 1, 5)
    same = sum(a[5:8] == b[5:8] for a, b in zip(once, other, strict=True))
    expect_exactly(same, 0)


# B4.5 Slots, and what happens when they are full


@pytest.mark.exercise("B4.5")
def test_a_launch_lights_one_firework_on_the_ground(rng: Random) -> None:
    type = rng.randrange(1, 5)
    about.call = f"show.launch({type}); the types of show.fireworks"
    about(
        cause="Call light with one birth of that type and no parent.",
        read="the docstring of launch",
    )
    a_show = show(9, "keep_old")
    a_show.launch(type)
    expect_exactly(burning(a_show), [type])
    about.call = f"show.launch({type}) 80 times; the different (x, y) at the start"
    about.cause = "Without a parent, make_firework must choose one of three places on the ground."
    places = probes.places_of_launches(simple(type), type, 80)
    if len(places) == 1:
        about.cause = "All fireworks start at the same position. Pass no parent to make_firework, "
        about.cause += "and pass self.random instead of making a new Random in each call."
    wanted = [(-5.0, 0.0), (0.0, 0.0), (5.0, 0.0)]
    expect_exactly(places, wanted)


@pytest.mark.exercise("B4.5")
def test_launched_fireworks_burn_in_the_order_of_their_launches(rng: Random) -> None:
    order = rng.sample([1, 2, 3, 4], 4)
    about.call = f"launch {', '.join(map(str, order))}; the types of show.fireworks"
    about.cause = "Append each new firework at the end, so that the oldest one is first."
    about.read = "the docstrings of FireworksShow and launch"
    for when_full in ("keep_old", "drop_oldest"):
        a_show = show(9, when_full)
        for type in order:
            a_show.launch(type)
        expect_exactly(burning(a_show), order)
        nobody = "Every firework had a slot here, so dropped must stay 0."
        expect_exactly(a_show.dropped, 0, then="; show.dropped", cause=nobody)


@pytest.mark.exercise("B4.5")
def test_keep_old_lights_none_when_all_slots_are_taken() -> None:
    about.call = 'capacity 3, "keep_old"; launch 1, 2, 3, 4, 1; the types of show.fireworks'
    about.cause = "With keep_old, burning fireworks keep their slots, as in the book's text (E-20)."
    about.read = "the docstring of FireworksShow; errata.md"
    a_show = show(3, "keep_old")
    for type in (1, 2, 3, 4, 1):
        a_show.launch(type)
    lit = burning(a_show)
    if len(lit) == 3 and 4 in lit:
        about.cause = "The oldest fireworks were removed, as in the book's listing. With keep_old "
        about.cause += "they must keep their slots (E-20)."
    expect_exactly(lit, [1, 2, 3])
    about.cause = "Add the fireworks that were not lit to dropped."
    expect_exactly(a_show.dropped, 2, then="; show.dropped")


@pytest.mark.exercise("B4.5")
def test_drop_oldest_puts_out_the_oldest() -> None:
    about.call = 'capacity 3, "drop_oldest"; launch 1, 2, 3, 4, 1; the types of show.fireworks'
    about.cause = "Each new firework replaces the oldest one, as in the book's listing (E-20)."
    about.read = "the docstring of FireworksShow; errata.md"
    a_show = show(3, "drop_oldest")
    for type in (1, 2, 3, 4, 1):
        a_show.launch(type)
    expect_exactly(burning(a_show), [3, 4, 1])
    about.cause = "Add the fireworks that were put out to dropped."
    expect_exactly(a_show.dropped, 2, then="; show.dropped")


@pytest.mark.exercise("B4.5")
@pytest.mark.parametrize(
    ("when_full", "wanted", "cause"),
    [
        ("keep_old", [1, 2, 2, 3], "One firework burns, so the first three new ones have room."),
        ("drop_oldest", [3, 3, 3, 4], "The last four stay, and all older fireworks are put out."),
    ],
)
def test_more_births_than_there_is_room_for(when_full: str, wanted: list[int], cause: str) -> None:
    about.cause = cause
    births = [(2, 2, None), (3, 4, None), (4, 1, None)]
    about.call = f'capacity 4, "{when_full}"; launch 1; show.light({births}); the types'
    about.read = "the docstring of light"
    a_show = show(4, when_full)
    a_show.launch(1)
    a_show.light(births)
    expect_exactly(burning(a_show), wanted)
    about.cause = (
        "Of 8 fireworks, 4 burn. Add the other 4 to dropped, whether they were lit or not."
    )
    expect_exactly(a_show.dropped, 4, then="; show.dropped")


@pytest.mark.exercise("B4.5")
def test_births_have_their_own_parents(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about.call = f"show.light([(1, 2, Particle(Vector3{x}, Vector3{v})), (2, 1, None)]); positions"
    about(cause="Pass each birth's own parent to make_firework.", read="the docstring of light")
    a_show = show(9, "keep_old")
    a_show.light([(1, 2, Particle(Vector3(*x), Vector3(*v))), (2, 1, None)])
    expect_exactly(burning(a_show), [1, 1, 2], then=": types")
    lit = a_show.fireworks
    places = [lit[i].particle.position for i in (0, 1, 2)]
    got = [place.x for place in places[:2]] + [place.y for place in places]
    wanted = [x[0], x[0], x[1], x[1], 0.0]
    expect_close(got, wanted, then=": x of two and y of three")
    places[0].x = 99.0
    about.cause = "Both entries are the same firework. Call make_firework once for each firework."
    expect_close(places[1].x, x[0], then="; the first one's x = 99; x of the second one")
    about.call = "births = [(1, 2, None), (2, 3, None)]; show.light(births); births"
    about.cause = "The list of births belongs to the caller. Do not change it."
    for when_full in ("keep_old", "drop_oldest"):
        left = probes.births_after(simple(1), simple(2), when_full)
        expect_exactly(left, [(1, 2), (2, 3)])


@pytest.mark.exercise("B4.5")
@pytest.mark.parametrize("when_full", ["keep_old", "drop_oldest"])
def test_a_thousand_million_sparks_cost_no_more_than_the_capacity(when_full: str) -> None:
    about.call = (
        f'capacity 2000, "{when_full}"; show.light() of 1000 births of 50 each; fireworks made'
    )
    about.cause = "First compute how many fireworks have room, and then make only those. Do not "
    about.cause += "make one that is put out at once."
    about.read = "the docstring of light"
    _, _, made = probes.many_births(simple(1), simple(2), 2000, when_full, 1000, 50)
    expect_exactly(max(0, made - 2000), 0, then=", beyond 2000")
    about.call = f'capacity 2000, "{when_full}"; show.light() of 1000 births, each of 10**9'
    lit, dropped, _ = probes.many_births(simple(1), simple(2), 2000, when_full, 1000, 10**9)
    wanted = [2000, 0] if when_full == "keep_old" else [0, 2000]
    expect_exactly(
        lit, wanted, then=", the first half of type 1, the rest of type 2; how many of each burn"
    )
    about.cause = "Add all fireworks of every birth that had no room to dropped."
    expect_exactly(dropped, 1000 * 10**9 - 2000, then="; show.dropped")


@pytest.mark.exercise("B4.5")
def test_the_same_seed_launches_the_same(rng: Random) -> None:
    seed = rng.randrange(10**6)
    rules = [FIRST]
    about.call = f"two shows with the seed {seed}: launch 1 three times"
    about.cause = "Draw from self.random, which was created from the seed."
    about.read = "the docstring of FireworksShow"
    runs = [probes.show_after(rules, [1, 1, 1], s, 0.01, 0) for s in (seed, seed, seed + 1)]
    expect_exactly(len(runs[0]), 3, then=", how many burn")
    differ = sum(a != b for a, b in zip(runs[0], runs[1], strict=True))
    expect_exactly(differ, 0, then=": how many fireworks differ")
    about.cause = "A different seed must give a different show."
    same = sum(a == b for a, b in zip(runs[0], runs[2], strict=True))
    about.call = f"shows with the seeds {seed} and {seed + 1}: how many fireworks are equal"
    expect_exactly(same, 0)


@pytest.mark.exercise("B4.5")
@pytest.mark.robust
def test_births_that_mean_nothing_are_refused() -> None:
    about.call = "show.launch(7), rules for 1 to 4"
    about.cause = "There is no rule of this type. Raise a ValueError that names the type."
    about.read = "the docstring of launch"
    a_show = show(9, "keep_old")
    expect_error(
        lambda: a_show.launch(7), ValueError, allowed=lambda: show(9, "keep_old").launch(4)
    )
    expect_exactly(len(a_show.fireworks), 0, then="; how many burn")
    about.cause = "Check all births before you light the first one."
    for bad, births in (
        ("a type without a rule", [(1, 2, None), (7, 1, None)]),
        ("a negative count", [(1, 2, None), (2, -3, None)]),
        ("a negative count", [(1, 2, None), (2, -1, None)]),
    ):
        about.call = f"show.light({births}), {bad}"
        expect_error(
            lambda births=births: a_show.light(births),
            ValueError,
            allowed=lambda: show(9, "keep_old").light([(4, 0, None), (4, 1, None)]),
            read="the docstring of light",
        )
        now = (len(a_show.fireworks), a_show.dropped)
        expect_exactly(now, (0, 0), then="; burning and dropped")
