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
from expect import cause_of, expect_close, expect_exactly

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
    read = f"{WAKE}wake_moved"
    call = f"a particle of 2 kg asleep on the ground, given a new {how}; then 1/60 s, wake_moved()"
    if how == "nothing":
        call = "a particle of 2 kg asleep on the ground, and nothing happens; 1/60 s, wake_moved()"
    cause = f"another {how} wakes it: compare with what its Sleep keeps, and a force with none; "
    cause += "before the integrator moves what is awake, as this frame counts for it already"
    if how == "nothing":
        cause = "nothing was moved by hand: it sleeps on"
    before, got, now, fast = woken_by_hand(how)
    expect_exactly(f"{call}: who slept before", before, [0], cause=cause, read=read)
    expect_exactly(f"{call}: who sleeps", got, sleeps, cause=cause, read=read)
    cause = "its mass is what it was, unless it was given another"
    name = f"{call}: 1 / mass"
    expect_close(name, 1.0 / now, 1.0 / mass, cause=cause, read=read, tolerance=1e-12)
    cause = "it moves in this very frame, by force and gravity"
    expect_close(f"{call}: velocity", fast, velocity, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("how", ["velocity", "force", "place"])
def test_whatever_is_moved_a_little_wakes(how: str) -> None:
    read = f"{WAKE}wake_moved"
    for axis, by in product("xyz", (1e-3, -1e-3)):
        call = f"three particles asleep on the ground, the last two given a {how} that is new by "
        call += f"{by} along {axis}; then 1/60 s, wake_moved()"
        cause = "they lie still"
        before, after = woken_by_little(how, axis, by)
        expect_exactly(f"{call}: who slept", before, [0, 1, 2], cause=cause, read=read)
        cause = "whatever was moved by hand wakes, along each axis, either way, and however little"
        expect_exactly(f"{call}: who sleeps", after, [0], cause=cause, read=read)


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_moves_in_that_frame(rng: Random) -> None:
    read = f"{WAKE}wake_pushed"
    x, y = -positive_number(rng, 6.0, 9.0), positive_number(rng, 0.2, 0.9)
    for change, velocity in (
        ((x, 0.0), ((5.0 + x) / 60.0, 0.0, 0.0)),
        ((0.0, y), (0.0, y / 60.0, 0.0)),
        ((0.1, 0.0), (0.0, 0.0, 0.0)),
        ((-0.1, 0.0), (0.0, 0.0, 0.0)),
    ):
        call = f"2 kg asleep at a wall under two forces, 3 and 2 N/kg; then one is {change} N/kg "
        call += "larger, along X and Y; wake_pushed()"
        cause = "what is pushed as before sleeps on: compare the sum of its forces, each generator "
        cause += "asked while the particle has its own mass"
        done = pushed(*change)
        expect_exactly(f"{call}: who slept", done["before"], [0], cause=cause, read=read)
        cause = "the accumulators of what sleeps are empty before and afterwards"
        name = f"{call}: what its accumulator held while it slept"
        expect_exactly(name, done["sums"], [(0.0, 0.0, 0.0)], cause=cause, read=read)
        cause = "a change of more than SAME, 1 %, of what acts wakes; it moves in this very frame, "
        cause += "and each force counts once: clear what you added up to compare"
        name = f"{call}: velocity after the frame in which it wakes"
        woken = done["velocity"] is not None
        expect_exactly(
            f"{call}: does it wake within 10 frames", woken, True, cause=cause, read=read
        )
        got = done["velocity"] or (math.nan,) * 3
        twice = tuple(2.0 * part for part in velocity)
        if any(velocity):
            seen = "the forces count twice: clear what was added up to compare"
            cause = cause_of(got, [(twice, seen)], cause)
        expect_close(name, got, velocity, cause=cause, read=read, tolerance=1e-12)
        cause = "generators are told the duration of the frame"
        name = f"{call}: what they were told"
        expect_exactly(name, done["durations"], [1.0 / 60.0], cause=cause, read=read)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_what_is_pushed_otherwise_wakes(old: float, new: float, late: bool) -> None:
    read = f"{WAKE}wake_pushed"
    call = f"2 kg asleep at a wall, pushed by {old} N/kg to it; then {new}; wake_pushed()"
    call += ", by a generator that is added" if late else ""
    cause = "it has to sleep first: the wall holds it"
    seen = woken_by_force(old, new, 10, late)
    expect_exactly(f"{call}: who sleeps before", seen[0], [0], cause=cause, read=read)
    cause = "every LOOK_EVERY-th frame, so within 10, its generators are asked, with its own mass"
    name = f"{call}: who sleeps after 10 frames"
    expect_exactly(name, seen[-1], [], cause=cause, read=read)


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_as_before_sleeps_on(rng: Random) -> None:
    read = f"{WAKE}wake_pushed"
    push = positive_number(rng, 2.0, 9.0)
    call = f"a particle asleep at a wall, pushed by {push} N/kg to it; wake_pushed()"
    cause = "what changes by SAME or less wakes nothing: compare with the acceleration of then"
    for new in (push, 1.009 * push, 0.991 * push):
        name = f"{call}, then by {new} N/kg: who sleeps after each of 25 frames"
        seen = woken_by_force(push, new, 25)
        expect_exactly(name, seen, [[0]] * 26, cause=cause, read=read)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("first", [False, True], ids=["the last in the list", "the first"])
def test_what_is_touched_wakes_with_all_that_it_touches(rng: Random, first: bool) -> None:
    read = f"{WAKE}wake_touched, and run_physics"
    speed = positive_number(rng, 4.0, 9.0)
    call = f"three balls asleep side by side, another one comes at {speed} m/s; wake_touched()"
    cause = "they lie still, each touching the next"
    done = woken_by_contact(speed, 40, first)
    expect_exactly(f"{call}: who sleeps", done["before"], [0, 1, 2], cause=cause, read=read)
    cause = "until it is there, nothing wakes"
    expect_exactly(f"{call}: after a frame", done["seen"][0], [0, 1, 2], cause=cause, read=read)
    hit = next((i for i, now in enumerate(done["seen"]) if now != [0, 1, 2]), -1)
    cause = "the contact wakes the first ball, the contacts are looked for again, and it wakes the "
    cause += "next one, all in the same frame"
    name = f"{call}: who sleeps after the first frame in which any of them wakes"
    expect_exactly(name, done["seen"][hit], [], cause=cause, read=read)
    cause = "they are awake, with their masses, before the contact is resolved: momentum is kept"
    name = f"{call}: momentum along X after that frame"
    expect_close(name, done["momenta"][hit], speed, cause=cause, read=read, tolerance=1e-9)


@pytest.mark.exercise("G8.1")
def test_what_lies_still_wakes_what_it_touches() -> None:
    read = f"{WAKE}wake_touched"
    for order in ((0, 1), (1, 0)):
        call = f"a particle asleep, and an awake one at rest that touches it, contact of {order}; "
        call += "wake_touched(): who sleeps before, and after a frame"
        cause = "the other one can move: how fast it is, or how deep, makes no difference"
        expect_exactly(call, touched_gently(order), [[0], []], cause=cause, read=read)


@pytest.mark.exercise("G8.1")
def test_what_wakes_still_stands_on_the_ground(rng: Random) -> None:
    read = RUN
    speed = positive_number(rng, 4.0, 9.0)
    call = f"a ball asleep on the ground, another one falls on it at {speed} m/s; run_physics(): "
    call += "velocity and height of the lower one, after the frame in which it wakes"
    cause = "what sleeps has no contact with the ground: look for contacts again when one wakes, "
    cause += "or it is pushed into the ground"
    before, *got = dropped_on(speed)
    expect_exactly(f"{call}: who slept before", before, [0], cause=cause, read=read)
    # Two hundred iterations leave some 1e-9 m/s.
    expect_close(call, got, (0.0, 0.5), cause=cause, read=read, tolerance=1e-6)


@pytest.mark.exercise("G8.1")
def test_what_fell_asleep_as_one_wakes_as_one() -> None:
    read = f"{WAKE}wake, and fall_asleep"
    call = "a ball asleep on another one, which is put elsewhere; wake(), 6 frames"
    cause = "both lie still"
    before, after, speed = support_gone(6)
    expect_exactly(f"{call}: who slept before", before, [0, 1], cause=cause, read=read)
    cause = "what wakes, wakes its neighbours: those that it touched when it fell asleep"
    expect_exactly(f"{call}: does the upper one sleep", 1 in after, False, cause=cause, read=read)
    name = f"{call}: how fast it moves, along Y"
    expect_close(name, speed, -1.0, cause=cause, read=read, tolerance=0.01)
    for pairs in ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)]):
        for first in range(4):
            call = f"five particles, contacts of {pairs} but in the frame in which they fall "
            call += f"asleep; then number {first} moves; wake()"
            was, now = group_woken(pairs, first)
            cause = "they lie still"
            expect_exactly(f"{call}: who slept", was, [0, 1, 2, 3, 4], cause=cause, read=read)
            cause = "neighbours are what was in contact in one of the last sleep_frames frames, of "
            cause += "both sides; all of the group wakes, and nothing else"
            expect_exactly(f"{call}: who sleeps", now, [4], cause=cause, read=read)
    call = "three particles in a row on two springs, asleep; the last one gets 6 m/s; wake()"
    cause = "they rest"
    seen, places = on_a_spring(20)
    expect_exactly(f"{call}: who slept before", seen[0], [0, 1, 2], cause=cause, read=read)
    cause = "what a generator joins is one group, as what touches is: all wake in that very frame"
    expect_exactly(f"{call}: who sleeps after a frame", seen[1], [], cause=cause, read=read)
    cause = "forces of springs are equal and opposite: the middle of the three moves at 2 m/s"
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    name = f"{call}: how far the middle has moved after 20 frames"
    middle = math.fsum(place[0] for place in places) / 3.0 - 1.0
    expect_close(name, middle, drift, cause=cause, read=read, tolerance=1e-9)


@pytest.mark.exercise("G8.1")
def test_what_hangs_still_sleeps_on() -> None:
    read = f"{WAKE}wake_pushed"
    call = "a mass that hangs still on a spring; wake_pushed(): who sleeps in frames 5 to 40"
    cause = "gravity and spring cancel: compare the change with |a| + |f / m|, not with their sum"
    expect_exactly(call, hung(40, 40, 0.0)[4:], [[0]] * 36, cause=cause, read=read)
    call += ", pushed by 0.15 N/kg more from frame 20 on"
    cause = "|a| and |f / m| are 10 m/s^2 each: 0.15 is less than SAME of both together"
    expect_exactly(call, hung(40, 20, 0.15)[4:], [[0]] * 36, cause=cause, read=read)
    call = "a mass that hangs still on a spring, pushed by 0.5 N/kg more from frame 20 on; "
    call += "wake_pushed(): does it wake within 10 frames"
    cause = "that is more than SAME of |a| + |f / m|, which are 10 m/s^2 each"
    expect_exactly(call, [] in hung(31, 20, 0.5)[20:], True, cause=cause, read=read)


@pytest.mark.exercise("G8.1")
def test_what_sleeps_costs_no_work(rng: Random) -> None:
    read = RUN
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    call = f"{count} particles with a generator each, all asleep but {awake}; 20 run_physics()"
    cause = "those that are slow sleep by then"
    asked, given, sleepers = work_asleep(count, awake, 20)
    wanted = [*range(awake, count)]
    expect_exactly(f"{call}: who sleeps", sleepers, wanted, cause=cause, read=read)
    cause = "give the integrator only what is awake"
    name = f"{call}: particles that it was given"
    expect_exactly(name, given, 20 * awake, cause=cause, read=read)
    cause = "the generators of what sleeps are asked in every tenth frame, and once each"
    name = f"{call}: how often generators were asked"
    expect_exactly(name, asked, 20 * awake + 2 * (count - awake), cause=cause, read=read)


@pytest.mark.exercise("G8.1")
def test_sleep_changes_no_rest() -> None:
    read = RUN
    call = "two balls bounce until they lie, by run_physics(): where, with sleep and without"
    cause = "what is asleep would have lain still anyway: is anything put to sleep in mid-air?"
    places, awake, sleepers = both_ways(360)
    for got, wanted in zip(places, awake, strict=True):
        # What falls asleep has 0.17 m/s at most, and damping of 0.5 would end that within 0.25 m.
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=0.25)
        name = f"{call}: how far above the ground"
        expect_close(name, got[1], 0.0, cause=cause, read=read, tolerance=1e-6)
    cause = "in six seconds both have come to rest"
    expect_exactly(f"{call}: how many sleep", sleepers, 2, cause=cause, read=read)


@pytest.mark.exercise("G8.1")
@pytest.mark.robust
def test_a_frame_without_a_duration_is_refused_here_too() -> None:
    read = RUN
    for duration, error in ((0.0, "ValueError"), (math.nan, "ValueError"), ("1", "TypeError")):
        call = f"world.run_physics({duration!r})"
        cause = "positive() refuses it, before anything changes"
        name, force = refused(duration)
        expect_exactly(f"{call}: the error, '' for none", name, error, cause=cause, read=read)
        what = f"{call}: the force that was added before it"
        expect_close(what, force, (1.0, 2.0, 3.0), cause=cause, read=read, tolerance=0.0)
    call, cause = "world.run_physics(0.1)", "what is right must not be refused"
    expect_exactly(f"{call}: the error, '' for none", refused(0.1)[0], "", cause=cause, read=read)
