"""Going further, G8.1: what wakes sleeping particles, and what does not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import Spring, connect
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch08_mass_aggregate.probes import add
from ch08_mass_aggregate.sleep_probes import Push, Touch, Wall, asleep, stepped
from ch08_mass_aggregate.sleeping import SleepingWorld
from draw import positive_number
from expect import expect_close, expect_exactly, expect_that, named, xyz
from sleepers import expect_asleep, expect_sleepers, expect_sleepers_of_steps

WAKE = "the docstring of SleepingWorld.wake, and fall_asleep"
MOVED, PUSHED, TOUCHED, RUN = (
    f"the docstring of SleepingWorld.{name}"
    for name in ("wake_moved", "wake_pushed", "wake_touched", "run_physics")
)
FRAME = 1.0 / 60.0
TENTH = ", every tenth of which calls wake_pushed()"
NEVER = "The particles are at rest, but they have not fallen asleep. Check fall_asleep first."
BEFORE, AFTER = "; which particles are asleep before that", "; which particles are asleep afterward"
UNITS = {"velocity": "m/s", "force": "N", "position": "m"}
SIGNS = {
    "velocity": "its velocity is no longer 0",
    "force": "its force_accumulator is no longer 0",
    "position": "its position differs from the one stored in self.asleep",
    "mass": "its inverse_mass is no longer 0",
}
PAIRS = ([(1, 0), (0, 2), (3, 0)], [(0, 1), (2, 0), (0, 3)])


def on_ground(how: str, axis: str, by: float, count: int, cause: str) -> tuple[Any, Any, Any]:
    """Let particles of 2 kg sleep on the ground, and change the last two.

    Return who sleeps before, and after one more step, and the last particle.
    """
    new = f"the {axis} component of its {how} changes by {by} {UNITS.get(how)}"
    new = {"nothing": "nothing about it changes", "mass": f"its mass becomes {by} kg"}.get(how, new)
    last = "1 and of particle 2" if count > 1 else "0"
    with calls(cause, f"{count} particles of 2 kg sleep on the ground; of particle {last}, {new}"):
        made = [
            Particle(Vector3(3.0 * i), acceleration=Vector3(0.0, -10.0), mass=2.0)
            for i in range(count)
        ]
        world = SleepingWorld(made, [GroundPlane(made)], sleep_frames=3)
        before = stepped(world, made, 5)[-1]
    with calls(cause, "one step of 1/60 s, which calls wake_moved()", more=True):
        world.start_frame()
        for particle in made[-2:]:
            if how == "mass":
                particle.mass = by
            elif how == "force":
                particle.add_force(Vector3(**{axis: by}))
            elif how != "nothing":
                vector = getattr(particle, how)
                setattr(vector, axis, getattr(vector, axis) + by)
        world.run_physics(FRAME)
    return before, asleep(world, made), made[-1]


@pytest.mark.exercise("G8.1", asks="that code outside the world has changed", read=MOVED)
@pytest.mark.parametrize(
    ("how", "axis", "by", "sleeps", "mass", "velocity"),
    [
        ("nothing", "", 0.0, [0], math.inf, (0.0, 0.0, 0.0)),
        ("velocity", "x", 3.0, [], 2.0, (3.0, 0.0, 0.0)),
        ("force", "x", 60.0, [], 2.0, (0.5, 0.0, 0.0)),
        ("position", "y", 5.0, [], 2.0, (0.0, -1.0 / 6.0, 0.0)),
        ("mass", "", 4.0, [], 4.0, (0.0, 0.0, 0.0)),
    ],
    ids=["nothing", "velocity", "force", "place", "mass"],
)
def test_a_changed_particle_wakes(
    how: str, axis: str, by: float, sleeps: list[int], mass: float, velocity: Sequence[float]
) -> None:
    why = f"A sleeping particle doesn't wake when its {how} changes. In wake_moved, also check "
    why += f"whether {SIGNS.get(how)}."
    if how == "nothing":
        why = "Your particle wakes although nothing about it has changed. Wake it only if its "
        why += "velocity, position, mass or force has changed since it fell asleep."
    late = "Your particle wakes too late to move. Call wake_moved before the integrator."
    if how == "force" and any(xyz(on_ground("position", "y", 5.0, 1, why)[2].velocity)):
        late = "The force is lost. If wake_moved takes it from the accumulator, add it again."
    before, got, particle = on_ground(how, axis, by, 1, why)
    expect_sleepers(before, [0], then=BEFORE, cause=NEVER)
    expect_sleepers(got, sleeps, then=AFTER)
    old = "Your particle has the wrong mass after it wakes. Restore its old mass."
    if how == "mass":
        old = "You overwrite the new mass. Restore the old one only if the mass is still infinite."
    then = "; the inverse mass of the particle, in 1/kg"
    expect_close(1.0 / particle.mass, 1.0 / mass, then=then, tolerance=1e-12, cause=old)
    then = "; particle.velocity"
    expect_close(particle.velocity, velocity, then=then, unit="m/s", tolerance=1e-12, cause=late)


@pytest.mark.exercise("G8.1", asks="if any of this is no longer true", read=MOVED)
@pytest.mark.parametrize(
    "how", ["velocity", "force", "position"], ids=["velocity", "force", "place"]
)
def test_a_slightly_changed_particle_wakes(how: str) -> None:
    for axis, by in product("xyz", (1e-3, -1e-3)):
        before, after, _ = on_ground(how, axis, by, 3, NEVER)
        expect_sleepers(before, [0, 1, 2], then=BEFORE)
        why = f"You don't detect a new {how} along {axis}. Compare all three components."
        if by < 0.0:
            why = f"You detect a new {how} only if a component increases. It can also decrease."
        if after in ([0, 1], [0, 2]):
            why = f"You wake only one of two particles with a new {how}. Check all that sleep."
        elif 0 not in after:
            why = "You also wake particle 0, although nothing about it has changed."
        expect_sleepers(after, [0], then=AFTER, cause=why)


def at_wall(*forces: float) -> tuple[Any, Any, list[Any]]:
    """Return a particle of 2 kg at a wall, its world, and the forces per kg that push it."""
    particle, pushes = Particle(mass=2.0), [Push(force) for force in forces]
    world = SleepingWorld([particle], [Wall(particle)], sleep_energy=1e-4, sleep_frames=3)
    for push in pushes:
        world.registry.add(particle, push)
    return particle, world, pushes


@pytest.mark.exercise("G8.1", asks="must be empty again when it returns", read=PUSHED)
def test_a_pushed_particle_moves_in_the_same_step(rng: Random) -> None:
    x, y = -positive_number(rng, 6.0, 9.0), positive_number(rng, 0.2, 0.9)
    own = "You call the generators while the mass is infinite. Restore its own mass meanwhile."
    same = "Particle 0 wakes although the forces on it are still the same. Compare a + f / m."
    clear = "The forces that you evaluated for the comparison are still in the accumulator. If the "
    clear += "particle stays asleep, clear the accumulator and set inverse_mass back to 0."
    stays = "Your particle stays asleep although the forces on it have changed by more than 1%. "
    stays += "Wake it in wake_pushed, which run_physics must call every LOOK_EVERY steps."
    late = "The particle wakes too late to move. Call wake_pushed before the integrator."
    twice = "The forces act twice. Clear the accumulator after your comparison."
    duration = "Pass the duration of the step on to the force generators."
    for (dx, dy), velocity in (
        ((x, 0.0), ((5.0 + x) / 60.0, 0.0, 0.0)),
        ((0.0, y), (0.0, y / 60.0, 0.0)),
        ((0.1, 0.0), (0.0, 0.0, 0.0)),
        ((-0.1, 0.0), (0.0, 0.0, 0.0)),
    ):
        text = "two forces of 6 N and 4 N along X push particle 0, of 2 kg, against a wall; 40 "
        text += f"steps of 1/60 s{TENTH}"
        with calls(own, text):
            particle, world, (push, other) = at_wall(3.0, 2.0)
            stepped(world, [particle], 16)
            sums = set()
            for _ in range(24):
                seen = stepped(world, [particle], 1)[-1]
                sums.add(xyz(particle.force_accumulator))
        expect_sleepers(seen, [0], then="; which particles are asleep", cause=same)
        name = "; all values of particle.force_accumulator while the particle was asleep"
        expect_exactly(sorted(sums), [(0.0, 0.0, 0.0)], then=name, cause=clear)
        force = f"({4.0 + 2.0 * dx:g}, {2.0 * dy:g}, 0)"
        with calls(
            own, f"the second force changes from (4, 0, 0) to {force} N; 10 more steps", more=True
        ):
            other.x, other.y = 2.0 + dx, dy
            steps = 0
            while steps < 10 and stepped(world, [particle], 1) == [[0]]:
                steps += 1
        then = "; whether particle 0 wakes"
        expect_that(steps < 10, "it stays asleep", "it wakes", then=then, cause=stays)
        slips = {twice: [2.0 * part for part in velocity]} if any(velocity) else {}
        name = "; the velocity of particle 0 after the step in which it wakes"
        got, near = xyz(particle.velocity), 1e-12
        why = named(got, late, slips)
        expect_close(got, velocity, then=name, unit="m/s", tolerance=near, cause=why)
        name = "; the durations that the generators got"
        expect_exactly(sorted(set(push.durations)), [FRAME], then=name, cause=duration)


@pytest.mark.exercise("G8.1", asks="acceleration has changed since it fell asleep", read=PUSHED)
@pytest.mark.parametrize(
    ("old", "new", "late"),
    [(5.0, -5.0, False), (0.0, -5.0, False), (5.0, -8.0, True)],
    ids=["turned round", "switched on", "another generator"],
)
def test_a_changed_force_wakes_a_particle(old: float, new: float, late: bool) -> None:
    how = "a new generator adds a force of" if late else "the force changes to"
    with calls(
        "Your particle stays asleep although the force on it has changed. Wake it in wake_pushed, "
        "which run_physics must call every LOOK_EVERY steps.",
        f"particle 0, of 2 kg, sleeps next to a wall, under a force of {2.0 * old:g} N along X; "
        f"then {how} {2.0 * new:g} N along X; 10 steps{TENTH}",
    ):
        particle, world, (push,) = at_wall(old)
        before = stepped(world, [particle], 25)[-1]
        if late:
            world.registry.add(particle, Push(new))
        else:
            push.x = new
        after = stepped(world, [particle], 10)[-1]
    expect_sleepers(before, [0], then=BEFORE, cause=NEVER)
    expect_sleepers(after, [], then=AFTER)


@pytest.mark.exercise("G8.1", asks="The particle wakes if the change is more than", read=PUSHED)
def test_an_unchanged_force_wakes_no_particle(rng: Random) -> None:
    old = positive_number(rng, 2.0, 9.0)
    for new in (old, 1.009 * old, 0.991 * old):
        why = "Your particle wakes although the force has changed by less than SAME, which is 1%. "
        why += "Wake it only if its acceleration changes by more than that."
        if new == old:
            why = "Your particle wakes although its force is unchanged. Set inverse_mass back to 0."
        text = f"particle 0, of 2 kg, sleeps while a force of {2.0 * old:g} N pushes it against a "
        text += f"wall; the force becomes {2.0 * new:.6g} N; 25 steps{TENTH}"
        with calls(why, text):
            particle, world, (push,) = at_wall(old)
            before = stepped(world, [particle], 25)[-1]
            push.x = new
            seen = stepped(world, [particle], 25)
        expect_sleepers(before, [0], then=BEFORE, cause=NEVER)
        awake = [i for i, one in enumerate(seen, 1) if one != [0]]
        expect_asleep(awake, then="; whether particle 0 is asleep after each step")


@pytest.mark.exercise("G8.1", asks="in contact with a particle that can move", read=TOUCHED)
@pytest.mark.parametrize("first", [False, True], ids=["the last in the list", "the first"])
def test_a_touched_group_wakes(rng: Random, first: bool) -> None:
    speed = positive_number(rng, 4.0, 9.0)
    far = "Particle 3 is still far away. Wake a particle only when another one touches it."
    text = f"particles 0, 1 and 2 sleep side by side; particle 3 moves toward them at {speed} m/s; "
    text += "steps of 1/60 s, each of which calls wake_touched()"
    with calls(far, text):
        down = Vector3(0.0, -10.0)
        balls = [Particle(Vector3(1.0 * i, 0.5), acceleration=down) for i in range(3)]
        shot = Particle(Vector3(-3.0, 0.5), Vector3(speed), acceleration=down)
        every = [*balls, shot]
        pairs = ParticlePairs([shot, *balls] if first else every, 0.5, restitution=1.0)
        world = SleepingWorld(balls, [GroundPlane(every, radius=0.5), pairs], sleep_frames=3)
        before = stepped(world, every, 5)[-1]
        add(world, [shot])
        soon = now = stepped(world, every, 1)[-1]
        for _ in range(39):
            now = now if now != [0, 1, 2] else stepped(world, every, 1)[-1]
        momentum = sum(ball.velocity.x for ball in every)  # each has 1 kg
    expect_sleepers(before, [0, 1, 2], then=BEFORE, cause=NEVER)
    expect_sleepers(soon, [0, 1, 2], then="; which particles are asleep after one step")
    why = "Only some of the particles wake. A particle that wakes can touch the next one, so go "
    why += "through the contacts again until no more particles wake in this step."
    if now == [0, 1, 2]:
        why = "No particle wakes. Wake either particle of a contact if the other one can move."
    expect_sleepers(now, [], then="; which particles are asleep after the hit", cause=why)
    why = "Momentum is lost. Call wake_touched before you resolve the contacts."
    name = "; the total momentum along X after the step in which particle 3 hits another"
    expect_close(momentum, speed, then=name, unit="kg m/s", tolerance=1e-9, cause=why)


@pytest.mark.exercise("G8.1", asks="in contact with a particle that can move", read=TOUCHED)
def test_a_resting_particle_wakes_a_sleeper() -> None:
    for order in ((0, 1), (1, 0)):
        with calls(
            "Your particle 0 should wake, because particle 1 can move, even though it is at rest. "
            "The sleeper can be either particle of a contact, so check both.",
            f"particle 0 sleeps; particle 1 is at rest but awake; a contact of {order}; "
            "wake_touched(); which particles are asleep before it (step 1) and after it (step 2)",
        ):
            particles = [Particle(Vector3(3.0 * i)) for i in range(2)]
            touch = Touch(particles, [])
            world = SleepingWorld(particles[:1], [touch], sleep_frames=3)
            before = stepped(world, particles, 5)[-1]
            add(world, particles[1:])
            touch.pairs = [order]
            after = stepped(world, particles, 1)[-1]
        expect_sleepers_of_steps([before, after], [[0], []])


@pytest.mark.exercise("G8.1", asks="If a contact wakes a particle, find the contacts", read=RUN)
def test_a_woken_particle_stays_on_the_ground(rng: Random) -> None:
    speed = positive_number(rng, 4.0, 9.0)
    with calls(
        "Particle 0 is pushed into the ground, because a sleeping particle has no contact with the "
        "ground. Find the contacts again after particle 0 has woken.",
        f"particle 0 sleeps on the ground; particle 1 falls on particle 0 at {speed} m/s; "
        "run_physics(), which wakes particle 0",
    ):
        world, balls = stacked(3.0, 200, 1)
        before = stepped(world, balls, 5)[-1]
        balls[1].velocity.y = -speed
        add(world, balls[1:])
        for _ in range(60):
            if stepped(world, balls, 1) != [[0]]:
                break
    expect_sleepers(before, [0], then=BEFORE, cause=NEVER)
    # Two hundred iterations leave some 1e-9 m/s.
    then = "; the vertical velocity of particle 0"
    expect_close(balls[0].velocity.y, 0.0, then=then, unit="m/s", tolerance=1e-6)
    then = "; the height of particle 0"
    expect_close(balls[0].position.y, 0.5, then=then, unit="m", tolerance=1e-6)


def stacked(apart: float, iterations: int, count: int = 2) -> tuple[Any, list[Any]]:
    """Return a ball on the ground and one above it, and a world with as many of them."""
    down = Vector3(0.0, -10.0)
    balls = [Particle(Vector3(0.0, 0.5 + apart * i), acceleration=down) for i in range(2)]
    grounds = [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)]
    world = SleepingWorld(balls[:count], grounds, iterations=iterations, sleep_frames=3)
    return world, balls


@pytest.mark.exercise("G8.1", asks="fell asleep together therefore wake together", read=WAKE)
def test_a_group_wakes_together() -> None:
    why = "Particle 1 stays asleep although its neighbor, particle 0, wakes. In fall_asleep, store "
    why += "a particle's neighbors in its Sleep, and let wake continue with them."
    text = "particle 1 sleeps on top of particle 0; particle 0 is moved away; 6 steps, the first "
    text += "of which calls wake()"
    with calls(why, text):
        world, balls = stacked(1.0, 50)
        before = stepped(world, balls, 30)[-1]
        balls[0].position.x = 50.0
        seen = stepped(world, balls, 6)
    expect_sleepers(before, [0, 1], then=BEFORE, cause=NEVER)
    if 0 in seen[0]:  # later it sleeps again
        why = "Particle 0 stays asleep although it was moved. Check wake_moved first."
    then = "; whether particle 1 is awake"
    expect_that(1 not in seen[-1], "it is asleep", "it is awake", then=then, cause=why)
    why = "Wake both particles in the same step, before you call the integrator."
    then, got = "; particle 1's velocity along Y", balls[1].velocity.y
    expect_close(got, -1.0, then=then, unit="m/s", tolerance=0.01, cause=why)
    for pairs, first in product(PAIRS, range(4)):
        text = f"particles 0 to 4 sleep; earlier, these pairs were in contact: {pairs}; particle "
        text += f"{first} is set in motion; one step, which calls wake()"
        with calls("Wake the neighbors of every particle that wakes.", text):
            particles = [Particle(Vector3(3.0 * i)) for i in range(5)]
            touch = Touch(particles, pairs)
            world = SleepingWorld(particles, [touch], sleep_frames=5)
            stepped(world, particles, 4)
            touch.pairs = []
            before = stepped(world, particles, 2)[-1]
            particles[first].velocity.z = 1.0
            now = stepped(world, particles, 1)[-1]
        expect_sleepers(before, [0, 1, 2, 3, 4], then=BEFORE, cause=NEVER)
        why = "You wake only part of the group. Wake the neighbors of every particle that wakes."
        if 4 not in now:
            why = "You wake particle 4, which is not a neighbor. Wake only neighbors."
        expect_sleepers(now, [4], then=AFTER, cause=why)
    with calls(
        "Some particles stay asleep although springs connect them to particle 2. In fall_asleep, "
        "also treat the pairs in joined(self.registry) as neighbors.",
        "particles 0, 1 and 2 sleep in a row, joined by two springs; particle 2 is set in motion "
        "at 6 m/s; steps of 1/60 s, the first of which calls wake()",
    ):
        made = [Particle(Vector3(1.0 * i), damping=0.9) for i in range(3)]
        world = SleepingWorld(made, sleep_frames=3)
        connect(world.registry, made[0], made[1], 20.0, 1.0)
        world.registry.add(made[1], Spring(made[2], 20.0, 1.0))
        world.registry.add(made[2], Spring(made[1], 20.0, 1.0))
        before = stepped(world, made, 5)[-1]
        made[2].velocity.x = 6.0
        now = stepped(world, made, 20)[0]
    expect_sleepers(before, [0, 1, 2], then=BEFORE, cause=NEVER)
    expect_sleepers(now, [], then="; which particles are asleep after one step")
    why = "Your center of mass doesn't move at 2 m/s, probably because one particle is still "
    why += "asleep while the others move. Wake all three in the same step."
    drift = 2.0 * sum(0.9 ** (i / 60.0) for i in range(1, 21)) / 60.0
    middle = math.fsum(particle.position.x for particle in made) / 3.0 - 1.0
    then = "; how far the center of mass moves in 20 steps"
    expect_close(middle, drift, then=then, unit="m", tolerance=1e-9, cause=why)
