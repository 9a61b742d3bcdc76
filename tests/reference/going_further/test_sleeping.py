"""Sleeping particles rest in the right position, and keep energy and momentum."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import connect
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.sleeping import SleepingWorld

FRAME = 1.0 / 60.0
G = 9.81


def ball(x: float, y: float, mass: float = 1.0, vy: float = 0.0) -> Particle:
    return Particle(Vector3(x, y), Vector3(0.0, vy), Vector3(0.0, -G), mass=mass)


def run(world: SleepingWorld, frames: int) -> None:
    for _ in range(frames):
        world.step(FRAME)


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


@pytest.mark.parametrize(("mass", "rate"), [(1.0, 60), (100.0, 60), (0.005, 240), (1e-4, 60)])
def test_a_ball_does_not_fall_asleep_in_the_air(mass: float, rate: int) -> None:
    """At its highest point it is as slow as if it were at rest."""
    body = ball(0.0, 1.0, mass, vy=5.0)
    world = SleepingWorld([body], [GroundPlane([body])])
    for _ in range(2 * rate):
        world.step(1.0 / rate)
        assert body.position.y < 0.01 or body not in world.asleep
    assert body.position.y == pytest.approx(0.0, abs=1e-9)


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


@pytest.mark.parametrize("first", [True, False])
def test_what_an_immovable_particle_holds_sleeps_alone(first: bool) -> None:
    """Of two particles on rods around the same nail, one rests and one circles."""
    nail, still, circling = Particle(mass=math.inf), Particle(Vector3(1.0)), Particle(Vector3(-1.0))
    circling.velocity.y = 2.0
    pairs = [(nail, one) if first else (one, nail) for one in (still, circling)]
    rods = [TwoSidedRod(a, b, 1.0) for a, b in pairs]
    world = SleepingWorld([nail, still, circling], rods)
    run(world, 60)
    assert set(world.asleep) == {still}


def test_a_spring_pulls_at_the_end_that_is_awake_though_the_other_one_sleeps() -> None:
    """1 kg swings on a spring of 50 N/m above sleeping 1000 kg: by 0.196 m around 1.104 m."""
    heavy, bob = ball(0.0, 0.0, 1000.0), ball(0.0, 1.3)
    world = SleepingWorld([heavy, bob], [GroundPlane([heavy, bob])])
    connect(world.registry, heavy, bob, 50.0, 1.3)
    for _ in range(300):
        world.step(FRAME)
        # Its energy oscillates by a fraction w h / 2, with w = 7: 0.01 m of the swing.
        assert abs(bob.position.y - (1.3 - G / 50.0)) < G / 50.0 + 0.012


@pytest.mark.parametrize(("n", "iterations"), [(2, 20), (5, 200)])
def test_a_stack_falls_asleep_and_falls_when_its_base_is_knocked_away(
    n: int, iterations: int
) -> None:
    """With the default iterations the stack creeps too fast to sleep."""
    bodies = [ball(0.0, 0.5 + i) for i in range(n)]
    grounds = [GroundPlane(bodies, radius=0.5), ParticlePairs(bodies, 0.5)]
    world = SleepingWorld(bodies, grounds, iterations=iterations)
    run(world, 300)
    assert len(world.asleep) == n
    bodies[0].velocity = Vector3(10.0)
    run(world, 120)
    assert bodies[1].position.y == pytest.approx(0.5, abs=0.01)
