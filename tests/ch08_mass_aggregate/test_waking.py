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
    support_gone,
    woken_by_contact,
    woken_by_force,
    woken_by_hand,
    work_asleep,
)
from ch08_mass_aggregate.wake_probes import group_woken, pushed, touched_gently, woken_by_little
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly, expect_that
from sleepers import awake_in, expect_asleep, expect_sleepers, expect_sleepers_of_steps

WAKE = "the docstring of SleepingWorld."
RUN = "the docstring of SleepingWorld.run_physics"
TENTH = ", every tenth of which calls wake_pushed()"
NEVER = "The particle is at rest, but it has not fallen asleep. Check fall_asleep first."
UNITS = {"velocity": "m/s", "force": "N", "place": "m"}
SIGNS = {
    "velocity": "its velocity is no longer 0",
    "force": "its force_accumulator is no longer 0",
    "place": "its position differs from the one stored in self.asleep",
    "mass": "its inverse_mass is no longer 0",
}


@pytest.mark.exercise("G8.1", asks="that code outside the world has changed")
@pytest.mark.parametrize(
    ("how", "sleeps", "mass", "velocity"),
    [
        ("nothing", [0], math.inf, (0.0, 0.0, 0.0)),
        ("velocity", [], 2.0, (3.0, 0.0, 0.0)),
        ("force", [], 2.0, (0.5, 0.0, 0.0)),
        ("place", [], 2.0, (0.0, -1.0 / 6.0, 0.0)),
        ("mass", [], 4.0, (0.0, 0.0, 0.0)),
    ],
    ids=["nothing", "velocity", "force", "place", "mass"],
)
def test_a_changed_particle_wakes(
    how: str, sleeps: list[int], mass: float, velocity: tuple[float, float, float]
) -> None:
    about.read = f"{WAKE}wake_moved"
    new = how.replace("place", "position")
    about.call = f"particle 0, of 2 kg, sleeps on the ground and gets a new {new}; one step of "
    about.call += "1/60 s, which calls wake_moved()"
    why = f"A sleeping particle doesn't wake when its {new} changes. In wake_moved, also "
    why += f"check whether {SIGNS.get(how)}."
    if how == "nothing":
        about.call = "particle 0, of 2 kg, sleeps on the ground, and nothing about it changes; one "
        about.call += "step of 1/60 s, which calls wake_moved()"
        why = "Your particle wakes although nothing about it has changed. Wake it only if its "
        why += "velocity, position, mass or force has changed since it fell asleep."
    about.cause = why
    before, got, now, fast = woken_by_hand(how)
    about.cause = NEVER
    expect_sleepers(before, [0], then="; which particles are asleep before that")
    about.cause = why
    expect_sleepers(got, sleeps, then="; which particles are asleep afterward")
    about.cause = "Your particle has the wrong mass after it wakes. Restore the mass that it "
    about.cause += "had before it fell asleep."
    if how == "mass":
        about.cause = "Your wake method overwrites the new mass with the old one. Restore the old "
        about.cause += "mass only if the particle still has an infinite mass."
    then = "; the inverse mass of the particle, in 1/kg"
    expect_close(1.0 / now, 1.0 / mass, then=then, tolerance=1e-12)
    about.cause = "Your particle wakes too late to move in this step. Call wake_moved before the "
    about.cause += "integrator."
    if how == "force" and any(woken_by_hand("place")[3]):  # which wakes in time
        about.cause = "The force is lost. If wake_moved removes it from the accumulator to check "
        about.cause += "it, add it again."
    expect_close(fast, velocity, then="; particle.velocity", unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("G8.1", asks="if any of this is no longer true")
@pytest.mark.parametrize("how", ["velocity", "force", "place"])
def test_a_slightly_changed_particle_wakes(how: str) -> None:
    about.read = f"{WAKE}wake_moved"
    for axis, by in product("xyz", (1e-3, -1e-3)):
        new = how.replace("place", "position")
        about.call = f"particles 0, 1 and 2 sleep on the ground; the {axis} component of the {new} "
        about.call += f"of particles 1 and 2 changes by {by} {UNITS[how]}; one step of 1/60 s, "
        about.call += "which calls wake_moved()"
        about.cause = "All three particles are at rest, but they have not all fallen asleep. Check "
        about.cause += "fall_asleep first."
        before, after = woken_by_little(how, axis, by)
        expect_sleepers(before, [0, 1, 2], then="; which particles are asleep before that")
        about.cause = f"You don't detect a change of the {axis} component of the {new}. Compare "
        about.cause += "all three components."
        if by < 0.0:
            about.cause = f"You detect a new {new} only if a component increases. A component can "
            about.cause += "also decrease, so test whether it has changed at all."
        if after in ([0, 1], [0, 2]):
            about.cause = f"You wake only one of the two particles with a new {new}. Check every "
            about.cause += "sleeping particle."
        elif 0 not in after:
            about.cause = "You also wake particle 0, although nothing about it has changed."
        expect_sleepers(after, [0], then="; which particles are asleep afterward")


@pytest.mark.exercise("G8.1", asks="must be empty again when it returns")
def test_a_pushed_particle_moves_in_the_same_step(rng: Random) -> None:
    about.read = f"{WAKE}wake_pushed"
    x, y = -positive_number(rng, 6.0, 9.0), positive_number(rng, 0.2, 0.9)
    for change, velocity in (
        ((x, 0.0), ((5.0 + x) / 60.0, 0.0, 0.0)),
        ((0.0, y), (0.0, y / 60.0, 0.0)),
        ((0.1, 0.0), (0.0, 0.0, 0.0)),
        ((-0.1, 0.0), (0.0, 0.0, 0.0)),
    ):
        about.call = "two forces of 6 N and 4 N along X push particle 0, of 2 kg, against a wall; "
        about.call += f"40 steps of 1/60 s{TENTH}"
        about.cause = "You call the force generators while the particle's mass is infinite. "
        about.cause += "Restore its own mass during these calls, because a generator may use it."
        done = pushed(*change)
        about.cause = "Particle 0 is awake although it is at rest and the forces on it are still "
        about.cause += "the same. Wake it only if its acceleration a + f / m differs from the one "
        about.cause += "stored in self.asleep."
        expect_sleepers(done["before"], [0], then="; which particles are asleep")
        about.cause = "The forces that you evaluated for the comparison are still in the "
        about.cause += "accumulator. If the particle stays asleep, clear the accumulator and set "
        about.cause += "inverse_mass back to 0."
        name = "; all values of particle.force_accumulator while the particle was asleep"
        expect_exactly(done["sums"], [(0.0, 0.0, 0.0)], then=name)
        force = f"({4.0 + 2.0 * change[0]:g}, {2.0 * change[1]:g}, 0)"
        about.call += f"; the second force changes from (4, 0, 0) to {force} N; 10 more steps"
        about.cause = "Your particle stays asleep although the forces on it have changed by more "
        about.cause += (
            "than SAME, which is 1%. Wake it in wake_pushed, which run_physics must call "
        )
        about.cause += "every LOOK_EVERY steps."
        woken = done["velocity"] is not None
        expect_that(woken, "it stays asleep", "it wakes", then="; whether particle 0 wakes")
        got = done["velocity"] or (math.nan,) * 3
        about.cause = "The particle wakes too late to move in this step. Call wake_pushed before "
        about.cause += "the integrator."
        twice = tuple(2.0 * part for part in velocity)
        if any(velocity):
            seen = "The forces act twice, because they are still in the accumulator when the "
            seen += "integrator adds them again. Clear the accumulator after your comparison."
            blame(got, [(twice, seen)])
        name = "; the velocity of particle 0 after the step in which it wakes"
        expect_close(got, velocity, then=name, unit="m/s", tolerance=1e-12)
        about.cause = "You call the force generators with the wrong duration. Pass the duration of "
        about.cause += "the step on to them."
        name = "; the durations that the generators got"
        expect_exactly(done["durations"], [1.0 / 60.0], then=name)


@pytest.mark.exercise("G8.1", asks="acceleration has changed since it fell asleep")
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_a_changed_force_wakes_a_particle(old: float, new: float, late: bool) -> None:
    about.read = f"{WAKE}wake_pushed"
    how = "a new generator adds a force of" if late else "the force changes to"
    about.call = "particle 0, of 2 kg, sleeps next to a wall, under a force of "
    about.call += f"{2.0 * old:g} N along X; then {how} {2.0 * new:g} N along X; steps{TENTH}"
    about.cause = "The wall holds the particle, so it is at rest. Let it fall asleep before the "
    about.cause += "force changes."
    seen = woken_by_force(old, new, 10, late)
    expect_sleepers(seen[0], [0], then="; which particles are asleep before that")
    about.cause = "Your particle stays asleep although the force on it has changed. Wake it in "
    about.cause += "wake_pushed, which run_physics must call every LOOK_EVERY steps."
    expect_sleepers(seen[-1], [], then="; which particles are asleep after 10 steps")


@pytest.mark.exercise("G8.1", asks="The particle wakes if the change is more than")
def test_an_unchanged_force_wakes_no_particle(rng: Random) -> None:
    push = positive_number(rng, 2.0, 9.0)
    about(
        f"particle 0, of 2 kg, sleeps while a force of {2.0 * push:g} N pushes it against a wall",
        read=f"{WAKE}wake_pushed",
    )
    for new in (push, 1.009 * push, 0.991 * push):
        about.cause = "Your particle wakes although the force has changed by less than SAME, which "
        about.cause += "is 1%. Wake it only if its acceleration changes by more than that."
        if new == push:
            about.cause = "Your particle wakes although its force is unchanged. Set inverse_mass "
            about.cause += "back to 0 after you have called the generators in wake_pushed."
        seen = woken_by_force(push, new, 25)
        if seen[0] != [0]:
            about.cause = NEVER
        then = f"; the force {'stays at' if new == push else 'changes to'} {2.0 * new:.6g} N; 25 "
        then += f"steps{TENTH}; whether particle 0 is asleep after each step"
        expect_asleep([i for i, one in enumerate(seen) if one != [0]], then=then)


@pytest.mark.exercise("G8.1", asks="in contact with a particle that can move")
@pytest.mark.parametrize("first", [False, True], ids=["the last in the list", "the first"])
def test_a_touched_group_wakes(rng: Random, first: bool) -> None:
    about.read = f"{WAKE}wake_touched, and run_physics"
    speed = positive_number(rng, 4.0, 9.0)
    about.call = "particles 0, 1 and 2 sleep side by side; particle 3 moves toward them at "
    about.call += f"{speed} m/s; steps of 1/60 s, each of which calls wake_touched()"
    about.cause = "Particles 0, 1 and 2 are at rest and touch only each other, so they should fall "
    about.cause += "asleep. Check fall_asleep first."
    done = woken_by_contact(speed, 40, first)
    expect_sleepers(done["before"], [0, 1, 2], then="; which particles are asleep before that")
    about.cause = "Particle 3 is still far away, so no particle should wake yet. Wake a particle "
    about.cause += "only when another one touches it."
    expect_sleepers(done["seen"][0], [0, 1, 2], then="; which particles are asleep after one step")
    hit = next((i for i, now in enumerate(done["seen"]) if now != [0, 1, 2]), -1)
    about.cause = "Only some of the particles wake. A particle that wakes can touch the next one, "
    about.cause += "so go through the contacts again until no more particles wake in this step."
    if hit < 0:
        about.cause = "No particle wakes, although particle 3 hits a sleeping one. "
        about.cause += (
            "The sleeper may also be contact.other, so check both particles of a contact."
            if first
            else "Wake the sleeping particle of a contact if the other one can move."
        )
    expect_sleepers(done["seen"][hit], [], then="; which particles are asleep after the hit")
    about.cause = "Particle 3 bounces off a sleeping particle as if it were a wall, so momentum is "
    about.cause += "lost. Call wake_touched before you resolve the contacts."
    expect_close(
        done["momenta"][hit],
        speed,
        then="; the total momentum along X after the step in which particle 3 hits another",
        unit="kg m/s",
        tolerance=1e-9,
    )


@pytest.mark.exercise("G8.1", asks="in contact with a particle that can move")
def test_a_resting_particle_wakes_a_sleeper() -> None:
    about.read = f"{WAKE}wake_touched"
    for order in ((0, 1), (1, 0)):
        about.call = f"particle 0 sleeps; particle 1 is at rest but awake; a contact of {order}; "
        about.call += "wake_touched(); which particles are asleep before it (step 1) and after it "
        about.call += "(step 2)"
        about.cause = "Your particle 0 should wake, because particle 1 can move, even though it is "
        about.cause += "at rest. The sleeper can be either particle of a contact, so check both."
        expect_sleepers_of_steps(touched_gently(order), [[0], []])


@pytest.mark.exercise("G8.1", asks="If a contact wakes a particle, find the contacts")
def test_a_woken_particle_stays_on_the_ground(rng: Random) -> None:
    about.read = RUN
    speed = positive_number(rng, 4.0, 9.0)
    about.call = f"particle 0 sleeps on the ground; particle 1 falls on particle 0 at {speed} m/s; "
    about.call += "run_physics(), which wakes particle 0"
    about.cause = "Particle 0 is pushed into the ground, because a sleeping particle has no "
    about.cause += "contact with the ground. Find the contacts again after particle 0 has woken."
    before, *got = dropped_on(speed)
    expect_sleepers(before, [0], then="; which particles are asleep before that", cause=NEVER)
    # Two hundred iterations leave some 1e-9 m/s.
    then = "; the vertical velocity of particle 0"
    expect_close(got[0], 0.0, then=then, unit="m/s", tolerance=1e-6)
    expect_close(got[1], 0.5, then="; the height of particle 0", unit="m", tolerance=1e-6)


@pytest.mark.exercise("G8.1", asks="fell asleep together therefore wake together")
def test_a_group_wakes_together() -> None:
    about.read = f"{WAKE}wake, and fall_asleep"
    about.call = "particle 1 sleeps on top of particle 0; particle 0 is moved away; 6 steps, the "
    about.call += "first of which calls wake()"
    about.cause = "Both particles are at rest, but not both are asleep. Check fall_asleep first."
    before, after, speed = support_gone(6)
    expect_sleepers(before, [0, 1], then="; which particles are asleep before that")
    about.cause = "Particle 1 stays asleep although its neighbor, particle 0, wakes. In "
    about.cause += "fall_asleep, store a particle's neighbors in its Sleep, and let wake continue "
    about.cause += "with them."
    if 0 in support_gone(1)[1]:  # later it sleeps again
        about.cause = "Particle 0 stays asleep although it was moved. Check wake_moved first."
    expect_that(1 not in after, "it is asleep", "it is awake", then="; whether particle 1 is awake")
    about.cause = "Particle 1 should start to fall in the step in which particle 0 wakes. Wake "
    about.cause += "both in the same step, before you call the integrator."
    expect_close(speed, -1.0, then="; particle 1's velocity along Y", unit="m/s", tolerance=0.01)
    for pairs in ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)]):
        for first in range(4):
            about.call = f"particles 0 to 4 sleep; earlier, these pairs were in contact: {pairs}; "
            about.call += f"particle {first} is set in motion; one step, which calls wake()"
            was, now = group_woken(pairs, first)
            about.cause = "Not all five particles fall asleep, although all are at rest. Check "
            about.cause += "fall_asleep before you work on wake."
            expect_sleepers(was, [0, 1, 2, 3, 4], then="; which particles are asleep before that")
            about.cause = "You wake particle 4, which is not a neighbor. Wake only neighbors."
            if 4 in now:
                about.cause = "You wake only part of the group. Wake the neighbors of every "
                about.cause += "particle that wakes."
            expect_sleepers(now, [4], then="; which particles are asleep afterward")
    about.call = "particles 0, 1 and 2 sleep in a row, joined by two springs; particle 2 is set "
    about.call += "in motion at 6 m/s; steps of 1/60 s, the first of which calls wake()"
    about.cause = "All three particles are at rest, but they have not all fallen asleep. Check "
    about.cause += "fall_asleep first."
    seen, places = on_a_spring(20)
    expect_sleepers(seen[0], [0, 1, 2], then="; which particles are asleep before that")
    about.cause = "Some particles stay asleep although springs connect them to particle 2. In "
    about.cause += "fall_asleep, also treat the pairs in joined(self.registry) as neighbors."
    expect_sleepers(seen[1], [], then="; which particles are asleep after one step")
    about.cause = "Your center of mass doesn't move at 2 m/s, probably because one particle is "
    about.cause += "still asleep while the others move. Wake all three in the same step."
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    middle = math.fsum(place[0] for place in places) / 3.0 - 1.0
    expect_close(
        middle,
        drift,
        then="; how far the center of mass moves in 20 steps",
        unit="m",
        tolerance=1e-9,
    )


@pytest.mark.exercise("G8.1", asks="the current |a| + |f / m| or the magnitude")
def test_a_hanging_particle_stays_asleep() -> None:
    about.read = f"{WAKE}wake_pushed"
    about.call = f"particle 0 hangs from a spring and is almost at rest; 40 steps{TENTH}"
    about.cause = "You compare the change with |a + f / m|, which is almost 0 because gravity and "
    about.cause += "the spring force cancel. Compare it with |a| + |f / m| instead."
    steps = "; whether particle 0 is asleep after each step from step 5 on"
    awake = awake_in(hung(40, 40, 0.0))
    if len(awake) == 36:
        about.cause = NEVER
    expect_asleep(awake, then=steps)
    about.call += "; from step 20 on, an extra force of 0.15 N pushes the particle of 1 kg"
    about.cause = "Your particle wakes although 0.15 m/s^2 is less than SAME times |a| + |f / m|, "
    about.cause += "which is 0.2 m/s^2 here. Wake it only at a larger change."
    expect_asleep(awake_in(hung(40, 20, 0.15)), then=steps)
    about.call = "particle 0 hangs from a spring and is almost at rest; from step 20 on, an extra "
    about.call += f"force of 0.5 N pushes the particle of 1 kg; 10 steps{TENTH}"
    about.cause = "Your particle stays asleep although 0.5 m/s^2 is more than SAME times |a| + |f "
    about.cause += "/ m|, which is 0.2 m/s^2 here. Wake it at such a change."
    wakes = [] in hung(31, 20, 0.5)[20:]
    expect_that(wakes, "it stays asleep", "it wakes", then="; whether particle 0 wakes")


@pytest.mark.exercise("G8.1", asks="with only the particles that are awake")
def test_sleeping_particles_cost_no_work(rng: Random) -> None:
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    about.call = f"{count} particles, each with one force generator; the first {awake} move, and "
    about.call += "the others are at rest and should be asleep; 20 calls to world.run_physics()"
    about.cause = "Some of the particles that are at rest are still awake. Check that fall_asleep "
    about.cause += "puts all of them to sleep."
    about.read = RUN
    asked, given, sleepers = work_asleep(count, awake, 20)
    wanted = [*range(awake, count)]
    expect_sleepers(sleepers, wanted, then="; which particles are asleep")
    about.cause = "You pass sleeping particles to the integrator, which takes time and has no "
    about.cause += "effect. Pass only those that are awake."
    then = "; the total number of particles passed to the integrator"
    expect_exactly(given, 20 * awake, then=then, unit="particles")
    about.cause = "You call update_force too often for sleeping particles. Call wake_pushed only "
    about.cause += "every tenth step."
    right = 20 * awake + 2 * (count - awake)
    if asked < right:
        about.cause = "You call update_force too rarely. Call it in every step for a particle that "
        about.cause += "is awake, and every tenth step for a sleeping one."
    expect_exactly(asked, right, then="; the number of calls to update_force", unit="calls")


@pytest.mark.exercise("G8.1", asks="fall asleep when they are at rest")
def test_balls_rest_where_they_would_without_sleep() -> None:
    about.read = RUN
    about.call = "two balls bounce for 6 s until they rest, by run_physics(); the final position "
    about.call += "of a ball, which should be the same as in a world without sleep"
    about.cause = "You put a ball to sleep while it still moves, so it stops too early. Particles "
    about.cause += "may fall asleep only when they have come to rest."
    places, awake, sleepers = both_ways(360)
    for got, wanted in zip(places, awake, strict=True):
        # A ball that falls asleep has at most 0.17 m/s. Damping of 0.5 would stop it within 0.25 m.
        expect_close(got, wanted, unit="m", tolerance=0.25)
        expect_close(got[1], 0.0, then="; its height above the ground", unit="m", tolerance=1e-6)
    about.cause = "After six seconds both balls are at rest. Check that both fall asleep."
    expect_exactly(sleepers, 2, then="; how many balls are asleep", unit="balls")
