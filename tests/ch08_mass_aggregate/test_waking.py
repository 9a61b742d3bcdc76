"""Going further, G8.1: what wakes sleeping particles, and what does not."""

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
    new = how.replace("place", "position")
    about.call = f"a particle of 2 kg asleep on the ground gets a new {new}; a step of 1/60 s, "
    about.call += "wake_moved()"
    about.cause = f"A new {new} must wake it. Compare with the values in its Sleep, and call "
    about.cause += "wake_moved before the integrator, so that this step already moves it."
    if how == "nothing":
        about.call = "a particle of 2 kg asleep on the ground; a step of 1/60 s, wake_moved()"
        about.cause = "The particle has not changed, so it must stay asleep. Wake it only if its "
        about.cause += "velocity, position, mass or force differ from those in its Sleep."
    before, got, now, fast = woken_by_hand(how)
    expect_exactly(before, [0], then=": who slept before")
    expect_exactly(got, sleeps, then=": who sleeps afterward")
    about.cause = "A particle that wakes must get its old mass back, unless it was given a new one."
    expect_close(1.0 / now, 1.0 / mass, then=": 1 / mass", tolerance=1e-12)
    about.cause = "Forces and gravity must already move it in this step. Call wake_moved before "
    about.cause += "the integrator."
    expect_close(fast, velocity, then=": velocity", tolerance=1e-12)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("how", ["velocity", "force", "place"])
def test_whatever_is_moved_a_little_wakes(how: str) -> None:
    about.read = f"{WAKE}wake_moved"
    for axis, by in product("xyz", (1e-3, -1e-3)):
        new = how.replace("place", "position")
        about.call = f"three particles asleep on the ground, the {new} of 1 and 2 is changed by "
        about.call += f"{by} along {axis}; a step of 1/60 s, wake_moved()"
        about.cause = "All three particles are at rest, so they must fall asleep."
        before, after = woken_by_little(how, axis, by)
        expect_exactly(before, [0, 1, 2], then=": who slept before")
        about.cause = f"A change of the {new} wakes a particle along every axis, in both "
        about.cause += "directions and however small it is."
        expect_exactly(after, [0], then=": who sleeps afterward")


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
        about.call = "2 kg asleep at a wall under forces of 3 and 2 N/kg; then the second one "
        about.call += f"changes by {change} N/kg along X and Y; wake_pushed()"
        about.cause = "The same forces as before must not wake it. Compare the sum of all its "
        about.cause += "forces, computed while the particle has its own mass."
        done = pushed(*change)
        expect_exactly(done["before"], [0], then=": who slept before")
        about.cause = "After the comparison, clear the accumulator of a sleeping particle and set "
        about.cause += "its inverse_mass back to 0."
        expect_exactly(done["sums"], [(0.0, 0.0, 0.0)], then=": its accumulator while it slept")
        about.cause = "A change of more than SAME, 1 %, of |a| + |f / m| must wake the particle. "
        about.cause += "run_physics calls wake_pushed in every LOOK_EVERY-th step."
        woken = done["velocity"] is not None
        expect_exactly(woken, True, then=": does it wake within 10 steps")
        got = done["velocity"] or (math.nan,) * 3
        about.cause = (
            "The particle must move in the same step in which it wakes, and each force must act "
            "once."
        )
        twice = tuple(2.0 * part for part in velocity)
        if any(velocity):
            seen = "The forces count twice. Clear the accumulator after the comparison."
            blame(got, [(twice, seen)])
        expect_close(
            got, velocity, then=": velocity after the step in which it wakes", tolerance=1e-12
        )
        about.cause = "Pass the duration of the step to the generators."
        expect_exactly(done["durations"], [1.0 / 60.0], then=": the durations that they got")


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_what_is_pushed_otherwise_wakes(old: float, new: float, late: bool) -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = f"2 kg asleep, pushed by {old} N/kg against a wall; then by {new} N/kg; "
    about.call += "wake_pushed()" + (", by a generator that is added" if late else "")
    about.cause = "The wall holds the particle, so it must fall asleep first."
    seen = woken_by_force(old, new, 10, late)
    expect_exactly(seen[0], [0], then=": who slept before")
    about.cause = "Call wake_pushed in every LOOK_EVERY-th step, so within 10. It must evaluate "
    about.cause += "the forces while the particle has its own mass."
    expect_exactly(seen[-1], [], then=": who sleeps after 10 steps")


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_as_before_sleeps_on(rng: Random) -> None:
    push = positive_number(rng, 2.0, 9.0)
    about(f"a particle asleep, pushed by {push} N/kg against a wall", read=f"{WAKE}wake_pushed")
    compare = "Compare with the acceleration that is stored in its Sleep."
    for new in (push, 1.009 * push, 0.991 * push):
        about.cause = f"A change by SAME or less must not wake it. {compare}"
        if new == push:
            about.cause = "The same force as before must not wake it. After the generators were "
            about.cause += f"called, set its inverse_mass back to 0. {compare}"
        seen = woken_by_force(push, new, 25)
        expect_exactly(
            seen,
            [[0]] * 26,
            then=f", then by {new} N/kg; wake_pushed(): who sleeps after each of 25 steps",
        )


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("first", [False, True], ids=["the last in the list", "the first"])
def test_what_is_touched_wakes_with_all_that_it_touches(rng: Random, first: bool) -> None:
    about.read = f"{WAKE}wake_touched, and run_physics"
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"three balls asleep side by side, another one rolls at them at {speed} m/s; "
    about.call += "wake_touched()"
    about.cause = "The three balls are at rest and touch each other, so they must fall asleep."
    done = woken_by_contact(speed, 40, first)
    expect_exactly(done["before"], [0, 1, 2], then=": who slept before")
    about.cause = "The fourth ball is still far away, so nothing may wake."
    expect_exactly(done["seen"][0], [0, 1, 2], then=": who sleeps after one step")
    hit = next((i for i, now in enumerate(done["seen"]) if now != [0, 1, 2]), -1)
    about.cause = "The contact wakes the first ball. Find the contacts again, so that it wakes the "
    about.cause += "next one in the same step, and so on."
    if hit < 0:
        about.cause = "No ball wakes. Check both particles of each contact: a particle that can "
        about.cause += "move wakes a sleeping one."
    expect_exactly(done["seen"][hit], [], then=": who sleeps after the step of the hit")
    about.cause = "Momentum is lost. The balls must have their masses back before the contacts are "
    about.cause += "resolved."
    expect_close(
        done["momenta"][hit], speed, then=": momentum along X after that step", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_lies_still_wakes_what_it_touches() -> None:
    about.read = f"{WAKE}wake_touched"
    for order in ((0, 1), (1, 0)):
        about.call = "particle 0 asleep, particle 1 at rest but awake touches it, contact of "
        about.call += f"{order}; wake_touched(): who sleeps before, and after a step"
        about.cause = "A particle that can move wakes every sleeping particle that it touches, "
        about.cause += "even if it is at rest itself. Check both particles of the contact."
        expect_exactly(touched_gently(order), [[0], []])


@pytest.mark.exercise("G8.1")
def test_what_wakes_still_stands_on_the_ground(rng: Random) -> None:
    about.read = RUN
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"a ball asleep on the ground, another one falls on it at {speed} m/s; "
    about.call += "run_physics(): velocity and height of the lower ball after the step in which it "
    about.call += "wakes"
    about.cause = "The ball is pushed into the ground, because a sleeping ball has no contact with "
    about.cause += "it. Find the contacts again after a particle has woken."
    before, *got = dropped_on(speed)
    expect_exactly(before, [0], then=": who slept before")
    # Two hundred iterations leave some 1e-9 m/s.
    expect_close(got, (0.0, 0.5), tolerance=1e-6)


@pytest.mark.exercise("G8.1")
def test_what_fell_asleep_as_one_wakes_as_one() -> None:
    about.read = f"{WAKE}wake, and fall_asleep"
    about.call = "ball 1 asleep on ball 0, which is moved away by hand; wake(), 6 steps"
    about.cause = "Both balls are at rest, so they must fall asleep."
    before, after, speed = support_gone(6)
    expect_exactly(before, [0, 1], then=": who slept before")
    about.cause = "wake must also wake the neighbors in the Sleep, which touched the particle when "
    about.cause += "it fell asleep. fall_asleep must store them."
    expect_exactly(1 in after, False, then=": does ball 1 still sleep")
    expect_close(speed, -1.0, then=": the vertical velocity of ball 1", tolerance=0.01)
    for pairs in ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)]):
        for first in range(4):
            about.call = f"five particles, contacts of {pairs} except in the step in which they "
            about.call += f"fall asleep; then number {first} gets a velocity; wake()"
            was, now = group_woken(pairs, first)
            about.cause = "All five particles are at rest, so they must fall asleep."
            expect_exactly(was, [0, 1, 2, 3, 4], then=": who slept before")
            about.cause = "The whole group must wake, and nothing else. Wake neighbors of "
            about.cause += "neighbors too, and store as neighbors all that touched in the last "
            about.cause += "sleep_frames steps."
            expect_exactly(now, [4], then=": who sleeps afterward")
    about.call = "three particles in a row on two springs, asleep; the last one gets 6 m/s; wake()"
    about.cause = "All three particles are at rest, so they must fall asleep."
    seen, places = on_a_spring(20)
    expect_exactly(seen[0], [0, 1, 2], then=": who slept before")
    about.cause = "Particles that a generator joins are one group too: use joined(self.registry). "
    about.cause += "All three must wake in the same step."
    expect_exactly(seen[1], [], then=": who sleeps after a step")
    about.cause = "The forces of a spring are equal and opposite, so the center of mass of the "
    about.cause += "three must move at 2 m/s."
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    middle = math.fsum(place[0] for place in places) / 3.0 - 1.0
    expect_close(
        middle, drift, then=": displacement of the center of mass after 20 steps", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_hangs_still_sleeps_on() -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = "a mass that hangs still on a spring; wake_pushed(): who sleeps in steps 5 to 40"
    about.cause = "Gravity and the spring cancel, so a + f / m is almost 0. Compare the change "
    about.cause += "with |a| + |f / m| and not with |a + f / m|."
    expect_exactly(hung(40, 40, 0.0)[4:], [[0]] * 36)
    about.call += ", with an extra push of 0.15 N/kg from step 20 on"
    about.cause = "|a| + |f / m| is 20 m/s^2, and 0.15 is less than SAME times that. Let it sleep."
    expect_exactly(hung(40, 20, 0.15)[4:], [[0]] * 36)
    about.call = "a mass that hangs still on a spring, with an extra push of 0.5 N/kg from step 20 "
    about.call += "on; wake_pushed(): does it wake within 10 steps"
    about.cause = "|a| + |f / m| is 20 m/s^2, and 0.5 is more than SAME times that. Wake it."
    expect_exactly([] in hung(31, 20, 0.5)[20:], True)


@pytest.mark.exercise("G8.1")
def test_what_sleeps_costs_no_work(rng: Random) -> None:
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    about.call = f"{count} particles with a generator each, all at rest except {awake}; 20 calls "
    about.call += "of run_physics()"
    about(cause="All particles at rest must sleep by now.", read=RUN)
    asked, given, sleepers = work_asleep(count, awake, 20)
    wanted = [*range(awake, count)]
    expect_exactly(sleepers, wanted, then=": who sleeps")
    about.cause = "Give the integrator only the particles that are awake."
    expect_exactly(
        given, 20 * awake, then=": particles given to the integrator, in all steps together"
    )
    about.cause = "Evaluate the generators of sleeping particles only in every tenth step, and "
    about.cause += "once."
    expect_exactly(asked, 20 * awake + 2 * (count - awake), then=": calls of update_force in all")


@pytest.mark.exercise("G8.1")
def test_sleep_changes_no_rest() -> None:
    about.read = RUN
    about.call = "two balls bounce until they rest, by run_physics(): position, compared with a "
    about.call += "run without sleep"
    about.cause = "A particle was put to sleep while it was still moving. Only particles at rest "
    about.cause += "may sleep."
    places, awake, sleepers = both_ways(360)
    for got, wanted in zip(places, awake, strict=True):
        # A ball that falls asleep has at most 0.17 m/s. Damping of 0.5 would stop it within 0.25 m.
        expect_close(got, wanted, tolerance=0.25)
        expect_close(got[1], 0.0, then=": height above the ground", tolerance=1e-6)
    about.cause = "After six seconds both balls are at rest, so they must sleep."
    expect_exactly(sleepers, 2, then=": number of sleepers")


@pytest.mark.exercise("G8.1")
@pytest.mark.robust
def test_a_frame_without_a_duration_is_refused_here_too() -> None:
    about.read = RUN
    for duration, error in ((0.0, "ValueError"), (math.nan, "ValueError"), ("1", "TypeError")):
        about.call = f"world.run_physics({duration!r})"
        about.cause = 'Check it before anything changes: positive("duration", duration).'
        name, force = refused(duration)
        expect_exactly(name, error, then=": the error raised ('' is none)")
        what = f"{about.call}: the force that was added before"
        expect_close(force, (1.0, 2.0, 3.0), call=what, tolerance=0.0)
    about("world.run_physics(0.1)", cause="A valid duration must not be rejected.")
    expect_exactly(refused(0.1)[0], "", then=": the error raised ('' is none)")
