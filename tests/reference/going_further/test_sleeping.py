"""Sleeping particles rest in the right position, wake for every cause, and keep momentum."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring, connect
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.sleeping import LOOK_EVERY, SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
G = 9.81
GRAVITY = Vector3(0.0, -G, 0.0)


def ball(x: float, y: float, mass: float = 1.0, vx: float = 0.0, vy: float = 0.0) -> Particle:
    return Particle(Vector3(x, y), Vector3(vx, vy), GRAVITY, mass=mass)


def run(world: ParticleWorld, frames: int) -> None:
    for _ in range(frames):
        world.step(FRAME)


def scene(kind: type[ParticleWorld]) -> tuple[list[Particle], ParticleWorld]:
    """Return five balls that drop to the ground, two of them on a rod and one on a spring."""
    bodies = [ball(2.0 * i, 0.5 + 0.3 * i, 0.5 + i) for i in range(5)]
    rod = TwoSidedRod(bodies[1], bodies[2], (bodies[2].position - bodies[1].position).magnitude())
    world = kind(bodies, [GroundPlane(bodies, restitution=0.4), rod])
    for body in bodies:
        body.damping = 0.8
    world.registry.add(bodies[4], AnchoredSpring(Vector3(8.0, 3.0), 20.0, 1.0, 3.0))
    return bodies, world


def test_before_anything_sleeps_both_worlds_are_the_same() -> None:
    ends = []
    for kind in (ParticleWorld, SleepingWorld):
        bodies, world = scene(kind)
        run(world, 25)  # fewer frames than sleep_frames
        ends.append([x for body in bodies for x in (*body.position, *body.velocity)])
    assert ends[0] == ends[1]


def test_the_energy_stays_when_bodies_fall_asleep_and_wake() -> None:
    """Bodies on a ground at 2 m have the energy m g y, whether they are awake or asleep."""
    bodies = [ball(3.0 * i, 2.0, 0.5 + i) for i in range(3)]
    world = SleepingWorld(bodies, [GroundPlane(bodies, height=2.0)])
    wanted = G * 2.0 * (0.5 + 1.5 + 2.5)
    counts = set()
    for frame in range(120):
        if frame == 90:
            world.wake(bodies[1])
        world.step(FRAME)
        counts.add(len(world.asleep))
        # A resting body sinks by at most g h^2 in a step, before the ground pushes it back.
        assert world.mechanical_energy() == pytest.approx(wanted, rel=1e-3)
    assert {0, 2, 3} <= counts
    bodies[0].mass = 1.0  # a mass that is set from outside counts, and wakes the body later
    assert world.mechanical_energy() == pytest.approx(wanted + G * 2.0 * 0.5, rel=1e-3)


@pytest.mark.parametrize("mass", [0.01, 1.0, 100.0])
def test_a_ball_does_not_fall_asleep_at_its_highest_point(mass: float) -> None:
    body = ball(0.0, 1.0, mass, vy=5.0)
    world = SleepingWorld([body], [GroundPlane([body])])
    for _ in range(120):
        world.step(FRAME)
        assert body.position.y < 0.01 or body not in world.asleep
    assert body.position.y == pytest.approx(0.0, abs=1e-9)


# Causes that wake a particle


def test_a_generator_that_is_taken_away_wakes() -> None:
    """A balloon of 1 kg hangs still, because its lift is its weight, and falls when that ends."""
    body, lift = ball(0.0, 5.0), Gravity(Vector3(0.0, G))
    world = SleepingWorld([body])
    world.registry.add(body, lift)
    run(world, 60)
    assert body in world.asleep
    world.registry.remove(body, lift)
    run(world, 60 + LOOK_EVERY)
    assert body.position.y < 5.0 - 0.5 * G * 0.9  # after falling for most of a second


def test_momentum_is_kept_when_a_sleeper_is_hit() -> None:
    """1 kg at 3 m/s sticks to 2 kg that sleep, so both move at 1 m/s. There is no gravity."""
    sleeper, bullet = Particle(mass=2.0), Particle(Vector3(-3.0), Vector3(3.0))
    bodies = [sleeper, bullet]
    world = SleepingWorld(bodies, [ParticlePairs(bodies, 0.25)])
    run(world, 40)
    assert sleeper in world.asleep
    run(world, 40)
    assert sleeper.velocity.x == pytest.approx(1.0, rel=1e-12)
    assert bullet.velocity.x == pytest.approx(1.0, rel=1e-12)
    assert world.asleep == {}


def test_a_hit_goes_through_a_row_that_sleeps() -> None:
    """With five touching elastic balls, the last one leaves at full speed in the same frame."""
    row = [Particle(Vector3(0.5 * i)) for i in range(5)]
    bullet = Particle(Vector3(-3.0), Vector3(4.0))
    bodies = [bullet, *row]
    world = SleepingWorld(bodies, [ParticlePairs(bodies, 0.25, 1.0)], iterations=50)
    run(world, 35)
    assert len(world.asleep) == 5
    run(world, 5)
    assert bullet.velocity.x == pytest.approx(0.0, abs=1e-12)
    assert row[-1].velocity.x == pytest.approx(4.0, rel=1e-12)
    assert math.fsum(p.velocity.x for p in bodies) == pytest.approx(4.0, rel=1e-12)


def test_an_immovable_particle_neither_sleeps_nor_wakes_what_lies_on_it() -> None:
    base, body = Particle(mass=math.inf), ball(0.0, 1.0)
    bodies = [base, body]
    world = SleepingWorld(bodies, [ParticlePairs(bodies, 0.5)])
    run(world, 120)
    assert set(world.asleep) == {body}
    assert body.position.y == pytest.approx(1.0, abs=1e-3)
    world.wake(body)
    assert body.mass == 1.0
    assert world.asleep == {}


def test_a_spring_pulls_at_the_end_that_is_awake_though_the_other_one_sleeps() -> None:
    """1 kg swings on a spring of 50 N/m above sleeping 1000 kg: by 0.196 m around 1.104 m."""
    heavy, bob = ball(0.0, 0.0, 1000.0), ball(0.0, 1.3)
    world = SleepingWorld([heavy, bob], [GroundPlane([heavy, bob])])
    connect(world.registry, heavy, bob, 50.0, 1.3)
    for _ in range(300):
        world.step(FRAME)
        # Its energy oscillates by a fraction w h / 2, with w = 7: 0.01 m of the swing.
        assert abs(bob.position.y - (1.3 - G / 50.0)) < G / 50.0 + 0.012


def test_what_lay_on_a_ball_falls_when_that_is_knocked_away() -> None:
    bodies = [ball(0.0, 0.5), ball(0.0, 1.5)]
    grounds = [GroundPlane(bodies, radius=0.5), ParticlePairs(bodies, 0.5)]
    world = SleepingWorld(bodies, grounds, iterations=100)
    run(world, 200)
    assert len(world.asleep) == 2
    bodies[0].velocity = Vector3(10.0)
    run(world, 120)
    assert bodies[1].position.y == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize(("mass", "rate"), [(0.005, 240), (1e-4, 60)])
def test_a_light_ball_does_not_fall_asleep_in_the_air(mass: float, rate: int) -> None:
    body = ball(0.0, 1.0, mass, vy=5.0)
    world = SleepingWorld([body], [GroundPlane([body])])
    for _ in range(2 * rate):
        world.step(1.0 / rate)
    assert body.position.y == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(("n", "iterations"), [(2, 20), (5, 200)])
def test_a_stack_falls_asleep(n: int, iterations: int | None) -> None:
    """Contacts end because of rounding or of the resolver's error, and then a ball falls a frame.

    With the default iterations the stack creeps too fast to sleep.
    """
    bodies = [ball(0.0, 0.5 + i) for i in range(n)]
    grounds = [GroundPlane(bodies, radius=0.5), ParticlePairs(bodies, 0.5)]
    world = SleepingWorld(bodies, grounds, iterations=iterations)
    run(world, 300)
    assert len(world.asleep) == n
