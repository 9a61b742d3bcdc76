"""Going further, G8.1: how particles fall asleep."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.sleep_probes import interrupted, left_alone, slept
from ch08_mass_aggregate.wake_probes import made_immovable, parted
from draw import positive_number
from expect import about, expect_close, expect_exactly

FALL = "the docstrings of SleepingWorld and fall_asleep"
WAKE = "the docstring of SleepingWorld."


@pytest.mark.exercise("G8.1")
def test_what_is_slow_for_long_enough_falls_asleep(rng: Random) -> None:
    about.read = FALL
    frames = rng.randint(3, 8)
    about.call = "particles of 0.9, 1.1 and 0 m/s, 1 kg, alone; sleep_energy 0.5 J/kg, "
    about.call += f"sleep_frames {frames}; fall_asleep(): indices of the sleepers after each step"
    about.cause = "A particle is slow if v^2 / 2 <= sleep_energy. It sleeps after sleep_frames "
    about.cause += "slow steps in a row."
    seen = left_alone([0.9, 1.1, 0.0], frames + 2, sleep_frames=frames)
    wanted = [[]] * (frames - 1) + [[0, 2]] * 3
    if seen[0]:
        about.cause = "One slow step is not enough. Wait for sleep_frames of them in a row."
    elif not any(seen):
        about.cause = (
            "No particle falls asleep. Call fall_asleep at the end of run_physics, and put "
        )
        about.cause += "particles into self.asleep there."
    elif seen[:frames] == wanted[:frames]:
        about.cause = "The particles fall asleep but do not stay asleep. Set velocity and "
        about.cause += "inverse_mass to 0, and wake a particle only if something has changed."
    expect_exactly(seen, wanted)
    about.call = "particles of 1 m/s, and 0.5, 1 and 2 kg; fall_asleep(): who sleeps after 5 steps"
    about.cause = "sleep_energy is an energy per kg, so the mass makes no difference. Exactly "
    about.cause += "sleep_energy still counts as slow."
    seen = left_alone([1.0] * 3, 5, masses=[0.5, 1.0, 2.0])
    expect_exactly(seen[-1], [0, 1, 2])


@pytest.mark.exercise("G8.1")
def test_slow_frames_count_in_a_row(rng: Random) -> None:
    slow = rng.randint(1, 4)
    about.call = f"at rest for {slow} steps, fast for one, and at rest again; sleep_frames 5; "
    about.call += "fall_asleep(): who sleeps after each step"
    about(cause="A fast step must set the count of slow steps back to 0.", read=FALL)
    wanted = [[]] * (slow + 1 + 4) + [[0]]
    seen = interrupted(slow, slow + 6)
    if seen[0]:
        about.cause = "One slow step is not enough. Wait for sleep_frames of them in a row."
    expect_exactly(seen, wanted)


@pytest.mark.exercise("G8.1")
def test_what_has_parted_is_no_group(rng: Random) -> None:
    about.read = FALL
    about.cause = "Particles belong together if they touched in one of the last sleep_frames "
    about.cause += "steps. Forget older contacts, and update the step of contacts that continue."
    for last in (rng.randint(1, 4), rng.randint(6, 12)):
        about.call = f"a slow particle touches a fast one in steps 1 to {last}; sleep_frames 5; "
        about.call += "fall_asleep(): who sleeps after each step"
        wanted = [[]] * (last + 4) + [[0]] * 3
        seen, why = parted(last, last + 7), about.cause
        if not any(seen):
            why = "The slow particle never falls asleep. Forget contacts after sleep_frames steps."
        elif any(seen[: last + 4]):
            why = (
                "The particle sleeps although it touched a fast one in the last sleep_frames steps."
            )
        expect_exactly(seen, wanted, cause=why)
    last = rng.randint(1, 2)
    fast = last + rng.randint(1, 4)
    about.call = f"a particle touches a fast one in steps 1 to {last}, and is slow except in step "
    about.call += f"{fast}; sleep_frames 5; fall_asleep(): who sleeps after each step"
    wanted, seen = [[]] * (fast + 4) + [[0]] * 3, parted(last, fast + 7, fast)
    if not any(seen):
        about.cause = "The particle never falls asleep. Forget every contact that is sleep_frames "
        about.cause += "steps old, in each step."
    elif any(seen[: fast + 4]):
        about.cause = f"The particle was fast in step {fast}, so count its slow steps from there."
    expect_exactly(seen, wanted)
    about.call = "two slow particles touch all the time, and number 1 becomes immovable after 4 "
    about.call += "steps; sleep_frames 5; fall_asleep(): who sleeps after 12 steps"
    about.cause = "Skip immovable particles in fall_asleep, also those that have become immovable."
    seen = made_immovable(4, 12)
    if [0] in seen and seen[-1] == []:
        about.cause = "Number 0 falls asleep, but the contact with the immovable number 1 wakes it "
        about.cause += "again. In wake_touched only a particle that can move wakes another one."
    elif not any(seen):
        about.cause = "Number 0 stays awake because it touches the immovable number 1. In "
        about.cause += "fall_asleep leave out immovable particles: they keep nothing awake."
    elif any(1 in one for one in seen):
        about.cause = "Number 1 is immovable and must not fall asleep, since it would get a mass "
        about.cause += "when it wakes. Leave it out in fall_asleep."
    expect_exactly(seen[-1], [0])


@pytest.mark.exercise("G8.1")
def test_what_touches_the_restless_stays_awake() -> None:
    about.read = FALL
    for what, speeds, pairs, masses, wanted, cause in (
        ("0 and 1", [0.0, 2.0, 0.0], [(0, 1)], (), [2], "Particle 1 is fast and touches particle "
                                                        "0, so both stay awake."),
        ("0 and 1, 1 and 2, 2 and 3", [0.0, 0.0, 0.0, 2.0, 0.0], [(0, 1), (1, 2), (2, 3)], (), [4],
         "Particle 3 is fast. It keeps 2 awake, which keeps 1 awake, which keeps 0 awake. Go "
         "through the pairs until no particle is added."),
        ("3 and 2, 2 and 1, 1 and 0", [2.0, 0.0, 0.0, 0.0], [(3, 2), (2, 1), (1, 0)], (), [],
         "Particle 0 is fast and keeps all others awake, in whatever order the contacts come."),
        ("1 and 0", [0.0, 2.0], [(1, 0)], (), [], "Particle 0 touches particle 1, which is fast. "
                                                  "Check both particles of a pair."),
        ("0 and 1", [0.0, 0.0], [(0, 1)], (), [0, 1], "Both particles are slow, so both fall "
                                                      "asleep."),
        ("0 and 1, 1 and 2", [0.0, 0.0, 2.0], [(0, 1), (1, 2)], [1.0, math.inf, 1.0], [0],
         "Immovable particles do not join others into a group. Two bodies on the same floor "
         "sleep separately."),
        ("0 and a wall (other is None)", [0.0], [(0, -1)], (), [0], "A wall keeps nothing awake."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"particles of {speeds} m/s, contacts of {what}; sleep_frames 5; "
        about.call += "fall_asleep(): who sleeps after each of 8 steps"
        seen = left_alone(speeds, 8, pairs, masses)
        expect_exactly(seen, [[]] * 4 + [wanted] * 4)


@pytest.mark.exercise("G8.1")
def test_sleep_stops_and_waking_gives_the_mass_back(rng: Random) -> None:
    about.read = f"{WAKE}wake, and the class"
    mass, speed = positive_number(rng), positive_number(rng, 0.5, 1.0)
    about.call = f"a particle of {mass} kg and {speed} m/s; sleep_frames 3; 3 steps, fall_asleep()"
    about.cause = "Set inverse_mass to 0 and clear the velocity of a particle that falls asleep."
    done = slept(mass, speed)
    expect_close(done["inverse mass asleep"], 0.0, then=": inverse_mass", tolerance=0.0)
    expect_close(done["velocity asleep"], (0.0,) * 3, then=": velocity", tolerance=0.0)
    about.cause = "The particle falls asleep at the end of the third step, so three steps have "
    about.cause += "moved it. After that nothing may move it."
    place = (1.0 + 3.0 * speed / 60.0, 2.0, 3.0)
    for name in ("place asleep", "place later"):
        shown = name.replace("place", "position")
        expect_close(done[name], place, then=f": {shown}", tolerance=1e-12)
    about.call = f"{about.call}; world.wake(particle)"
    about.cause = "Give the particle its old inverse mass back, and remove it from asleep."
    got = done["inverse mass awake"]
    expect_close(got, 1.0 / mass, then=": inverse_mass")
    expect_exactly(done["asleep"], [], then=": who sleeps")
    about.cause = "wake must set the count of slow steps back to 0."
    got = done["frames to sleep again"]
    expect_exactly(got, 3, then=": steps until it sleeps again")
    about.call = "world.wake(particle) of a particle that has been awake and slow for 2 steps; "
    about.call += "sleep_frames 3"
    about.cause = "wake must set the count back to 0 for a particle that is awake as well."
    got = done["frames from then on"]
    expect_exactly(got, 3, then=": steps until it sleeps")
