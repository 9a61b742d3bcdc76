"""Going further, G8.1: how particles fall asleep."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.sleep_probes import Touch, asleep, stepped
from ch08_mass_aggregate.sleeping import SleepingWorld
from draw import positive_number
from expect import expect_close, expect_exactly
from sleepers import expect_sleepers, expect_sleepers_of_steps

FALL = "the docstrings of SleepingWorld and fall_asleep"
WAKE = "the docstring of SleepingWorld.wake, and the class"
FIVE = "a SleepingWorld with sleep_energy=0.5 and sleep_frames=5; "
EACH = "; which particles are asleep after each step"
AT_ONCE = "falls asleep after a single slow step. Wait for sleep_frames of them in a row."
COUNT = "Count its slow steps in a row, and add it to self.asleep when it falls asleep."


def scene(
    speeds: Sequence[float],
    pairs: Sequence[tuple[int, int]] = (),
    masses: Sequence[float] = (),
    steps: int = 5,
) -> tuple[Any, list[Any], Any]:
    """Return a world, its particles, which move along Z, and the contacts between pairs of them."""
    particles = [
        Particle(Vector3(3.0 * i), Vector3(0.0, 0.0, speed), mass=masses[i] if masses else 1.0)
        for i, speed in enumerate(speeds)
    ]
    touch = Touch(particles, [*pairs])
    world = SleepingWorld(particles, [touch], sleep_energy=0.5, sleep_frames=steps)
    return world, particles, touch


@pytest.mark.exercise("G8.1", asks="A particle is tired if its last", read=FALL)
def test_slow_particles_fall_asleep(rng: Random) -> None:
    frames = rng.randint(3, 8)
    why = "Put a particle to sleep if v^2 / 2 is at most sleep_energy for sleep_frames steps."
    text = "particles 0, 1 and 2, of 1 kg, have speeds of 0.9, 1.1 and 0 m/s and don't touch; a "
    text += f"SleepingWorld with sleep_energy=0.5 and sleep_frames={frames}{EACH}"
    with calls(why, text):
        world, particles, _ = scene([0.9, 1.1, 0.0], steps=frames)
        seen = stepped(world, particles, frames + 2)
        still = Particle(velocity=Vector3(0.1))
        stepped(SleepingWorld([still], sleep_energy=10.0, sleep_frames=3), [still], 3)
    wanted = [[]] * (frames - 1) + [[0, 2]] * 3
    if seen[0]:
        why = f"A particle {AT_ONCE}"
    elif not any(seen):
        why = "No particle ever falls asleep. Call fall_asleep at the end of run_physics, and add "
        why += "each particle that falls asleep to self.asleep."
    elif seen[:frames] == wanted[:frames]:
        why = "although nothing about them has changed. Wake a particle only if its position, "
        why += "velocity, mass or force has changed since it fell asleep"
        if seen[frames] and seen[frames] != [0, 2]:
            why = "because they keep their velocity. Set it to 0 in fall_asleep"
        elif not seen[frames] and still.inverse_mass:
            why = "because their inverse_mass is not 0. Set it to 0 in fall_asleep"
        why = f"Your particles fall asleep but wake again, {why}."
    expect_sleepers_of_steps(seen, wanted, cause=why)
    why = "Compare v^2 / 2, without the mass, with sleep_energy, and use <=."
    with calls(why, f"{FIVE}particles 0, 1 and 2, of 0.5, 1 and 2 kg, all move at 1 m/s; 5 steps"):
        world, particles, _ = scene([1.0] * 3, masses=[0.5, 1.0, 2.0])
        seen = stepped(world, particles, 5)[-1]
    expect_sleepers(seen, [0, 1, 2], then="; which particles are asleep")


def parted(touching: int, steps: int, cause: str, fast: int = 0) -> list[list[int]]:
    """Return who sleeps if particle 0, which is slow but for a step, touches 1 for some steps."""
    told = f"touches particle 1, which is fast, in the first {touching} steps, " * bool(touching)
    told += f"is slow, except in step {fast}" if fast else "is slow"
    with calls(cause, f"{FIVE}particle 0 {told}{EACH}"):
        world, particles, touch = scene([0.0, 9.0], [(0, 1)])
        seen = []
        for i in range(1, steps + 1):
            if i > touching:
                touch.pairs = []
            particles[0].velocity.z = 9.0 if i == fast else 0.0
            seen += stepped(world, particles, 1)
    return seen


@pytest.mark.exercise("G8.1", asks="slow steps in a row the particle is tired", read=FALL)
def test_slow_steps_count_only_in_a_row(rng: Random) -> None:
    slow = rng.randint(1, 4)
    why = "You still count the slow steps before the fast one. Then reset the count to 0."
    seen = parted(0, slow + 6, why, slow + 1)
    if seen[0]:
        why = f"Your particle {AT_ONCE}"
    elif not any(seen):
        why = f"Your particle never falls asleep, although it is at rest for 5 steps. {COUNT}"
    expect_sleepers_of_steps(seen, [[]] * (slow + 1 + 4) + [[0]], cause=why)


@pytest.mark.exercise("G8.1", asks="if they were in contact in one of the last", read=FALL)
def test_old_contacts_are_forgotten(rng: Random) -> None:
    recent = "Two particles belong together if they touched in one of the last sleep_frames steps. "
    recent += "Store the last step in which they touched, and forget older contacts."
    for last in (rng.randint(1, 4), rng.randint(6, 12)):
        seen, why = parted(last, last + 7, recent), recent
        if not any(seen):
            why = f"Particle 0 never falls asleep, because an old contact keeps it awake. {recent}"
            if not any(parted(0, 8, recent)):
                why = f"Particle 0 never falls asleep, even without contacts. {COUNT}"
        elif any(seen[: last + 4]):
            why = "Particle 0 falls asleep too early, because you forget its contact with the fast "
            why += "particle 1 too soon. Remember a contact for sleep_frames steps."
            if any(0 in one for one in parted(8, 8, recent)):
                why = "Particle 0 falls asleep too early, because you ignore its contact with the "
                why += "fast particle 1. A group falls asleep only when all of it is tired."
        parted(last, last + 7, recent)
        expect_sleepers_of_steps(seen, [[]] * (last + 4) + [[0]] * 3, cause=why)
    last = rng.randint(1, 2)
    fast = last + rng.randint(1, 4)
    seen = parted(last, fast + 7, recent, fast)
    why = recent
    if not any(seen):
        why = "Particle 0 never falls asleep. Forget all contacts older than sleep_frames steps."
    elif any(seen[: fast + 4]):
        why = f"Particle 0 falls asleep too early. It was fast itself in step {fast}."
    expect_sleepers_of_steps(seen, [[]] * (fast + 4) + [[0]] * 3, cause=why)
    why = "Particle 1 has become immovable. Skip every contact of an immovable particle."
    text = f"{FIVE}particles 0 and 1 are slow and stay in contact; after 4 steps, particle 1 "
    text += "becomes immovable; which particles are asleep after 12 steps"
    with calls(why, text):
        world, particles, _ = scene([0.0, 0.0], [(0, 1)])
        seen = stepped(world, particles, 4)
        particles[1].mass = math.inf
        seen += stepped(world, particles, 8)
    if [0] in seen and seen[-1] == []:
        why = "Particle 0 falls asleep, but its contact with the immovable particle 1 wakes it. In "
        why += "wake_touched, wake a particle only if the other one of the contact can move."
    elif not any(seen):
        why = "An immovable particle doesn't keep others awake, so skip it in fall_asleep."
    elif any(1 in one for one in seen):
        why = "You put particle 1 to sleep, although it is immovable. Skip immovable particles."
    expect_sleepers(seen[-1], [0], cause=why)


@pytest.mark.exercise("G8.1", asks="only when all of its particles are tired", read=FALL)
def test_a_fast_particle_keeps_its_group_awake() -> None:
    for speeds, pairs, masses, wanted, cause in (
        ([0.0, 2.0, 0.0], [(0, 1)], (), [2], "Particle 1 is fast and touches particle 0, so it "
         "keeps particle 0 awake too. Neither of them should fall asleep."),
        ([0.0, 0.0, 0.0, 2.0, 0.0], [(0, 1), (1, 2), (2, 3)], (), [4], "Particle 3 is fast, so all "
         "that belong to the same group must stay awake, also particles 0 and 1."),
        ([2.0, 0.0, 0.0, 0.0], [(3, 2), (2, 1), (1, 0)], (), [], "Particle 0 is fast, and through "
         "the chain of contacts it keeps all the others awake."),
        ([0.0, 2.0], [(1, 0)], (), [], "Particle 0 touches particle 1, which is fast, so it has to "
         "stay awake. The fast particle can be either one of a pair, so check both."),
        ([0.0, 0.0], [(0, 1)], (), [0, 1], "Both particles are slow, so both fall asleep."),
        ([0.0, 0.0, 2.0], [(0, 1), (1, 2)], [1.0, math.inf, 1.0], [0], "Particle 1 is immovable, "
         "so skip it when you look for groups."),
        ([0.0], [(0, -1)], (), [0], "A wall doesn't keep a particle awake, so skip contacts whose "
         "other is None."),
    ):  # fmt: skip
        moving = "".join(f"only {i} moves, at {v:g} m/s; " for i, v in enumerate(speeds) if v)
        told = ", ".join(f"{i} and {j if j >= 0 else 'a wall'}" for i, j in pairs)
        with calls(cause, f"{FIVE}{len(speeds)} particles; {moving}contacts between {told}{EACH}"):
            world, particles, _ = scene(speeds, pairs, masses)
            seen = stepped(world, particles, 8)
        expect_sleepers_of_steps(seen, [[]] * 4 + [wanted] * 4)


@pytest.mark.exercise("G8.1", asks="Each of them gets its mass back", read=WAKE)
def test_a_particle_stops_and_gets_its_mass_back(rng: Random) -> None:
    mass, speed = positive_number(rng), positive_number(rng, 0.5, 1.0)
    slow = f"a SleepingWorld with sleep_frames=3; a slow particle of {mass} kg, at {speed} m/s; "
    stops = "When a particle falls asleep, set its inverse_mass to 0 and clear its velocity."
    exact = "Exactly three slow steps should move a particle. After that it stays where it is."
    place = (1.0 + 3.0 * speed / 60.0, 2.0, 3.0)
    with calls(stops, f"{slow}the world takes three steps"):
        particle = Particle(Vector3(1.0, 2.0, 3.0), Vector3(speed), mass=mass)
        world = SleepingWorld([particle], sleep_energy=10.0, sleep_frames=3)
        stepped(world, [particle], 3)
    for name, wanted, near, cause in (
        ("inverse_mass", 0.0, 0.0, stops),
        ("velocity", (0.0, 0.0, 0.0), 0.0, stops),
        ("position", place, 1e-12, exact),
    ):
        got = getattr(particle, name)
        expect_close(got, wanted, then=f"; particle.{name}", tolerance=near, cause=cause)
    stepped(world, [particle], 20)
    name = "; particle.position, 20 steps later"
    expect_close(particle.position, place, then=name, tolerance=1e-12, cause=exact)
    with calls(
        "Your particle has the wrong mass when it wakes. In wake, restore its old inverse mass.",
        f"{slow}the particle falls asleep; world.wake(particle)",
    ):
        world.wake(particle)
    expect_close(particle.inverse_mass, 1.0 / mass, then="; particle.inverse_mass")
    remove = "Your particle is still in self.asleep after it wakes. Remove it from there in wake."
    then = "; which particles are asleep"
    expect_sleepers(asleep(world, [particle]), [], then=then, cause=remove)
    reset = "Your particle falls asleep too early or too late after a call to wake. In wake, reset "
    reset += "its count of slow steps to 0, even if the particle is already awake."
    name = "; the number of steps until the particle falls asleep"
    seen = stepped(world, [particle], 10)
    expect_exactly([*seen, [0]].index([0]) + 1, 3, then=name, unit="steps", cause=reset)
    with calls(reset, f"{slow}the particle is awake for two steps; world.wake(particle)"):
        world.wake(particle)
        stepped(world, [particle], 2)
        world.wake(particle)
        seen = stepped(world, [particle], 10)
    expect_exactly([*seen, [0]].index([0]) + 1, 3, then=name, unit="steps")
