"""Going further, G8.1: a world whose particles sleep."""

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
    about.call += f"sleep_frames {frames}; fall_asleep(): who sleeps after each frame"
    about.cause = "slow is v^2 / 2 <= sleep_energy at the end of sleep_frames frames in a row"
    seen = left_alone([0.9, 1.1, 0.0], frames + 2, sleep_frames=frames)
    wanted = [[]] * (frames - 1) + [[0, 2]] * 3
    if seen[0]:
        about.cause = "one slow frame is not enough: sleep_frames of them, in a row"
    elif not any(seen):
        about.cause = "nothing falls asleep: is fall_asleep asked at the end of run_physics?"
    elif seen[:frames] == wanted[:frames]:
        about.cause = "they fall asleep, and one wakes or moves on: what sleeps has velocity and "
        about.cause += "inverse_mass 0, and wakes only where something was changed"
    expect_exactly(seen, wanted)
    about.call = "particles of 1 m/s, and 0.5, 1 and 2 kg; fall_asleep(): who sleeps after 5 frames"
    about.cause = "energy counts for each kg: mass makes no difference, and exactly sleep_energy "
    about.cause += "is slow"
    seen = left_alone([1.0] * 3, 5, masses=[0.5, 1.0, 2.0])
    expect_exactly(seen[-1], [0, 1, 2])


@pytest.mark.exercise("G8.1")
def test_slow_frames_count_in_a_row(rng: Random) -> None:
    about.read = FALL
    slow = rng.randint(1, 4)
    about.call = f"at rest for {slow} frames, fast for one, and at rest again; sleep_frames 5; "
    about.call += "fall_asleep(): who sleeps after each frame"
    about.cause = "a frame in which it is not slow begins the count anew"
    wanted = [[]] * (slow + 1 + 4) + [[0]]
    expect_exactly(interrupted(slow, slow + 6), wanted)


@pytest.mark.exercise("G8.1")
def test_what_has_parted_is_no_group(rng: Random) -> None:
    about.read = FALL
    about.cause = "a group is what was in contact in one of the last sleep_frames frames: forget "
    about.cause += "older contacts, and renew those that last"
    for last in (rng.randint(1, 4), rng.randint(6, 12)):
        about.call = f"a slow particle, in contact with a fast one in the first {last} frames; "
        about.call += "sleep_frames 5; fall_asleep(): who sleeps after each frame"
        wanted = [[]] * (last + 4) + [[0]] * 3
        expect_exactly(parted(last, last + 7), wanted)
    last = rng.randint(1, 2)
    fast = last + rng.randint(1, 4)
    about.call = f"a particle, in contact with a fast one in the first {last} frames, is slow but "
    about.call += f"in frame {fast}; sleep_frames 5; fall_asleep(): who sleeps after each frame"
    wanted = [[]] * (fast + 4) + [[0]] * 3
    expect_exactly(parted(last, fast + 7, fast), wanted)
    about.call = "two slow particles in contact, one of which becomes immovable after 4 frames; "
    about.call += "sleep_frames 5; fall_asleep(): who sleeps after 12 frames"
    about.cause = "what is immovable joins nothing, whatever it touched before, and never sleeps"
    expect_exactly(made_immovable(4, 12), [0])


@pytest.mark.exercise("G8.1")
def test_what_touches_the_restless_stays_awake() -> None:
    about.read = FALL
    for what, speeds, pairs, masses, wanted, cause in (
        ("0 and 1", [0.0, 2.0, 0.0], [(0, 1)], (), [2], "1 is fast, so 0 stays awake with it"),
        (
            "0 and 1, 1 and 2, 2 and 3",
            [0.0, 0.0, 0.0, 2.0, 0.0],
            [(0, 1), (1, 2), (2, 3)],
            (),
            [4],
            "go through the pairs until none is added: 3 keeps 2 awake, that 1, and that 0",
        ),
        (
            "3 and 2, 2 and 1, 1 and 0",
            [2.0, 0.0, 0.0, 0.0],
            [(3, 2), (2, 1), (1, 0)],
            (),
            [],
            "in whatever order the contacts come",
        ),
        ("1 and 0", [0.0, 2.0], [(1, 0)], (), [], "either of the two keeps the other one awake"),
        ("0 and 1", [0.0, 0.0], [(0, 1)], (), [0, 1], "where all are slow, all sleep"),
        (
            "0 and 1, 1 and 2",
            [0.0, 0.0, 2.0],
            [(0, 1), (1, 2)],
            [1.0, math.inf, 1.0],
            [0],
            "what is immovable joins nothing: 0 and 2 stand on the same floor",
        ),
        ("0 and a wall, which is no particle", [0.0], [(0, -1)], (), [0], "a wall wakes nothing"),
    ):
        about.cause = cause
        about.call = f"particles of {speeds} m/s, contacts of {what}; fall_asleep(): who sleeps "
        about.call += "after each of 8 frames, where sleep_frames are 5"
        seen = left_alone(speeds, 8, pairs, masses)
        expect_exactly(seen, [[]] * 4 + [wanted] * 4)


@pytest.mark.exercise("G8.1")
def test_sleep_stops_and_waking_gives_the_mass_back(rng: Random) -> None:
    about.read = f"{WAKE}wake, and the class"
    mass, speed = positive_number(rng), positive_number(rng, 0.5, 1.0)
    about.call = f"a particle of {mass} kg and {speed} m/s; 3 frames, fall_asleep()"
    about.cause = "what sleeps is immovable, and its velocity is cleared"
    done = slept(mass, speed)
    expect_close(done["inverse mass asleep"], 0.0, then=": inverse_mass", tolerance=0.0)
    expect_close(done["velocity asleep"], (0.0,) * 3, then=": velocity", tolerance=0.0)
    about.cause = "it falls asleep after the frame, so three frames have moved it; then nothing "
    about.cause += "does"
    place = (1.0 + 3.0 * speed / 60.0, 2.0, 3.0)
    for name in ("place asleep", "place later"):
        expect_close(done[name], place, then=f": {name}", tolerance=1e-12)
    about.call = f"{about.call}; world.wake(particle)"
    about.cause = "the inverse mass that it had comes back, and it is no longer in asleep"
    got = done["inverse mass awake"]
    expect_close(got, 1.0 / mass, then=": inverse_mass")
    expect_exactly(done["asleep"], [], then=": who sleeps")
    about.cause = "it begins to count anew: slow for all of sleep_frames"
    got = done["frames to sleep again"]
    expect_exactly(got, 3, then=": frames until it sleeps again")
    about.call = "world.wake(particle) of one that has been awake and slow for 2 frames; "
    about.call += "sleep_frames 3"
    about.cause = "a particle that is awake begins to count anew as well"
    got = done["frames from then on"]
    expect_exactly(got, 3, then=": frames until it sleeps")
