"""Going further, G8.1: how particles fall asleep."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.sleep_probes import interrupted, left_alone, slept
from ch08_mass_aggregate.wake_probes import made_immovable, parted
from draw import positive_number
from expect import about, expect_close, expect_exactly
from sleepers import expect_sleepers, expect_sleepers_of_steps

FALL = "the docstrings of SleepingWorld and fall_asleep"
WAKE = "the docstring of SleepingWorld."


@pytest.mark.exercise("G8.1", asks="A particle is tired if its last")
def test_slow_particles_fall_asleep(rng: Random) -> None:
    about.read = FALL
    frames = rng.randint(3, 8)
    about.call = "particles 0, 1 and 2, of 1 kg, have speeds of 0.9, 1.1 and 0 m/s and don't "
    about.call += f"touch; a SleepingWorld with sleep_energy=0.5 and sleep_frames={frames}; which "
    about.call += "particles are asleep after each step"
    about.cause = "A particle is slow if v^2 / 2 is at most sleep_energy. Put it to sleep once it "
    about.cause += "has been slow for sleep_frames steps in a row."
    seen = left_alone([0.9, 1.1, 0.0], frames + 2, sleep_frames=frames)
    wanted = [[]] * (frames - 1) + [[0, 2]] * 3
    if seen[0]:
        about.cause = "Your particles fall asleep after a single slow step. Count each particle's "
        about.cause += "slow steps, and wait for sleep_frames of them in a row."
    elif not any(seen):
        about.cause = "No particle ever falls asleep. Call fall_asleep at the end of run_physics, "
        about.cause += "and add each particle that falls asleep to self.asleep."
    elif seen[:frames] == wanted[:frames]:
        why = "although nothing about them has changed. Wake a particle only if its position, "
        why += "velocity, mass or force has changed since it fell asleep"
        if seen[frames] and seen[frames] != [0, 2]:
            why = "because they keep their velocity. Set it to 0 in fall_asleep"
        elif not seen[frames] and slept(1.0, 0.1)["inverse mass asleep"]:
            why = "because their inverse_mass is not 0. Set it to 0 in fall_asleep"
        about.cause = f"Your particles fall asleep but wake again, {why}."
    expect_sleepers_of_steps(seen, wanted)
    about.call = "particles 0, 1 and 2, of 0.5, 1 and 2 kg, all move at 1 m/s; a SleepingWorld "
    about.call += "with sleep_energy=0.5 and sleep_frames=5; which particles are asleep after 5 "
    about.call += "steps"
    about.cause = "You compare the whole kinetic energy, so heavy particles stay awake. Compare "
    about.cause += "v^2 / 2, without the mass, with sleep_energy."
    seen = left_alone([1.0] * 3, 5, masses=[0.5, 1.0, 2.0])
    if 1 not in seen[-1]:
        about.cause = "A particle is also slow if v^2 / 2 is exactly sleep_energy, as it is here. "
        about.cause += "Use <= in the comparison."
    expect_sleepers(seen[-1], [0, 1, 2])


@pytest.mark.exercise("G8.1", asks="slow steps in a row the particle is tired")
def test_slow_steps_count_only_in_a_row(rng: Random) -> None:
    slow = rng.randint(1, 4)
    about.call = f"particle 0 is at rest for {slow} steps, fast for one step, and then at rest "
    about.call += "again; a SleepingWorld with sleep_frames=5; which particles are asleep after "
    about.call += "each step"
    about(
        cause="You still count the slow steps before the fast one. After a fast step, reset the "
        "count to 0.",
        read=FALL,
    )
    wanted = [[]] * (slow + 1 + 4) + [[0]]
    seen = interrupted(slow, slow + 6)
    if seen[0]:
        about.cause = "Your particle falls asleep after a single slow step. Count its slow steps, "
        about.cause += "and wait for sleep_frames of them in a row."
    elif not any(seen):
        about.cause = "Your particle never falls asleep, although it is at rest for 5 steps at the "
        about.cause += "end. Count its slow steps in a row."
    expect_sleepers_of_steps(seen, wanted)


@pytest.mark.exercise("G8.1", asks="if they were in contact in one of the last")
def test_old_contacts_are_forgotten(rng: Random) -> None:
    about.read = FALL
    about.cause = "Two particles belong together if they touched in one of the last sleep_frames "
    about.cause += "steps. Store the last step in which they touched, and forget contacts that are "
    about.cause += "older than that."
    for last in (rng.randint(1, 4), rng.randint(6, 12)):
        steps = f"steps 1 to {last}" if last > 1 else "step 1"
        about.call = f"slow particle 0 touches fast particle 1 only in {steps}; a SleepingWorld "
        about.call += "with sleep_frames=5; which particles are asleep after each step"
        wanted = [[]] * (last + 4) + [[0]] * 3
        seen, why = parted(last, last + 7), about.cause
        if not any(seen):
            why = "Particle 0 never falls asleep, because an old contact keeps it awake. Forget a "
            why += "contact after sleep_frames steps."
            if not any(left_alone([0.0], 8)):
                why = "Particle 0 never falls asleep, even without contacts. Count its slow "
                why += "steps first."
        elif any(seen[: last + 4]):
            why = "Particle 0 falls asleep too early, because you forget its contact with the fast "
            why += "particle 1 too soon. Remember a contact for sleep_frames steps."
            if any(0 in one for one in left_alone([0.0, 2.0], 8, [(0, 1)])):
                why = "Particle 0 falls asleep too early, because you ignore its contact with the "
                why += "fast particle 1. Let a group fall asleep only when each of its particles "
                why += "has been slow for sleep_frames steps."
        expect_sleepers_of_steps(seen, wanted, cause=why)
    last = rng.randint(1, 2)
    fast = last + rng.randint(1, 4)
    steps = f"steps 1 to {last}" if last > 1 else "step 1"
    about.call = f"particle 0 touches the fast particle 1 only in {steps}; particle 0 is slow, "
    about.call += f"except in step {fast}; a SleepingWorld with sleep_frames=5; which particles "
    about.call += "are asleep after each step"
    wanted, seen = [[]] * (fast + 4) + [[0]] * 3, parted(last, fast + 7, fast)
    if not any(seen):
        about.cause = "Particle 0 never falls asleep, probably because you forget a contact only "
        about.cause += "when its age is exactly sleep_frames. Forget older contacts too."
    elif any(seen[: fast + 4]):
        about.cause = f"Particle 0 falls asleep too early. It was fast itself in step {fast}, so "
        about.cause += "count its slow steps only from the step after that."
    expect_sleepers_of_steps(seen, wanted)
    about.call = "a SleepingWorld with sleep_frames=5; particles 0 and 1 are slow and stay in "
    about.call += "contact; after 4 steps, particle 1 becomes immovable; which particles are "
    about.call += "asleep after 12 steps"
    about.cause = "Your fall_asleep still uses the contacts of particle 1, which has become "
    about.cause += "immovable. Skip every contact of an immovable particle."
    seen = made_immovable(4, 12)
    if [0] in seen and seen[-1] == []:
        about.cause = "Particle 0 falls asleep, but its contact with the immovable particle 1 "
        about.cause += "wakes it again. In wake_touched, wake a sleeping particle only if the "
        about.cause += "other particle of the contact can move."
    elif not any(seen):
        about.cause = "Particle 0 stays awake because it touches particle 1, which is immovable. "
        about.cause += "An immovable particle doesn't keep others awake, so skip it in fall_asleep."
    elif any(1 in one for one in seen):
        about.cause = "You put particle 1 to sleep, although it is immovable. When it wakes, it "
        about.cause += "gets a wrong mass, so skip immovable particles in fall_asleep."
    expect_sleepers(seen[-1], [0])


@pytest.mark.exercise("G8.1", asks="only when all of its particles are tired")
def test_a_fast_particle_keeps_its_group_awake() -> None:
    about.read = FALL
    for what, speeds, pairs, masses, wanted, cause in (
        ("0 and 1", [0.0, 2.0, 0.0], [(0, 1)], (), [2], "Particle 1 is fast and touches particle "
                                                        "0, so it keeps particle 0 awake too. "
                                                        "Neither of them should fall asleep."),
        ("0 and 1, 1 and 2, 2 and 3", [0.0, 0.0, 0.0, 2.0, 0.0], [(0, 1), (1, 2), (2, 3)], (), [4],
         "Particle 3 is fast, so its whole group must stay awake. Particles 0 and 1 belong to the "
         "same group, because contacts connect them to particle 3."),
        ("3 and 2, 2 and 1, 1 and 0", [2.0, 0.0, 0.0, 0.0], [(3, 2), (2, 1), (1, 0)], (), [],
         "Particle 0 is fast, and through the chain of contacts it keeps all the others awake. The "
         "order of the contacts should make no difference."),
        ("1 and 0", [0.0, 2.0], [(1, 0)], (), [], "Particle 0 touches particle 1, which is fast, "
                                                  "so it has to stay awake. The fast particle "
                                                  "can be either one of a pair, so check both."),
        ("0 and 1", [0.0, 0.0], [(0, 1)], (), [0, 1], "Both particles are slow, so they don't keep "
                                                      "each other awake. Both should fall asleep."),
        ("0 and 1, 1 and 2", [0.0, 0.0, 2.0], [(0, 1), (1, 2)], [1.0, math.inf, 1.0], [0],
         "Particle 1 is immovable, so it doesn't join particles 0 and 2 into a group. Skip "
         "immovable particles when you look for groups."),
        ("0 and a wall (other is None)", [0.0], [(0, -1)], (), [0],
         "The other side of this contact is a wall, so contact.other is None. A wall doesn't keep "
         "a particle awake, so skip such contacts."),
    ):  # fmt: skip
        about.cause = cause
        resting = "particle 0 is" if len(speeds) == 1 else f"particles 0 to {len(speeds) - 1} are"
        about.call = f"a SleepingWorld with sleep_frames=5; {resting} at rest"
        for i, one in enumerate(speeds):
            about.call += f", except particle {i}, which moves at {one:g} m/s" * bool(one)
        about.call += f"; contacts between {what}; which particles are asleep after each of 8 steps"
        seen = left_alone(speeds, 8, pairs, masses)
        expect_sleepers_of_steps(seen, [[]] * 4 + [wanted] * 4)


@pytest.mark.exercise("G8.1", asks="Each of them gets its mass back")
def test_a_particle_stops_and_gets_its_mass_back(rng: Random) -> None:
    about.read = f"{WAKE}wake, and the class"
    mass, speed = positive_number(rng), positive_number(rng, 0.5, 1.0)
    start = f"a SleepingWorld with sleep_frames=3; a particle of {mass} kg moves at {speed} m/s, "
    start += "which counts as slow"
    about.call = f"{start}; the world takes three steps"
    about.cause = "When a particle falls asleep, set its inverse_mass to 0 and clear its velocity, "
    about.cause += "so that nothing can move it."
    done = slept(mass, speed)
    expect_close(done["inverse mass asleep"], 0.0, then="; particle.inverse_mass", tolerance=0.0)
    expect_close(done["velocity asleep"], (0.0,) * 3, then="; particle.velocity", tolerance=0.0)
    about.cause = "A particle falls asleep at the end of its third slow step, so exactly three "
    about.cause += "steps should move it. After that it stays where it is."
    place = (1.0 + 3.0 * speed / 60.0, 2.0, 3.0)
    for name, shown in (("place asleep", "position"), ("place later", "position, 20 steps later")):
        expect_close(done[name], place, then=f"; particle.{shown}", tolerance=1e-12)
    about.call = f"{start}; the particle falls asleep; world.wake(particle)"
    about.cause = "Your particle stays immovable when it wakes. In wake, restore its old "
    about.cause += "inverse mass."
    got = done["inverse mass awake"]
    if got:
        about.cause = "Your particle has the wrong mass when it wakes. In wake, restore its "
        about.cause += "old inverse mass."
    expect_close(got, 1.0 / mass, then="; particle.inverse_mass")
    about.cause = (
        "Your particle is still in self.asleep after it wakes. Remove it from there in wake."
    )
    expect_sleepers(done["asleep"], [], then="; which particles are asleep")
    about.cause = "Your particle keeps its old count of slow steps when it wakes. In wake, reset "
    about.cause += "its count of slow steps to 0."
    got = done["frames to sleep again"]
    if got > 3:
        about.cause = "Your particle falls asleep again too late, or not at all. In wake, reset "
        about.cause += "its count of slow steps to 0."
    then = "; the number of steps until the particle falls asleep again"
    expect_exactly(got, 3, then=then, unit="steps")
    about.call = "a SleepingWorld with sleep_frames=3; a particle is awake and has been slow for "
    about.call += "two steps; world.wake(particle)"
    about.cause = "wake should reset the count of slow steps to 0, even if the particle is already "
    about.cause += "awake."
    got = done["frames from then on"]
    then = "; the number of steps until the particle falls asleep"
    expect_exactly(got, 3, then=then, unit="steps")
