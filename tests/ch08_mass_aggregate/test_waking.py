"""Going further, G8.1: what wakes particles that sleep, and what does not."""

from __future__ import annotations

import math
from itertools import product
from random import Random

import pytest

from ch08_mass_aggregate.sleep_probes import (
    both_ways,
    dropped_on,
    hung,
    on_a_spring,
    refused,
    support_gone,
    woken_by_contact,
    woken_by_force,
    woken_by_hand,
    work_asleep,
)
from ch08_mass_aggregate.wake_probes import group_woken, pushed, touched_gently, woken_by_little
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly

WAKE = "the docstring of SleepingWorld."
RUN = "the docstring of SleepingWorld.run_physics"


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize(
    ("how", "sleeps", "mass", "velocity"),
    [
        ("nothing", [0], math.inf, (0.0, 0.0, 0.0)),
        ("velocity", [], 2.0, (3.0, 0.0, 0.0)),
        ("force", [], 2.0, (0.5, 0.0, 0.0)),
        ("place", [], 2.0, (0.0, -1.0 / 6.0, 0.0)),
        ("mass", [], 4.0, (0.0, 0.0, 0.0)),
    ],
)
def test_what_is_moved_by_hand_wakes(
    how: str, sleeps: list[int], mass: float, velocity: tuple[float, float, float]
) -> None:
    about.read = f"{WAKE}wake_moved"
    about.call = f"a particle of 2 kg asleep on the ground, given a new {how}; then 1/60 s, "
    about.call += "wake_moved()"
    if how == "nothing":
        about.call = "a particle of 2 kg asleep on the ground, and nothing happens; 1/60 s, "
        about.call += "wake_moved()"
    about.cause = f"another {how} wakes it: compare with what its Sleep keeps, and a force with "
    about.cause += "none; before the integrator moves what is awake, as this frame counts for it "
    about.cause += "already"
    if how == "nothing":
        about.cause = "nothing was moved by hand: it sleeps on"
    before, got, now, fast = woken_by_hand(how)
    expect_exactly(before, [0], then=": who slept before")
    expect_exactly(got, sleeps, then=": who sleeps")
    about.cause = "its mass is what it was, unless it was given another"
    expect_close(1.0 / now, 1.0 / mass, then=": 1 / mass", tolerance=1e-12)
    about.cause = "it moves in this very frame, by force and gravity"
    expect_close(fast, velocity, then=": velocity", tolerance=1e-12)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("how", ["velocity", "force", "place"])
def test_whatever_is_moved_a_little_wakes(how: str) -> None:
    about.read = f"{WAKE}wake_moved"
    for axis, by in product("xyz", (1e-3, -1e-3)):
        about.call = f"three particles asleep on the ground, the last two given a {how} that is "
        about.call += f"new by {by} along {axis}; then 1/60 s, wake_moved()"
        about.cause = "they lie still"
        before, after = woken_by_little(how, axis, by)
        expect_exactly(before, [0, 1, 2], then=": who slept")
        about.cause = "whatever was moved by hand wakes, along each axis, either way, and however "
        about.cause += "little"
        expect_exactly(after, [0], then=": who sleeps")


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_moves_in_that_frame(rng: Random) -> None:
    about.read = f"{WAKE}wake_pushed"
    x, y = -positive_number(rng, 6.0, 9.0), positive_number(rng, 0.2, 0.9)
    for change, velocity in (
        ((x, 0.0), ((5.0 + x) / 60.0, 0.0, 0.0)),
        ((0.0, y), (0.0, y / 60.0, 0.0)),
        ((0.1, 0.0), (0.0, 0.0, 0.0)),
        ((-0.1, 0.0), (0.0, 0.0, 0.0)),
    ):
        about.call = f"2 kg asleep at a wall under two forces, 3 and 2 N/kg; then one is {change} "
        about.call += "N/kg larger, along X and Y; wake_pushed()"
        about.cause = "what is pushed as before sleeps on: compare the sum of its forces, each "
        about.cause += "generator asked while the particle has its own mass"
        done = pushed(*change)
        expect_exactly(done["before"], [0], then=": who slept")
        about.cause = "the accumulators of what sleeps are empty before and afterwards"
        expect_exactly(
            done["sums"], [(0.0, 0.0, 0.0)], then=": what its accumulator held while it slept"
        )
        about.cause = "a change of more than SAME, 1 %, of what acts wakes; it moves in this very "
        about.cause += "frame, and each force counts once: clear what you added up to compare"
        woken = done["velocity"] is not None
        expect_exactly(woken, True, then=": does it wake within 10 frames")
        got = done["velocity"] or (math.nan,) * 3
        twice = tuple(2.0 * part for part in velocity)
        if any(velocity):
            seen = "the forces count twice: clear what was added up to compare"
            blame(got, [(twice, seen)])
        expect_close(
            got, velocity, then=": velocity after the frame in which it wakes", tolerance=1e-12
        )
        about.cause = "generators are told the duration of the frame"
        expect_exactly(done["durations"], [1.0 / 60.0], then=": what they were told")


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_what_is_pushed_otherwise_wakes(old: float, new: float, late: bool) -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = f"2 kg asleep at a wall, pushed by {old} N/kg to it; then {new}; wake_pushed()"
    about.call += ", by a generator that is added" if late else ""
    about.cause = "it has to sleep first: the wall holds it"
    seen = woken_by_force(old, new, 10, late)
    expect_exactly(seen[0], [0], then=": who sleeps before")
    about.cause = "every LOOK_EVERY-th frame, so within 10, its generators are asked, with its own "
    about.cause += "mass"
    expect_exactly(seen[-1], [], then=": who sleeps after 10 frames")


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_as_before_sleeps_on(rng: Random) -> None:
    about.read = f"{WAKE}wake_pushed"
    push = positive_number(rng, 2.0, 9.0)
    about.call = f"a particle asleep at a wall, pushed by {push} N/kg to it; wake_pushed()"
    about.cause = "what changes by SAME or less wakes nothing: compare with the acceleration of "
    about.cause += "then"
    for new in (push, 1.009 * push, 0.991 * push):
        seen = woken_by_force(push, new, 25)
        expect_exactly(
            seen, [[0]] * 26, then=f", then by {new} N/kg: who sleeps after each of 25 frames"
        )


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("first", [False, True], ids=["the last in the list", "the first"])
def test_what_is_touched_wakes_with_all_that_it_touches(rng: Random, first: bool) -> None:
    about.read = f"{WAKE}wake_touched, and run_physics"
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"three balls asleep side by side, another one comes at {speed} m/s; "
    about.call += "wake_touched()"
    about.cause = "they lie still, each touching the next"
    done = woken_by_contact(speed, 40, first)
    expect_exactly(done["before"], [0, 1, 2], then=": who sleeps")
    about.cause = "until it is there, nothing wakes"
    expect_exactly(done["seen"][0], [0, 1, 2], then=": after a frame")
    hit = next((i for i, now in enumerate(done["seen"]) if now != [0, 1, 2]), -1)
    about.cause = "the contact wakes the first ball, the contacts are looked for again, and it "
    about.cause += "wakes the next one, all in the same frame"
    expect_exactly(
        done["seen"][hit], [], then=": who sleeps after the first frame in which any of them wakes"
    )
    about.cause = "they are awake, with their masses, before the contact is resolved: momentum is "
    about.cause += "kept"
    expect_close(
        done["momenta"][hit], speed, then=": momentum along X after that frame", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_lies_still_wakes_what_it_touches() -> None:
    about.read = f"{WAKE}wake_touched"
    for order in ((0, 1), (1, 0)):
        about.call = "a particle asleep, and an awake one at rest that touches it, contact of "
        about.call += f"{order}; wake_touched(): who sleeps before, and after a frame"
        about.cause = "the other one can move: how fast it is, or how deep, makes no difference"
        expect_exactly(touched_gently(order), [[0], []])


@pytest.mark.exercise("G8.1")
def test_what_wakes_still_stands_on_the_ground(rng: Random) -> None:
    about.read = RUN
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"a ball asleep on the ground, another one falls on it at {speed} m/s; "
    about.call += "run_physics(): velocity and height of the lower one, after the frame in which "
    about.call += "it wakes"
    about.cause = "what sleeps has no contact with the ground: look for contacts again when one "
    about.cause += "wakes, or it is pushed into the ground"
    before, *got = dropped_on(speed)
    expect_exactly(before, [0], then=": who slept before")
    # Two hundred iterations leave some 1e-9 m/s.
    expect_close(got, (0.0, 0.5), tolerance=1e-6)


@pytest.mark.exercise("G8.1")
def test_what_fell_asleep_as_one_wakes_as_one() -> None:
    about.read = f"{WAKE}wake, and fall_asleep"
    about.call = "a ball asleep on another one, which is put elsewhere; wake(), 6 frames"
    about.cause = "both lie still"
    before, after, speed = support_gone(6)
    expect_exactly(before, [0, 1], then=": who slept before")
    about.cause = "what wakes, wakes its neighbours: those that it touched when it fell asleep"
    expect_exactly(1 in after, False, then=": does the upper one sleep")
    expect_close(speed, -1.0, then=": how fast it moves, along Y", tolerance=0.01)
    for pairs in ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)]):
        for first in range(4):
            about.call = f"five particles, contacts of {pairs} but in the frame in which they fall "
            about.call += f"asleep; then number {first} moves; wake()"
            was, now = group_woken(pairs, first)
            about.cause = "they lie still"
            expect_exactly(was, [0, 1, 2, 3, 4], then=": who slept")
            about.cause = "neighbours are what was in contact in one of the last sleep_frames "
            about.cause += "frames, of both sides; all of the group wakes, and nothing else"
            expect_exactly(now, [4], then=": who sleeps")
    about.call = "three particles in a row on two springs, asleep; the last one gets 6 m/s; wake()"
    about.cause = "they rest"
    seen, places = on_a_spring(20)
    expect_exactly(seen[0], [0, 1, 2], then=": who slept before")
    about.cause = "what a generator joins is one group, as what touches is: all wake in that very "
    about.cause += "frame"
    expect_exactly(seen[1], [], then=": who sleeps after a frame")
    about.cause = "forces of springs are equal and opposite: the middle of the three moves at 2 m/s"
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    middle = math.fsum(place[0] for place in places) / 3.0 - 1.0
    expect_close(
        middle, drift, then=": how far the middle has moved after 20 frames", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_hangs_still_sleeps_on() -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = "a mass that hangs still on a spring; wake_pushed(): who sleeps in frames 5 to 40"
    about.cause = "gravity and spring cancel: compare the change with |a| + |f / m|, not with "
    about.cause += "their sum"
    expect_exactly(hung(40, 40, 0.0)[4:], [[0]] * 36)
    about.call += ", pushed by 0.15 N/kg more from frame 20 on"
    about.cause = "|a| and |f / m| are 10 m/s^2 each: 0.15 is less than SAME of both together"
    expect_exactly(hung(40, 20, 0.15)[4:], [[0]] * 36)
    about.call = "a mass that hangs still on a spring, pushed by 0.5 N/kg more from frame 20 on; "
    about.call += "wake_pushed(): does it wake within 10 frames"
    about.cause = "that is more than SAME of |a| + |f / m|, which are 10 m/s^2 each"
    expect_exactly([] in hung(31, 20, 0.5)[20:], True)


@pytest.mark.exercise("G8.1")
def test_what_sleeps_costs_no_work(rng: Random) -> None:
    about.read = RUN
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    about.call = f"{count} particles with a generator each, all asleep but {awake}; 20 "
    about.call += "run_physics()"
    about.cause = "those that are slow sleep by then"
    asked, given, sleepers = work_asleep(count, awake, 20)
    wanted = [*range(awake, count)]
    expect_exactly(sleepers, wanted, then=": who sleeps")
    about.cause = "give the integrator only what is awake"
    expect_exactly(given, 20 * awake, then=": particles that it was given")
    about.cause = "the generators of what sleeps are asked in every tenth frame, and once each"
    expect_exactly(
        asked, 20 * awake + 2 * (count - awake), then=": how often generators were asked"
    )


@pytest.mark.exercise("G8.1")
def test_sleep_changes_no_rest() -> None:
    about.read = RUN
    about.call = "two balls bounce until they lie, by run_physics(): where, with sleep and without"
    about.cause = "what is asleep would have lain still anyway: is anything put to sleep in "
    about.cause += "mid-air?"
    places, awake, sleepers = both_ways(360)
    for got, wanted in zip(places, awake, strict=True):
        # What falls asleep has 0.17 m/s at most, and damping of 0.5 would end that within 0.25 m.
        expect_close(got, wanted, tolerance=0.25)
        expect_close(got[1], 0.0, then=": how far above the ground", tolerance=1e-6)
    about.cause = "in six seconds both have come to rest"
    expect_exactly(sleepers, 2, then=": how many sleep")


@pytest.mark.exercise("G8.1")
@pytest.mark.robust
def test_a_frame_without_a_duration_is_refused_here_too() -> None:
    about.read = RUN
    for duration, error in ((0.0, "ValueError"), (math.nan, "ValueError"), ("1", "TypeError")):
        about.call = f"world.run_physics({duration!r})"
        about.cause = "positive() refuses it, before anything changes"
        name, force = refused(duration)
        expect_exactly(name, error, then=": the error, '' for none")
        expect_close(
            force, (1.0, 2.0, 3.0), then=": the force that was added before it", tolerance=0.0
        )
    about.call, about.cause = "world.run_physics(0.1)", "what is right must not be refused"
    expect_exactly(refused(0.1)[0], "", then=": the error, '' for none")
