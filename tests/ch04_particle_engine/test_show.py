"""The show goes on, build task B4.6."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from draw import components
from expect import about, blame, expect_close, expect_exactly, xyz

READ = "the docstring of update; book 4.2.3"
UP, STILL = (0.0, 9.0, 0.0), (0.0, 0.0, 0.0)


def fixed(
    type: int, age: float, velocity: probes.Components = UP, *payloads: tuple[int, int]
) -> probes.RuleData:
    """Return a rule without anything random and without damping."""
    return (type, age, age, velocity, velocity, 1.0, payloads)


def show_with(
    rules: list[probes.RuleData],
    births: list[tuple[int, int, Any]],
    capacity: int = 50,
    when_full: str = "keep_old",
) -> Any:
    """Return a show in which these births have been lit."""
    a_show = probes.show_of(rules, capacity, when_full, 1)
    a_show.light(births)
    return a_show


def at(position: probes.Components, velocity: probes.Components = STILL) -> Particle:
    return Particle(Vector3(*position), Vector3(*velocity))


def types(a_show: Any) -> list[int]:
    return [firework.type for firework in a_show.fireworks]


@pytest.mark.exercise("B4.6", asks="Each firework moves with one call of integrate")
def test_every_firework_moves_by_a_step_and_its_fuse_gets_shorter(rng: Random) -> None:
    h, v, about.read = round(rng.uniform(0.1, 0.4), 3), components(rng), READ
    about.call = (
        f"two fireworks at (0, 20, 0) with the velocity {v} m/s and 3 s of fuse left; "
        f"show.update({h})"
    )
    about.cause = (
        "Each update must move every firework by one time step. Call integrate exactly once for "
        "each particle, with the duration of the step."
    )
    a_show = show_with([fixed(1, 3.0, v)], [(1, 2, at((0.0, 20.0, 0.0)))])
    a_show.update(h)
    expect_exactly(len(a_show.fireworks), 2, then="; len(show.fireworks)")
    for firework in a_show.fireworks:
        wanted = (v[0] * h, 20.0 + v[1] * h, v[2] * h)
        got = xyz(firework.particle.position)
        twice = (2.0 * v[0] * h, 20.0 + 2.0 * v[1] * h - 9.81 * h * h, 2.0 * v[2] * h)
        mistakes = [
            (twice, "You move every firework by two time steps. Call integrate only once for it."),
            ((0.0, 20.0, 0.0), "You don't move the fireworks. Call integrate for each particle."),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, then="; the position of a firework", unit="m", tolerance=1e-13)
        got = xyz(firework.particle.velocity)
        wanted = (v[0], v[1] - 9.81 * h, v[2])
        expect_close(got, wanted, then="; the velocity of a firework", unit="m/s", tolerance=1e-13)
        about.cause = (
            "The age is the time that is left until the firework burns out. Subtract the duration "
            "from it exactly once."
        )
        age = firework.age
        mistakes = [
            (3.0 + h, "You add the duration to the age, but the age counts down. Subtract it."),
            (3.0, "You never change the age of a firework. Subtract the duration from it."),
        ]
        blame(age, mistakes)
        expect_close(age, 3.0 - h, then="; the age of a firework", unit="s", tolerance=1e-13)


@pytest.mark.exercise("B4.6", asks="age is below 0 (at exactly 0 it still burns)")
def test_a_firework_burns_out_when_its_age_is_below_0() -> None:
    about.read = READ
    about.call = (
        "a firework with 0.5 s of fuse left; show.update(0.125), called 5 times; the number of "
        "burning fireworks after each update"
    )
    about.cause = "After the fourth update the age of the firework is exactly 0, so it still "
    about.cause += "burns. Remove it only when its age is below 0."
    seen = probes.sparks([fixed(1, 0.5)], [1], 9, "keep_old", 1, 0.125, 5)
    counts = [len(types) for types in seen]
    if counts == [1, 1, 1, 0, 0]:
        about.cause = "You remove the firework when its age is exactly 0, after the fourth update. "
        about.cause += "It still burns then, so remove it only when its age is below 0."
    if counts == [1] * 5:
        about.cause = (
            "You keep a firework whose age is below 0. Either you ask for y < 0 as well, although "
            "an age below 0 is enough to burn it out, or you never put the list of those that "
            "still burn into self.fireworks."
        )
    expect_exactly(counts, [1, 1, 1, 1, 0])


def why_no_payload() -> str:
    """Return why nothing burns after a firework has burnt out below the ground."""
    rules, start = [fixed(1, 0.05, STILL, (2, 3)), fixed(2, 9.0)], (1, 1, at((0, 20, 0)))
    high, full = show_with(rules, [start]), show_with(rules, [start], 1)
    for a_show in (high, full):
        a_show.update(0.0625)
    if types(high) == [] and full.dropped == 0:
        return "You don't light any payloads. When a firework burns out, light all of its payloads."
    if types(high) == []:
        return (
            "You light payloads before you replace the list of fireworks, so the new fireworks are "
            "lost. Replace the list first, and then light the payloads."
        )
    rules = [fixed(1, 9.0, STILL, (2, 3)), fixed(2, 9.0, (0.0, 90.0, 0.0))]
    start = (1, 1, at((0.0, -0.001, 0.0)))
    low, full = show_with(rules, [start]), show_with(rules, [start], 1)
    for a_show in (low, full):
        a_show.update(0.001)
    if types(low) == [2, 2, 2]:
        return (
            "You move new fireworks in the step in which they are lit, so they burn out below the "
            "ground at once. Light payloads after all fireworks have moved."
        )
    if full.dropped:
        return (
            "You light the payload, but remove the new fireworks in the same update, because they "
            "start below the ground. Remove burned-out fireworks first, and light payloads last."
        )
    return (
        "You don't light the payload of a firework that falls below the ground. Light it just as "
        "you do when a fuse has burned down."
    )


@pytest.mark.exercise("B4.6", asks="or if it is below the ground (y < 0)")
def test_a_firework_burns_out_below_the_ground_and_leaves_its_payload_there() -> None:
    about.read = READ
    start = (
        "a firework of type 1 at (1, 0.5, 2), which falls at 8 m/s and has 9 s of fuse left; its "
        "payload is 3 fireworks of type 2; show.update(0.0625)"
    )
    about.call = (
        f"{start}, which moves it to y = 0; show.update(0.001), which moves it below the ground"
    )
    about.cause = (
        "A firework below the ground (y < 0) has burned out, however much fuse is left. Remove "
        "it, and light all three fireworks of its payload."
    )
    rules = [fixed(1, 9.0, (0.0, -8.0, 0.0), (2, 3)), fixed(2, 9.0)]
    a_show = show_with(rules, [(1, 1, at((1.0, 0.5, 2.0)))])
    a_show.update(0.0625)
    name = f"{start}, which moves it to y = 0; the types of the burning fireworks"
    on_ground = (
        "At y = 0 the firework is on the ground and still burns. Treat it as burned out only if y "
        "< 0."
    )
    expect_exactly(types(a_show), [1], call=name, cause=on_ground)
    try:
        a_show.update(0.001)
    except (AttributeError, TypeError, ValueError) as error:
        if "unpack" in str(error):
            about.cause = (
                "light takes a list of tuples. If you call it with one tuple at a time, put this "
                "tuple into a list."
            )
        if "'Firework' object has no attribute" in str(error):
            about.cause = (
                "You use a firework where its particle is needed. The parent of a payload is the "
                "particle of the firework that burned out, firework.particle."
            )
        raise
    left = types(a_show)
    if left == []:
        about.cause = why_no_payload()
    if left == [1]:
        about.cause = (
            "You keep a firework that is below the ground. Treat it as burned out if y < 0, "
            "however much fuse is left."
        )
    if left == [2, 2]:
        about.cause = (
            "You light payloads while the loop still moves the fireworks, so it reaches some of "
            "the new ones, which burn out at once. Light payloads after the loop."
        )
    if left == [2]:
        about.cause = (
            "You light only one of the three fireworks in the payload. Pass the payload's count "
            "to self.light."
        )
    expect_exactly(left, [2, 2, 2], then="; the types of the burning fireworks")
    about.cause = (
        "The fireworks of a payload must start where their parent burned out, even if that is "
        "below the ground."
    )
    height = a_show.fireworks[0].particle.position.y
    wanted = (-8.0 - 9.81 * 0.0625) * 0.001
    if height == 0.0:
        about.cause = (
            "You light the payload without a parent, so its fireworks start at y = 0. Pass the "
            "particle of the burned-out firework as their parent."
        )
    expect_close(height, wanted, then="; the height y of the first new firework", unit="m")


@pytest.mark.exercise("B4.6", asks="The parent of a payload is the particle")
def test_the_payload_starts_where_the_burnt_out_one_is_with_its_velocity(rng: Random) -> None:
    v, own, about.read = components(rng), components(rng), READ
    about.call = (
        f"a firework at (0, 20, 0) with the velocity {v} and 0.1 s of fuse left; its payload is 2 "
        f"fireworks of type 2, whose rule has the velocity {own}; show.update(0.25)"
    )
    a_show = show_with([fixed(1, 0.1, v, (2, 2)), fixed(2, 1.5, own)], [(1, 1, at((0, 20, 0)))])
    a_show.update(0.25)
    about.cause = (
        "The firework burns out and has a payload of 2 fireworks of type 2. Remove it, and light "
        "both of them."
    )
    expect_exactly(types(a_show), [2, 2], then="; the types of the burning fireworks")
    for firework in a_show.fireworks:
        about.cause = (
            "The new fireworks must start where their parent was after its last step, and move "
            "only from the next step on. Light them after all fireworks have moved."
        )
        wanted = (v[0] * 0.25, 20.0 + v[1] * 0.25, v[2] * 0.25)
        got = xyz(firework.particle.position)
        expect_close(got, wanted, then="; the position of a firework", unit="m", tolerance=1e-13)
        about.cause = (
            "A new firework starts with the velocity of its rule plus its parent's velocity "
            "after the step, which includes gravity. Pass the parent's particle to light."
        )
        wanted = (v[0] + own[0], v[1] - 9.81 * 0.25 + own[1], v[2] + own[2])
        got = xyz(firework.particle.velocity)
        expect_close(got, wanted, then="; the velocity of a firework", unit="m/s", tolerance=1e-13)
        about.cause = (
            "A new firework must still have its whole fuse, which starts to burn in the next step. "
            "Light payloads after you have shortened all fuses."
        )
        expect_close(firework.age, 1.5, then="; the age of a new firework")


@pytest.mark.exercise("B4.6", asks="remove the ones that have burned out")
def test_neighbors_that_burn_out_together_are_all_removed() -> None:
    rules, about.read = [fixed(1, 0.1), fixed(2, 5.0)], READ
    about.call = (
        "fireworks of types 1, 1, 2, 1, 1, 2 and 1; only type 2 has more than 0.25 s of fuse left; "
        "show.update(0.25)"
    )
    about.cause = "Each update must remove all burned-out fireworks and keep the others. Build a "
    about.cause += "new list of those that still burn."
    a_show = show_with(
        rules, [(1, 2, None), (2, 1, None), (1, 2, None), (2, 1, None), (1, 1, None)]
    )
    a_show.update(0.25)
    if 2 < len(types(a_show)) < 7:
        about.cause = "You remove fireworks from the list while you loop over it, so the loop "
        about.cause += "skips some. Build a new list of those that still burn."
    expect_exactly(types(a_show), [2, 2], then="; the types of the burning fireworks")
    ages = [firework.age for firework in a_show.fireworks]
    about.cause = (
        "Each update must shorten every fuse by the duration of the step. Check that your loop "
        "reaches each firework exactly once."
    )
    expect_close(ages, [4.75, 4.75], then="; the ages of the burning fireworks")


@pytest.mark.exercise("B4.6", asks="Move all fireworks first, then remove")
def test_burnt_out_fireworks_make_room_before_payloads_are_lit() -> None:
    about.read = READ
    rules = [fixed(1, 0.1, UP, (3, 2)), fixed(2, 0.1, UP, (4, 2)), fixed(3, 5.0), fixed(4, 5.0)]
    about.call = (
        'a show with 3 slots and the policy "keep_old"; three burning fireworks, whose payloads '
        "are 2 fireworks of type 3, 2 of type 4, and 2 of type 4; show.update(0.25), in which all "
        "three burn out; the types of the burning fireworks"
    )
    about.cause = (
        "You light payloads while other burned-out fireworks still occupy their slots. Remove "
        "all burned-out fireworks first, so that three slots are free."
    )
    a_show = show_with(rules, [(1, 1, at((0, 20, 0))), (2, 2, at((0, 20, 0)))], 3)
    a_show.update(0.25)
    if len(types(a_show)) > 3:
        about.cause = (
            "Your update lights more fireworks than the show has slots. Call self.light for the "
            "payloads, which keeps the number within the capacity."
        )
    if types(a_show) == [4, 4]:
        about.cause = (
            "You light only the payload of the last firework that burned out. Add the payloads of "
            "each one to your list of births instead of replacing the list."
        )
    expect_exactly(types(a_show), [3, 3, 4])
    about.cause = (
        "The payloads contain six fireworks, but there are only three slots. Count the other three "
        "in dropped."
    )
    expect_exactly(a_show.dropped, 3, then="; show.dropped")


@pytest.mark.exercise("B4.6", asks="decides what happens when the show is full")
def test_payloads_follow_the_policy_too() -> None:
    rules = [fixed(1, 0.1, UP, (3, 3)), fixed(2, 5.0), fixed(3, 5.0)]
    about.read = "the docstrings of FireworksShow and update"
    for when_full, wanted in (("keep_old", [2, 2, 3, 3]), ("drop_oldest", [2, 3, 3, 3])):
        about.call = (
            f'a show with 4 slots and the policy "{when_full}"; fireworks of types 1, 2 and 2; the '
            "first burns out, and its payload is 3 fireworks of type 3; the types of the burning "
            "fireworks"
        )
        about.cause = (
            "The policy for a full show applies to payloads too. Call self.light for them, which "
            "follows the policy."
        )
        births = [(1, 1, at((0.0, 20.0, 0.0))), (2, 2, None)]
        a_show = show_with(rules, births, 4, when_full)
        a_show.update(0.25)
        expect_exactly(types(a_show), wanted)


@pytest.mark.exercise("B4.6", asks="starting with the payloads of the oldest firework")
def test_the_oldest_comes_first_from_generation_to_generation() -> None:
    about.read = READ
    rules = [
        fixed(1, 0.3, UP, (3, 2), (4, 1)),
        fixed(2, 0.2, UP, (5, 1)),
        fixed(3, 9.0),
        fixed(4, 0.3, UP, (6, 1)),
        fixed(5, 9.0),
        fixed(6, 9.0),
    ]
    about.call = (
        "fireworks of types 1, 2 and 1 are launched, some of which have payloads; "
        "show.update(0.25), called 4 times; the types of the burning fireworks after each update"
    )
    about.cause = (
        "Light the payloads of the oldest firework first, in the order of its rule. Put the new "
        "fireworks after those that are already burning."
    )
    seen = probes.sparks(rules, [1, 2, 1], 50, "keep_old", 1, 0.25, 4)
    wanted = ["1 1 5", "5 3 3 4 3 3 4", "5 3 3 4 3 3 4", "5 3 3 3 3 6 6"]
    got = [" ".join(str(type) for type in types) for types in seen]
    if got[1] == "5 3 3 3 3":
        about.cause = (
            "You light only the first payload of each rule, but a rule can have several. Light all "
            "of them, in the order of the rule."
        )
    expect_exactly(got, wanted)
