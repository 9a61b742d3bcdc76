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
    about.call = f"a particle of 2 kg that sleeps on the ground gets a new {new}; a step of 1/60 "
    about.call += "s, wake_moved()"
    about.cause = f"A particle that gets a new {new} must wake, and move in this very step. In "
    about.cause += "wake_moved, compare it with the values stored in its Sleep, and call "
    about.cause += "wake_moved before the integrator."
    if how == "nothing":
        about.call = "a particle of 2 kg that sleeps on the ground; a step of 1/60 s, wake_moved()"
        about.cause = "Nothing about the particle has changed, so it should stay asleep. Wake it "
        about.cause += "only if its velocity, position, mass or force differs from the values "
        about.cause += "stored in its Sleep."
    before, got, now, fast = woken_by_hand(how)
    expect_exactly(before, [0], then=": who slept before")
    expect_exactly(got, sleeps, then=": who sleeps afterward")
    about.cause = (
        "The particle has the wrong mass. When it wakes, give it back the mass that it had before "
        "it fell asleep, unless it has been given a new one in the meantime."
    )
    expect_close(1.0 / now, 1.0 / mass, then=": 1 / mass", tolerance=1e-12)
    about.cause = "When a particle wakes, its forces and gravity should move it in that same "
    about.cause += "step. Call wake_moved before the integrator."
    expect_close(fast, velocity, then=": velocity", tolerance=1e-12)


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize("how", ["velocity", "force", "place"])
def test_whatever_is_moved_a_little_wakes(how: str) -> None:
    about.read = f"{WAKE}wake_moved"
    for axis, by in product("xyz", (1e-3, -1e-3)):
        new = how.replace("place", "position")
        about.call = f"three particles that sleep on the ground; the {new} of particles 1 and 2 "
        about.call += f"is changed by {by} along {axis}; a step of 1/60 s, wake_moved()"
        about.cause = (
            "All three particles are at rest, but they have not all fallen asleep. Check "
            "fall_asleep before you work on waking."
        )
        before, after = woken_by_little(how, axis, by)
        expect_exactly(before, [0, 1, 2], then=": who slept before")
        about.cause = f"Any change in the {new} should wake a particle, however small. Compare "
        about.cause += "all three components, and remember that a change can be negative."
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
        about.call = "a particle of 2 kg that sleeps at a wall under forces of 3 and 2 N/kg; "
        about.call += f"then the second one changes by {change} N/kg along X and Y; wake_pushed()"
        about.cause = "The particle is still under the same forces, so it should not wake. "
        about.cause += "Compare the sum of all its forces with the stored value, and evaluate the "
        about.cause += "forces while the particle has its own mass."
        done = pushed(*change)
        expect_exactly(done["before"], [0], then=": who slept before")
        about.cause = "The forces that you evaluated for the comparison are still in the "
        about.cause += "accumulator. If the particle stays asleep, clear its accumulator and set "
        about.cause += "its inverse_mass back to 0."
        expect_exactly(done["sums"], [(0.0, 0.0, 0.0)], then=": its accumulator while it slept")
        about.cause = "The forces have changed by more than SAME (1 %) of |a| + |f / m|, so the "
        about.cause += "particle should wake. Call wake_pushed in every LOOK_EVERY-th step of "
        about.cause += "run_physics."
        woken = done["velocity"] is not None
        expect_exactly(woken, True, then=": does it wake within 10 steps")
        got = done["velocity"] or (math.nan,) * 3
        about.cause = "The particle should move in the same step in which it wakes, and each "
        about.cause += "force should act on it exactly once. Call wake_pushed before the "
        about.cause += "integrator, and clear the accumulators after the comparison."
        twice = tuple(2.0 * part for part in velocity)
        if any(velocity):
            seen = "The forces act twice, because they are still in the accumulator when the "
            seen += "integrator adds them again. Clear the accumulator after you have compared."
            blame(got, [(twice, seen)])
        expect_close(
            got, velocity, then=": velocity after the step in which it wakes", tolerance=1e-12
        )
        about.cause = (
            "You called the generators with the wrong duration. Pass the duration of the step on "
            "to them."
        )
        expect_exactly(done["durations"], [1.0 / 60.0], then=": the durations that they got")


@pytest.mark.exercise("G8.1")
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_what_is_pushed_otherwise_wakes(old: float, new: float, late: bool) -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = (
        f"a particle of 2 kg that sleeps, pushed by {old} N/kg against a wall; then by {new} N/kg; "
    )
    about.call += "wake_pushed()" + (", by a generator that is added" if late else "")
    about.cause = "The wall holds the particle, so it is at rest and should fall asleep first."
    seen = woken_by_force(old, new, 10, late)
    expect_exactly(seen[0], [0], then=": who slept before")
    about.cause = "The force has changed, so the particle should wake within 10 steps. Call "
    about.cause += "wake_pushed in every LOOK_EVERY-th step, and evaluate the forces there while "
    about.cause += "the particle has its own mass."
    expect_exactly(seen[-1], [], then=": who sleeps after 10 steps")


@pytest.mark.exercise("G8.1")
def test_what_is_pushed_as_before_sleeps_on(rng: Random) -> None:
    push = positive_number(rng, 2.0, 9.0)
    about(
        f"a particle that sleeps, pushed by {push} N/kg against a wall", read=f"{WAKE}wake_pushed"
    )
    compare = "Compare the acceleration with the one stored in the particle's Sleep."
    for new in (push, 1.009 * push, 0.991 * push):
        about.cause = (
            "The force has changed by no more than SAME, so the particle should not wake. "
            f"{compare}"
        )
        if new == push:
            about.cause = "The force is the same as before, so the particle should not wake. "
            about.cause += "After you have called the generators, set its inverse_mass back to 0. "
            about.cause += f"{compare}"
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
    about.call = f"three balls sleep side by side, and another one rolls at them at {speed} m/s; "
    about.call += "wake_touched()"
    about.cause = (
        "The three balls are at rest and touch only each other, so they should fall asleep."
    )
    done = woken_by_contact(speed, 40, first)
    expect_exactly(done["before"], [0, 1, 2], then=": who slept before")
    about.cause = (
        "The fourth ball is still far away and touches nothing, so no ball should wake yet."
    )
    expect_exactly(done["seen"][0], [0, 1, 2], then=": who sleeps after one step")
    hit = next((i for i, now in enumerate(done["seen"]) if now != [0, 1, 2]), -1)
    about.cause = "The contact woke only some of the balls. A ball that wakes may touch the next "
    about.cause += "one, so keep finding contacts until no more balls wake in this step."
    if hit < 0:
        about.cause = "No ball wakes, although a moving ball touches a sleeping one. If one "
        about.cause += "particle of a contact can move and the other is asleep, wake the sleeper. "
        about.cause += "It can be either of the two, so check both."
    expect_exactly(done["seen"][hit], [], then=": who sleeps after the step of the hit")
    about.cause = "Momentum has been lost. A sleeping ball acts like a wall, so give all balls "
    about.cause += "that wake their masses back before you resolve the contacts."
    expect_close(
        done["momenta"][hit], speed, then=": momentum along X after that step", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_lies_still_wakes_what_it_touches() -> None:
    about.read = f"{WAKE}wake_touched"
    for order in ((0, 1), (1, 0)):
        about.call = "particle 1 is at rest but awake, and it touches particle 0, which sleeps, "
        about.call += f"in a contact of {order}; wake_touched(): who sleeps before the step, and "
        about.call += "after it"
        about.cause = "A particle that can move wakes every sleeping particle that it touches, "
        about.cause += "even if it is itself at rest. The sleeper can be either particle of a "
        about.cause += "contact, so check both."
        expect_exactly(touched_gently(order), [[0], []])


@pytest.mark.exercise("G8.1")
def test_what_wakes_still_stands_on_the_ground(rng: Random) -> None:
    about.read = RUN
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"a ball sleeps on the ground, and another one falls on it at {speed} m/s; "
    about.call += "run_physics(): the velocity and the height of the lower ball after the step in "
    about.call += "which it wakes"
    about.cause = "The lower ball got pushed into the ground. While it slept, it had no contact "
    about.cause += "with the ground, so find the contacts again after a particle has woken."
    before, *got = dropped_on(speed)
    expect_exactly(before, [0], then=": who slept before")
    # Two hundred iterations leave some 1e-9 m/s.
    expect_close(got, (0.0, 0.5), tolerance=1e-6)


@pytest.mark.exercise("G8.1")
def test_what_fell_asleep_as_one_wakes_as_one() -> None:
    about.read = f"{WAKE}wake, and fall_asleep"
    about.call = "ball 1 sleeps on ball 0, which is then moved away by hand; wake(), 6 steps"
    about.cause = (
        "Both balls are at rest, but they have not both fallen asleep. Check fall_asleep before "
        "you work on waking."
    )
    before, after, speed = support_gone(6)
    expect_exactly(before, [0, 1], then=": who slept before")
    about.cause = "Ball 0 wakes when it is moved, so ball 1 should wake with it and fall. In "
    about.cause += "fall_asleep, store the neighbors that touch a particle in its Sleep, and let "
    about.cause += "wake continue with them."
    expect_exactly(1 in after, False, then=": does ball 1 still sleep")
    expect_close(speed, -1.0, then=": the vertical velocity of ball 1", tolerance=0.01)
    for pairs in ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)]):
        for first in range(4):
            about.call = f"five particles with contacts of {pairs}, except in the step in which "
            about.call += f"they fall asleep; then particle {first} gets a velocity; wake()"
            was, now = group_woken(pairs, first)
            about.cause = "Not all particles have fallen asleep, although all five are at rest. "
            about.cause += "Check fall_asleep before you work on wake."
            expect_exactly(was, [0, 1, 2, 3, 4], then=": who slept before")
            about.cause = "The wrong particles are awake. Wake the whole group, including "
            about.cause += "neighbors of neighbors, but no other particle. A particle's neighbors "
            about.cause += "are all the particles that it has touched in the last sleep_frames "
            about.cause += "steps."
            expect_exactly(now, [4], then=": who sleeps afterward")
    about.call = (
        "three particles in a row sleep on two springs, and the last one gets 6 m/s; wake()"
    )
    about.cause = (
        "All three particles are at rest, but they have not all fallen asleep. Check fall_asleep "
        "before you work on waking."
    )
    seen, places = on_a_spring(20)
    expect_exactly(seen[0], [0, 1, 2], then=": who slept before")
    about.cause = "Some particles are still asleep. Particles that share a generator form a "
    about.cause += "group, so all three should wake in the same step. joined(self.registry) tells "
    about.cause += "you which particles share a generator."
    expect_exactly(seen[1], [], then=": who sleeps after a step")
    about.cause = "The center of mass should move at 2 m/s, because the forces of a spring are "
    about.cause += "equal and opposite. Perhaps one particle was still asleep while the others "
    about.cause += "moved. Wake all three in the same step."
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    middle = math.fsum(place[0] for place in places) / 3.0 - 1.0
    expect_close(
        middle, drift, then=": displacement of the center of mass after 20 steps", tolerance=1e-9
    )


@pytest.mark.exercise("G8.1")
def test_what_hangs_still_sleeps_on() -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = "a mass that hangs from a spring, almost at rest; wake_pushed(): who sleeps in "
    about.call += "steps 5 to 40"
    about.cause = "Gravity and the spring force cancel, so a + f / m is almost 0, and any change "
    about.cause += "looks large next to it. Compare the change with |a| + |f / m| instead."
    expect_exactly(hung(40, 40, 0.0)[4:], [[0]] * 36)
    about.call += ", with an extra push of 0.15 N/kg from step 20 on"
    about.cause = "Here |a| + |f / m| is 20 m/s^2, so a change of up to 0.2 m/s^2 (SAME times "
    about.cause += "this sum) wakes nothing. The push of 0.15 N/kg is weaker than that, so the "
    about.cause += "mass should stay asleep."
    expect_exactly(hung(40, 20, 0.15)[4:], [[0]] * 36)
    about.call = "a mass that hangs from a spring, almost at rest, with an extra push of 0.5 "
    about.call += "N/kg from step 20 on; wake_pushed(): does it wake within 10 steps"
    about.cause = "Here |a| + |f / m| is 20 m/s^2, so a change of more than 0.2 m/s^2 (SAME times "
    about.cause += "this sum) wakes the mass. The push of 0.5 N/kg is stronger than that, so the "
    about.cause += "mass should wake."
    expect_exactly([] in hung(31, 20, 0.5)[20:], True)


@pytest.mark.exercise("G8.1")
def test_what_sleeps_costs_no_work(rng: Random) -> None:
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    about.call = f"{count} particles with one generator each, all at rest except for {awake}; 20 "
    about.call += "calls of run_physics()"
    about(
        cause="Some of the particles at rest are still awake. All of them should be asleep by now.",
        read=RUN,
    )
    asked, given, sleepers = work_asleep(count, awake, 20)
    wanted = [*range(awake, count)]
    expect_exactly(sleepers, wanted, then=": who sleeps")
    about.cause = "You passed sleeping particles to the integrator, which costs time and has no "
    about.cause += "effect. Pass only those that are awake."
    expect_exactly(
        given,
        20 * awake,
        then=": the number of particles given to the integrator, in all steps together",
    )
    about.cause = "Evaluate the generators of particles that are awake once per step. Evaluate "
    about.cause += "those of sleeping particles only in every tenth step, and only once."
    expect_exactly(
        asked, 20 * awake + 2 * (count - awake), then=": the number of calls of update_force"
    )


@pytest.mark.exercise("G8.1")
def test_sleep_changes_no_rest() -> None:
    about.read = RUN
    about.call = "two balls bounce until they rest, by run_physics(): their positions, compared "
    about.call += "with a run without sleep"
    about.cause = "You put a ball to sleep while it was still moving, so it stopped too early. "
    about.cause += "Only particles that have come to rest should fall asleep."
    places, awake, sleepers = both_ways(360)
    for got, wanted in zip(places, awake, strict=True):
        # A ball that falls asleep has at most 0.17 m/s. Damping of 0.5 would stop it within 0.25 m.
        expect_close(got, wanted, tolerance=0.25)
        expect_close(got[1], 0.0, then=": height above the ground", tolerance=1e-6)
    about.cause = "After six seconds both balls are at rest, so both should be asleep."
    expect_exactly(sleepers, 2, then=": the number of sleepers")


@pytest.mark.exercise("G8.1")
@pytest.mark.robust
def test_a_frame_without_a_duration_is_refused_here_too() -> None:
    about.read = RUN
    for duration, error in ((0.0, "ValueError"), (math.nan, "ValueError"), ("1", "TypeError")):
        about.call = f"world.run_physics({duration!r})"
        about.cause = (
            'The duration must be positive and finite. Check it with positive("duration", '
            "duration) before anything changes."
        )
        name, force = refused(duration)
        expect_exactly(name, error, then=": the name of the error ('' if there was none)")
        what = f"{about.call}: the force that was added before"
        expect_close(force, (1.0, 2.0, 3.0), call=what, tolerance=0.0)
    about(
        "world.run_physics(0.1)",
        cause="This duration is valid, so don't raise an error.",
    )
    expect_exactly(refused(0.1)[0], "", then=": the name of the error ('' if there was none)")
