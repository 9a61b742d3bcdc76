"""Going further, G8.1: sleep saves work, and changes nothing else."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.sleep_probes import Push, stepped
from ch08_mass_aggregate.sleeping import SleepingWorld
from expect import expect_close, expect_exactly, expect_that, xyz
from sleepers import awake_in, expect_asleep, expect_sleepers

PUSHED = "the docstring of SleepingWorld.wake_pushed"
RUN = "the docstring of SleepingWorld.run_physics"
TENTH = ", every tenth of which calls wake_pushed()"
NEVER = "Some particles are at rest, but they have not fallen asleep. Check fall_asleep first."


def hung(late: int, steps: int, push: float, cause: str) -> list[list[int]]:
    """Return who sleeps if a mass hangs nearly still on a spring, and is pushed after a time."""
    told = f"after step {late}, an extra force of {push} N pushes the particle of 1 kg; "
    told *= late > 0
    start = "particle 0 hangs from a spring and is almost at rest; "
    with calls(cause, f"{start}{told}{steps} steps{TENTH}"):
        particle = Particle(Vector3(0.0, -2.0), Vector3(0.0, 0.05), Vector3(0.0, -10.0))
        world, extra = SleepingWorld([particle], sleep_frames=3), Push()
        world.registry.add(particle, AnchoredSpring(Vector3(), 10.0, 1.0))
        world.registry.add(particle, extra)
        seen = stepped(world, [particle], late)
        extra.x = push
        return [*seen, *stepped(world, [particle], steps - late)]


@pytest.mark.exercise("G8.1", asks="the current |a| + |f / m| or the magnitude", read=PUSHED)
def test_a_hanging_particle_stays_asleep() -> None:
    sum_of_both = "Compare the change with |a| + |f / m| instead of |a + f / m|, which is almost 0 "
    sum_of_both += "because gravity and the spring force cancel."
    small = "Your particle wakes at 0.15 m/s^2, but SAME times |a| + |f / m| is 0.2 m/s^2 here."
    for late, push, cause in ((0, 0.0, sum_of_both), (20, 0.15, small)):
        awake = awake_in(hung(late, 40, push, cause))
        if len(awake) == 36:
            hung(late, 40, push, NEVER)
        expect_asleep(awake, then="; whether particle 0 is asleep after each step from step 5 on")
    large = "Your particle sleeps at 0.5 m/s^2, but SAME times |a| + |f / m| is 0.2 m/s^2 here."
    wakes = [] in hung(20, 31, 0.5, large)[20:]
    expect_that(wakes, "it stays asleep", "it wakes", then="; whether particle 0 wakes")


@pytest.mark.exercise("G8.1", asks="with only the particles that are awake", read=RUN)
def test_sleeping_particles_cost_no_work(rng: Random) -> None:
    count, awake = rng.randint(20, 30), rng.randint(2, 4)
    given = [0]

    def step(those: Any, apply_forces: Any, duration: float) -> None:
        given[0] += len(those)
        semi_implicit_euler(those, apply_forces, duration)

    only = "You pass sleeping particles to the integrator. Pass only those that are awake."
    text = f"{count} particles, each with one force generator; the first {awake} move, and the "
    text += "others are at rest and should be asleep; 20 calls to world.run_physics()"
    with calls(only, text):
        particles, push = [Particle(Vector3(3.0 * i)) for i in range(count)], Push()
        world = SleepingWorld(particles, integrator=step, sleep_frames=3)
        for particle in particles:
            world.registry.add(particle, push)
        for particle in particles[:awake]:
            particle.velocity.y = 5.0
        stepped(world, particles, 10)
        push.asked = given[0] = 0
        sleepers = stepped(world, particles, 20)[-1]
    then = "; which particles are asleep"
    expect_sleepers(sleepers, [*range(awake, count)], then=then, cause=NEVER)
    then = "; the total number of particles passed to the integrator"
    expect_exactly(given[0], 20 * awake, then=then, unit="particles")
    right, asked = 20 * awake + 2 * (count - awake), push.asked
    why = "For sleeping particles, call wake_pushed only every tenth step."
    then = "; the number of calls to update_force"
    expect_exactly(asked, right, then=then, unit="calls", cause=why)


@pytest.mark.exercise("G8.1", asks="fall asleep when they are at rest", read=RUN)
def test_balls_rest_where_they_would_without_sleep() -> None:
    """Only here sleep is compared with a world without it, to show that nothing else changes."""
    ends = []
    text = "two balls bounce for 6 s until they rest, by run_physics(); the final position of a "
    text += "ball, which should be the same as in a world without sleep"
    with calls("You put a ball to sleep while it still moves, so it stops too early.", text):
        for sleep_energy in (0.0, 0.015):
            down = Vector3(0.0, -10.0)
            balls = [
                Particle(Vector3(1.0 * i, 1.0 + 4.0 * i), Vector3(0.5 * i), down, damping=0.5)
                for i in range(2)
            ]
            ground = GroundPlane(balls, restitution=0.4)
            world = SleepingWorld(balls, [ground], sleep_energy=sleep_energy)
            sleepers = stepped(world, balls, 360)[-1]
            ends.append([xyz(ball.position) for ball in balls])
    for wanted, got in zip(*ends, strict=True):
        # A ball that falls asleep has at most 0.17 m/s. Damping of 0.5 would stop it within 0.25 m.
        expect_close(got, wanted, unit="m", tolerance=0.25)
        expect_close(got[1], 0.0, then="; its height above the ground", unit="m", tolerance=1e-6)
    rest = "After six seconds both balls are at rest. Check that both fall asleep."
    expect_exactly(len(sleepers), 2, then="; how many balls are asleep", unit="balls", cause=rest)
