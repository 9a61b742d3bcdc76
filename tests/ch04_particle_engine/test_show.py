"""The show goes on, build task B4.6."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.probes import STILL, UP, fixed, types
from draw import Triple, vector
from expect import about, expect_close, expect_exactly, named

READ, SHOW = "the docstring of update; book 4.2.3", "the docstring of FireworksShow"
TYPES = "; the types of the burning fireworks"
GRAVITY = Triple((0.0, -9.81, 0.0))


def updated(duration: float, rules: list[probes.RuleData], births: list[Any], *slots: Any) -> Any:
    """Return a show in which these births have been lit, and which has been updated once."""
    show = probes.show_of(rules, *(slots or (50, "keep_old")), 1)
    show.light(births)
    show.update(duration)
    return show


def at(x: float, y: float, z: float) -> Particle:
    return Particle(Vector3(x, y, z))


@pytest.mark.exercise("B4.6", asks="Each firework moves with one call of integrate", read=READ)
def test_every_firework_moves_by_a_step_and_its_fuse_gets_shorter(rng: Random) -> None:
    h, v, start = round(rng.uniform(0.1, 0.4), 3), vector(rng), Triple((0.0, 20.0, 0.0))
    with calls(
        "Each update must move every firework by one time step. Call integrate exactly once for "
        "each particle, with the duration of the step.",
        f"two fireworks at (0, 20, 0) with velocity {v} and 3 s of fuse left; show.update({h})",
    ):
        show = updated(h, [fixed(1, 3.0, v)], [(1, 2, at(*start))])
    expect_exactly(len(show.fireworks), 2, then="; len(show.fireworks)")
    moved = {
        "You move every firework by two time steps. Call integrate only once for it.":
            start + 2.0 * h * v + h * h * GRAVITY,
        "You don't move the fireworks. Call integrate for each particle.": start,
    }  # fmt: skip
    aged = {
        "You add the duration to the age, but the age counts down. Subtract it.": 3.0 + h,
        "You never change the age of a firework. Subtract the duration from it.": 3.0,
    }
    once = "The age is the time left until it burns out. Subtract the duration exactly once."
    for firework in show.fireworks:
        for name, got, wanted, slips, unit in (
            ("position", firework.particle.position, start + h * v, moved, "m"),
            ("velocity", firework.particle.velocity, v + h * GRAVITY, None, "m/s"),
        ):
            then = f"; the {name} of a firework"
            expect_close(got, wanted, slips, then=then, unit=unit, tolerance=1e-13)
        got, then = firework.age, "; the age of a firework"
        expect_close(got, 3.0 - h, aged, then=then, unit="s", tolerance=1e-13, cause=once)


@pytest.mark.exercise("B4.6", asks="age is below 0 (at exactly 0 it still burns)", read=READ)
def test_a_firework_burns_out_when_its_age_is_below_0() -> None:
    with calls(
        "After the fourth update the age of the firework is exactly 0, so it still burns. Remove "
        "it only when its age is below 0.",
        "a firework with 0.5 s of fuse left; show.update(0.125), called 5 times; the number of "
        "burning fireworks after each update",
    ):
        counts = [len(lit) for lit in probes.played([fixed(1, 0.5)], [1], 0.125, 5)[0]]
    slips = {
        "You remove the firework when its age is exactly 0, after the fourth update. It still "
        "burns then, so remove it only when its age is below 0.": [1, 1, 1, 0, 0],
        "You keep a firework whose age is below 0. Either you ask for y < 0 as well, although an "
        "age below 0 is enough to burn it out, or you never put the list of those that still burn "
        "into self.fireworks.": [1] * 5,
    }
    expect_exactly(counts, [1, 1, 1, 1, 0], cause=named(counts, about.cause, slips))


def why_no_payload() -> str:
    """Return why nothing burns after a firework has burnt out below the ground."""
    rules, start = [fixed(1, 0.05, STILL, (2, 3)), fixed(2, 9.0)], [(1, 1, at(0, 20, 0))]
    if not types(updated(0.0625, rules, start)):
        if updated(0.0625, rules, start, 1, "keep_old").dropped == 0:
            return "You don't light any payloads. When a firework burns out, light all of them."
        return "You light payloads before you replace the list, which loses them. Light them last."
    rules = [fixed(1, 9.0, STILL, (2, 3)), fixed(2, 9.0, (0.0, 90.0, 0.0))]
    start = [(1, 1, at(0.0, -0.001, 0.0))]
    if types(updated(0.001, rules, start)) == [2, 2, 2]:
        return "You move new fireworks in the step in which they are lit. Light payloads last."
    if updated(0.001, rules, start, 1, "keep_old").dropped:
        return (
            "You light the payload, but remove the new fireworks in the same update, because they "
            "start below the ground. Remove burned-out fireworks first, and light payloads last."
        )
    return "Light the payload of a firework below the ground, too, as when a fuse has burned down."


@pytest.mark.exercise("B4.6", asks="or if it is below the ground (y < 0)", read=READ)
def test_a_firework_burns_out_below_the_ground_and_leaves_its_payload_there() -> None:
    with calls(
        "At y = 0 the firework is on the ground and still burns. Treat it as burned out only if y "
        "< 0.",
        "a firework of type 1 at (1, 0.5, 2), which falls at 8 m/s and has 9 s of fuse left; its "
        "payload is 3 fireworks of type 2; show.update(0.0625), which moves it to y = 0",
    ):
        rules = [fixed(1, 9.0, (0.0, -8.0, 0.0), (2, 3)), fixed(2, 9.0)]
        show = updated(0.0625, rules, [(1, 1, at(1.0, 0.5, 2.0))])
    expect_exactly(types(show), [1], then=TYPES)
    with calls(
        "A firework below the ground (y < 0) has burned out, however much fuse is left. Remove it, "
        "and light all three fireworks of its payload.",
        "show.update(0.001), which moves it below the ground",
        more=True,
    ):
        try:
            show.update(0.001)
        except (AttributeError, TypeError, ValueError) as error:
            if "unpack" in str(error):
                about(
                    cause="light takes a list of tuples. If you call it with one tuple at a time, "
                    "put this tuple into a list."
                )
            if "'Firework' object has no attribute" in str(error):
                about(
                    cause="You use a firework where its particle is needed. The parent of a "
                    "payload is the particle of the firework that burned out, firework.particle."
                )
            raise
    left = types(show)
    slips = {
        "You keep a firework that is below the ground. Treat it as burned out if y < 0, however "
        "much fuse is left.": [1],
        "You light payloads while the loop still moves the fireworks, so it reaches some of the "
        "new ones, which burn out at once. Light payloads after the loop.": [2, 2],
        "You light only one of the three fireworks. Pass the payload's count to self.light.": [2],
    }
    why = named(left, about.cause, slips) if left else why_no_payload()
    expect_exactly(left, [2, 2, 2], then=TYPES, cause=why)
    slips = {
        "You light the payload without a parent, so its fireworks start at y = 0. Pass the "
        "particle of the burned-out firework as their parent.": 0.0
    }
    expect_close(
        show.fireworks[0].particle.position.y,
        (-8.0 - 9.81 * 0.0625) * 0.001,
        slips,
        then="; the height y of the first new firework",
        unit="m",
        cause="Payloads must start where their parent burned out, even below the ground.",
    )


@pytest.mark.exercise("B4.6", asks="The parent of a payload is the particle", read=READ)
def test_the_payload_starts_where_the_burnt_out_one_is_with_its_velocity(rng: Random) -> None:
    v, own, start, h = vector(rng), vector(rng), Triple((0.0, 20.0, 0.0)), 0.25
    with calls(
        "The firework burns out and has a payload of 2 fireworks of type 2. Remove it, and light "
        "both of them.",
        f"a firework at (0, 20, 0) with the velocity {v} and 0.1 s of fuse left; its payload is 2 "
        f"fireworks of type 2, whose rule has the velocity {own}; show.update({h})",
    ):
        rules = [fixed(1, 0.1, v, (2, 2)), fixed(2, 1.5, own)]
        show = updated(h, rules, [(1, 1, at(0, 20, 0))])
    expect_exactly(types(show), [2, 2], then=TYPES)
    for firework in show.fireworks:
        p = firework.particle
        for name, got, wanted, unit, cause in (
            ("position", p.position, start + h * v, "m",
             "The new fireworks must start where their parent was after its last step, and move "
             "only from the next step on. Light them after all fireworks have moved."),
            ("velocity", p.velocity, v + own + h * GRAVITY, "m/s",
             "A new firework starts with the velocity of its rule plus its parent's velocity after "
             "the step, which includes gravity. Pass the parent's particle to light."),
        ):  # fmt: skip
            then = f"; the {name} of a firework"
            expect_close(got, wanted, then=then, unit=unit, tolerance=1e-13, cause=cause)
        whole = "Light payloads after all fuses have got shorter, so that theirs stay whole."
        expect_close(firework.age, 1.5, then="; the age of a new firework", cause=whole)


@pytest.mark.exercise("B4.6", asks="remove the ones that have burned out", read=READ)
def test_neighbors_that_burn_out_together_are_all_removed() -> None:
    build = "Build a new list of those that still burn."
    with calls(
        f"Each update must remove all burned-out fireworks and keep the others. {build}",
        "fireworks of types 1, 1, 2, 1, 1, 2 and 1; only type 2 has more than 0.25 s of fuse left; "
        "show.update(0.25)",
    ):
        births = [(1, 2, None), (2, 1, None), (1, 2, None), (2, 1, None), (1, 1, None)]
        show = updated(0.25, [fixed(1, 0.1), fixed(2, 5.0)], births)
    why = about.cause
    if 2 < len(types(show)) < 7:
        skips = "You remove fireworks from the list while you loop over it, so the loop skips some."
        why = f"{skips} {build}"
    expect_exactly(types(show), [2, 2], then=TYPES, cause=why)
    expect_close(
        [firework.age for firework in show.fireworks],
        [4.75, 4.75],
        then="; the ages of the burning fireworks",
        cause="Shorten every fuse by the duration of the step. Reach each firework exactly once.",
    )


@pytest.mark.exercise("B4.6", asks="Move all fireworks first, then remove", read=READ)
def test_burnt_out_fireworks_make_room_before_payloads_are_lit() -> None:
    with calls(
        "You light payloads while other burned-out fireworks still occupy their slots. Remove all "
        "burned-out fireworks first, so that three slots are free.",
        'a show with 3 slots and the policy "keep_old"; three burning fireworks, whose payloads '
        "are 2 fireworks of type 3, 2 of type 4, and 2 of type 4; show.update(0.25), in which all "
        "three burn out",
    ):
        rules = [fixed(1, 0.1, UP, (3, 2)), fixed(2, 0.1, UP, (4, 2)), fixed(3, 5.0), fixed(4, 5.0)]
        births = [(1, 1, at(0, 20, 0)), (2, 2, at(0, 20, 0))]
        show = updated(0.25, rules, births, 3, "keep_old")
    lit, why = types(show), about.cause
    if len(lit) > 3:
        why = "You light more fireworks than the show has slots. Call self.light for payloads."
    slips = {
        "You light only the payload of the last firework that burned out. Add the payloads of each "
        "one to your list of births instead of replacing the list.": [4, 4]
    }
    expect_exactly(lit, [3, 3, 4], then=TYPES, cause=named(lit, why, slips))
    why = "Six fireworks find only three slots. Count the other three in dropped."
    expect_exactly(show.dropped, 3, then="; show.dropped", cause=why)


@pytest.mark.exercise(
    "B4.6",
    asks="decides what happens when the show is full",
    read="the docstrings of FireworksShow and update",
)
def test_payloads_follow_the_policy_too() -> None:
    rules = [fixed(1, 0.1, UP, (3, 3)), fixed(2, 5.0), fixed(3, 5.0)]
    for when_full, wanted in (("keep_old", [2, 2, 3, 3]), ("drop_oldest", [2, 3, 3, 3])):
        with calls(
            "The policy for a full show applies to payloads too. Call self.light for them.",
            f'a show with 4 slots and the policy "{when_full}"; fireworks of types 1, 2 and 2; the '
            "first burns out, and its payload is 3 fireworks of type 3; the types of the burning "
            "fireworks",
        ):
            births = [(1, 1, at(0.0, 20.0, 0.0)), (2, 2, None)]
            show = updated(0.25, rules, births, 4, when_full)
        expect_exactly(types(show), wanted)


@pytest.mark.exercise("B4.6", asks="starting with the payloads of the oldest firework", read=READ)
def test_the_oldest_comes_first_from_generation_to_generation() -> None:
    rules = [
        *(fixed(1, 0.3, UP, (3, 2), (4, 1)), fixed(2, 0.2, UP, (5, 1)), fixed(3, 9.0)),
        *(fixed(4, 0.3, UP, (6, 1)), fixed(5, 9.0), fixed(6, 9.0)),
    ]
    with calls(
        "Light the payloads of the oldest firework first, in the order of its rule. Put the new "
        "fireworks after those that are already burning.",
        "fireworks of types 1, 2 and 1 are launched, some of which have payloads; "
        "show.update(0.25), called 4 times; the types of the burning fireworks after each update",
    ):
        frames, _ = probes.played(rules, [1, 2, 1], 0.25, 4)
    got = [" ".join(map(str, lit)) for lit in frames]
    why = about.cause
    if got[1] == "5 3 3 3 3":
        why = "You light only the first payload of each rule. Light all of them, in its order."
    expect_exactly(got, ["1 1 5", *["5 3 3 4 3 3 4"] * 2, "5 3 3 3 3 6 6"], cause=why)


@pytest.mark.exercise("B4.6", asks="is the number of fireworks", read=READ)
def test_the_count_of_sparks_is_that_of_the_rules(rng: Random) -> None:
    many = rng.randrange(3, 7)
    rules: list[probes.RuleData] = [
        (1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ((3, many), (5, 2))),
        (3, 0.5, 1.5, (-1.0, 5.0, -1.0), (1.0, 9.0, 1.0), 0.1, ((5, 3),)),
        (5, 4.5, 4.5, STILL, STILL, 0.001, ()),
    ]
    with calls(
        "The number of fireworks is wrong after several generations. Check that update lights each "
        "payload of a burned-out firework exactly once.",
        f"type 1 has payloads of {many} fireworks of type 3 and 2 of type 5; type 3 has a payload "
        "of 3 of type 5; show.launch(1) twice; show.update(0.05), called 80 times; how many of "
        "each type burn",
    ):
        seed = rng.randrange(10**6)
        frames, _ = probes.played(rules, [1, 1], 0.05, 80, capacity=100, seed=seed)
    got = {type: frames[-1].count(type) for type in (1, 3, 5)}
    expect_exactly(got, {1: 0, 3: 0, 5: 2 * (2 + 3 * many)})


@pytest.mark.exercise("B4.6", asks="even if their types light each other forever", read=SHOW)
def test_rules_without_an_end_stay_within_the_capacity() -> None:
    for when_full in ("keep_old", "drop_oldest"):
        with calls(
            "Each firework lights ten others of its own type, so without a limit their number "
            "grows forever. Call self.light, which keeps it within the capacity.",
            f'a show with 50 slots and the policy "{when_full}", where type 1 has a payload of 10 '
            "fireworks of type 1; show.launch(1); show.update(0.2), called 30 times",
        ):
            rules, slots = [fixed(1, 0.1, UP, (1, 10))], {"capacity": 50, "when_full": when_full}
            counts = [len(lit) for lit in probes.played(rules, [1], 0.2, 30, **slots)[0]]
        then = "; the largest number of fireworks that burn at once"
        expect_exactly(max(counts), 50, then=then)
        then = "; how many burn after each of the first 3 updates"
        expect_exactly(counts[:3], [10, 50, 50], then=then)


@pytest.mark.exercise("B4.6", asks="seed always gives the same show", read=SHOW)
def test_a_show_is_the_same_whenever_its_seed_is(rng: Random) -> None:
    """Only here two shows with random rules run side by side, until they have lit payloads."""
    seed = rng.randrange(10**6)
    rules: list[probes.RuleData] = [
        (1, 0.1, 0.4, (-5.0, 5.0, -5.0), (5.0, 8.0, 5.0), 0.1, ((3, 5),)),
        (3, 0.7, 2.5, (-5.0, 5.0, -5.0), (5.0, 9.0, 5.0), 0.1, ()),
    ]
    with calls(
        "Two shows with the same seed differ. Draw all random numbers from self.random, and always "
        "in the same order.",
        f"two shows with the seed {seed}; in each, fireworks of types 1, 1 and 3 are launched; "
        "show.update(0.05), called 12 times",
    ):
        once, again, other = (
            probes.played(rules, [1, 1, 3], 0.05, 12, seed=s)[1] for s in (seed, seed, seed + 1)
        )
    expect_exactly(len(once) > 0, True, then="; does anything still burn?")
    differ = abs(len(once) - len(again)) + sum(a != b for a, b in zip(once, again, strict=False))
    expect_exactly(differ, 0, then="; how many fireworks differ between the shows")
    expect_exactly(
        sum(firework in once for firework in other),
        0,
        call=f"two shows with the seeds {seed} and {seed + 1}, run in the same way; how many "
        "fireworks are equal",
        cause="Two shows with different seeds have equal fireworks. Draw all random numbers from "
        "self.random, which is created from the seed.",
    )
