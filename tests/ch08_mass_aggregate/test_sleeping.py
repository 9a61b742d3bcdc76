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
    about.call = (
        "three particles of 1 kg that do not touch, with speeds of 0.9, 1.1 and 0 m/s; "
        f"sleep_energy 0.5 J/kg and sleep_frames {frames}; fall_asleep(): who sleeps after each "
        "step"
    )
    about.cause = (
        "A particle is slow if v^2 / 2 is at most sleep_energy, and it falls asleep once it has "
        "been slow for sleep_frames steps in a row. Check both conditions."
    )
    seen = left_alone([0.9, 1.1, 0.0], frames + 2, sleep_frames=frames)
    wanted = [[]] * (frames - 1) + [[0, 2]] * 3
    if seen[0]:
        about.cause = (
            "Your particles fall asleep after a single slow step. Count each particle's slow "
            "steps, and wait for sleep_frames of them in a row."
        )
    elif not any(seen):
        about.cause = (
            "No particle falls asleep. Check that run_physics ends by calling fall_asleep, and "
            "that fall_asleep adds each particle that falls asleep to self.asleep."
        )
    elif seen[:frames] == wanted[:frames]:
        about.cause = (
            "Your particles fall asleep but wake again. Set the velocity and the inverse_mass of a "
            "sleeping particle to 0, and wake it only if something about it has changed."
        )
    expect_exactly(seen, wanted)
    about.call = (
        "particles of 0.5, 1 and 2 kg, all moving at 1 m/s; fall_asleep(): who sleeps after 5 steps"
    )
    about.cause = (
        "All three particles are slow. sleep_energy is an energy per kilogram, so compare it with "
        "v^2 / 2 whatever the mass is. A particle with exactly that energy still counts as slow."
    )
    seen = left_alone([1.0] * 3, 5, masses=[0.5, 1.0, 2.0])
    expect_exactly(seen[-1], [0, 1, 2])


@pytest.mark.exercise("G8.1")
def test_slow_frames_count_in_a_row(rng: Random) -> None:
    slow = rng.randint(1, 4)
    about.call = (
        f"a particle that is at rest for {slow} steps, fast for one step, and then at rest again; "
        "sleep_frames 5; fall_asleep(): who sleeps after each step"
    )
    about(
        cause="You still count the slow steps before the fast one. A fast step should reset the "
        "count to 0.",
        read=FALL,
    )
    wanted = [[]] * (slow + 1 + 4) + [[0]]
    seen = interrupted(slow, slow + 6)
    if seen[0]:
        about.cause = (
            "Your particle falls asleep after a single slow step. Count its slow steps, and wait "
            "for sleep_frames of them in a row."
        )
    expect_exactly(seen, wanted)


@pytest.mark.exercise("G8.1")
def test_what_has_parted_is_no_group(rng: Random) -> None:
    about.read = FALL
    about.cause = (
        "Two particles belong together if they touched in one of the last sleep_frames steps. "
        "Store the last step in which they touched, update it as long as the contact lasts, and "
        "forget the contact once it is older than that."
    )
    for last in (rng.randint(1, 4), rng.randint(6, 12)):
        about.call = (
            f"a slow particle touches a fast one in steps 1 to {last}; sleep_frames 5; "
            "fall_asleep(): who sleeps after each step"
        )
        wanted = [[]] * (last + 4) + [[0]] * 3
        seen, why = parted(last, last + 7), about.cause
        if not any(seen):
            why = (
                "The slow particle never falls asleep, because an old contact keeps it awake. "
                "Forget a contact after sleep_frames steps."
            )
        elif any(seen[: last + 4]):
            why = (
                "The slow particle falls asleep too early. A contact keeps it awake for "
                "sleep_frames steps, and it touched the fast one more recently than that."
            )
        expect_exactly(seen, wanted, cause=why)
    last = rng.randint(1, 2)
    fast = last + rng.randint(1, 4)
    about.call = (
        f"a particle touches a fast one in steps 1 to {last}, and is itself slow except in step "
        f"{fast}; sleep_frames 5; fall_asleep(): who sleeps after each step"
    )
    wanted, seen = [[]] * (fast + 4) + [[0]] * 3, parted(last, fast + 7, fast)
    if not any(seen):
        about.cause = (
            "The particle never falls asleep, because an old contact keeps it awake. In each step, "
            "forget every contact that is sleep_frames steps old."
        )
    elif any(seen[: fast + 4]):
        about.cause = (
            f"The particle falls asleep too early. It was fast itself in step {fast}, so count its "
            "slow steps from the step after that."
        )
    expect_exactly(seen, wanted)
    about.call = (
        "two slow particles that touch all the time, of which number 1 becomes immovable after 4 "
        "steps; sleep_frames 5; fall_asleep(): who sleeps after 12 steps"
    )
    about.cause = (
        "A particle can become immovable while the world is running. In fall_asleep, skip every "
        "particle that is immovable at the time."
    )
    seen = made_immovable(4, 12)
    if [0] in seen and seen[-1] == []:
        about.cause = (
            "Number 0 falls asleep, but its contact with the immovable number 1 wakes it again. In "
            "wake_touched, let a particle wake another only if it can move itself."
        )
    elif not any(seen):
        about.cause = (
            "Number 0 stays awake because it touches number 1, which is immovable. An immovable "
            "particle doesn't keep others awake, so skip it in fall_asleep."
        )
    elif any(1 in one for one in seen):
        about.cause = (
            "You put number 1 to sleep, although it is immovable. It would get its old mass back "
            "when it wakes, so skip immovable particles in fall_asleep."
        )
    expect_exactly(seen[-1], [0])


@pytest.mark.exercise("G8.1")
def test_what_touches_the_restless_stays_awake() -> None:
    about.read = FALL
    for what, speeds, pairs, masses, wanted, cause in (
        ("0 and 1", [0.0, 2.0, 0.0], [(0, 1)], (), [2], "Particle 1 is fast and touches particle "
                                                        "0, so it keeps particle 0 awake too. "
                                                        "Neither of them should fall asleep."),
        ("0 and 1, 1 and 2, 2 and 3", [0.0, 0.0, 0.0, 2.0, 0.0], [(0, 1), (1, 2), (2, 3)], (), [4],
         "Particle 3 is fast, so it keeps particle 2 awake, which keeps particle 1 awake, which "
         "keeps particle 0 awake. Keep going through the pairs until you find no more particles "
         "that have to stay awake."),
        ("3 and 2, 2 and 1, 1 and 0", [2.0, 0.0, 0.0, 0.0], [(3, 2), (2, 1), (1, 0)], (), [],
         "Particle 0 is fast, and through the chain of contacts it keeps all the others awake. The "
         "order of the contacts should make no difference."),
        ("1 and 0", [0.0, 2.0], [(1, 0)], (), [], "Particle 0 touches particle 1, which is fast, "
                                                  "so it has to stay awake. The restless particle "
                                                  "can be either one of a pair, so check both."),
        ("0 and 1", [0.0, 0.0], [(0, 1)], (), [0, 1], "Both particles are slow, so they don't keep "
                                                      "each other awake. Both should fall asleep."),
        ("0 and 1, 1 and 2", [0.0, 0.0, 2.0], [(0, 1), (1, 2)], [1.0, math.inf, 1.0], [0],
         "An immovable particle doesn't join its neighbors into a group. For example, two bodies "
         "on the same floor can fall asleep separately."),
        ("0 and a wall (other is None)", [0.0], [(0, -1)], (), [0], "The other side of this "
                                                                    "contact is a wall, so "
                                                                    "contact.other is None. A wall "
                                                                    "doesn't keep a particle "
                                                                    "awake, so skip such "
                                                                    "contacts."),
    ):  # fmt: skip
        about.cause = cause
        about.call = (
            f"particles with speeds of {speeds} m/s and contacts of {what}; sleep_frames 5; "
            "fall_asleep(): who sleeps after each of 8 steps"
        )
        seen = left_alone(speeds, 8, pairs, masses)
        expect_exactly(seen, [[]] * 4 + [wanted] * 4)


@pytest.mark.exercise("G8.1")
def test_sleep_stops_and_waking_gives_the_mass_back(rng: Random) -> None:
    about.read = f"{WAKE}wake, and the class"
    mass, speed = positive_number(rng), positive_number(rng, 0.5, 1.0)
    about.call = (
        f"a particle of {mass} kg that moves at {speed} m/s; sleep_frames 3; 3 steps, fall_asleep()"
    )
    about.cause = (
        "When a particle falls asleep, set its inverse_mass to 0 and clear its velocity, so that "
        "nothing can move it."
    )
    done = slept(mass, speed)
    expect_close(done["inverse mass asleep"], 0.0, then=": inverse_mass", tolerance=0.0)
    expect_close(done["velocity asleep"], (0.0,) * 3, then=": velocity", tolerance=0.0)
    about.cause = (
        "The particle falls asleep at the end of the third step, so exactly three steps move it. "
        "After that it stays where it is."
    )
    place = (1.0 + 3.0 * speed / 60.0, 2.0, 3.0)
    for name in ("place asleep", "place later"):
        shown = name.replace("place", "position")
        expect_close(done[name], place, then=f": {shown}", tolerance=1e-12)
    about.call = f"{about.call}; world.wake(particle)"
    about.cause = (
        "When a particle wakes, give it back its old inverse mass and remove it from self.asleep."
    )
    got = done["inverse mass awake"]
    expect_close(got, 1.0 / mass, then=": inverse_mass")
    expect_exactly(done["asleep"], [], then=": who sleeps")
    about.cause = (
        "The particle has just woken up, so wake should reset its count of slow steps to 0."
    )
    got = done["frames to sleep again"]
    expect_exactly(got, 3, then=": steps until it sleeps again")
    about.call = (
        "world.wake(particle) for a particle that is awake and has been slow for 2 steps; "
        "sleep_frames 3"
    )
    about.cause = (
        "wake should reset the count of slow steps to 0, even if the particle is already awake."
    )
    got = done["frames from then on"]
    expect_exactly(got, 3, then=": steps until it sleeps")
