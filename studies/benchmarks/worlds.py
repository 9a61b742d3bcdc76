"""What a world costs: beside the bare steps, asleep, and a rope of rods beside a direct chain."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from studies.constraints import FRAME, GRAVITY, no_forces
from studies.ropes import hang_by_direct_chain, hang_by_rods, polygon_sag
from studies.timing import Line, ratio, timer

COUNT = 1000  # particles that fly freely
BALLS = 300  # of which a tenth moves
FRAMES = 40  # after which what lies still is asleep
RATE = 240  # Hz, of the direct chain
DOWN = Vector3(0.0, -GRAVITY)


def lines() -> list[Line]:
    """Return every line about worlds."""
    bare = flying()
    found = [
        Line(
            f"{COUNT:,} particles in a world / in a bare loop of integrate, by explicit Euler",
            *ratio(
                timer(stepping(ParticleWorld(flying(), integrator=explicit_euler)), 5),
                timer(lambda: integrate(bare), 5),
                101,
                "a world",
            ),
            "at most 1.15",
        ),
        Line(
            "the same / that step alone, both with the velocity first",
            *ratio(
                timer(stepping(ParticleWorld(flying())), 5),
                timer(stepping_bare(semi_implicit_euler, flying()), 5),
                101,
                "a world",
            ),
            "at most 1.15",
        ),
    ]
    for what, make, target in (
        ("on the ground", on_the_ground, "at least 7"),
        ("on springs, without a contact", on_springs, "at least 2"),
    ):
        awake, asleep = make(ParticleWorld), make(SleepingWorld)
        found.append(
            Line(
                f"{BALLS} balls {what}, in a ParticleWorld / nine tenths of them asleep",
                *ratio(timer(stepping(awake)), timer(stepping(asleep)), 41, "sleep"),
                target,
            )
        )
    for links, substeps, rounds in ((10, 16, 11), (100, 16, 3)):
        rods = hang_by_rods(links, 60, substeps, 1.0).sag - polygon_sag(links)
        chain = hang_by_direct_chain(links, RATE, 1.0).sag - polygon_sag(links)
        found.append(
            Line(
                f"a second of a rope of {links} links by rods in {substeps} substeps, too low by "
                f"{rods:.2g} m / by DirectChain at {RATE} Hz, by {chain:.1g} m",
                *ratio(
                    timer(partial(hang_by_rods, links, 60, substeps, 1.0)),
                    timer(partial(hang_by_direct_chain, links, RATE, 1.0)),
                    rounds,
                    "ropes",
                ),
                "at least 10",
            )
        )
    return found


def flying() -> list[Particle]:
    """Return particles that fly, each its own way."""
    return [
        Particle(Vector3(i), Vector3(1.0, 0.001 * i, 2.0), DOWN, damping=0.99) for i in range(COUNT)
    ]


def integrate(particles: Sequence[Particle]) -> None:
    """Move particles on by a frame, without a world."""
    for particle in particles:
        particle.integrate(FRAME)


def stepping(world: ParticleWorld) -> Callable[[], None]:
    """Return what lets a world make a frame."""
    return lambda: world.step(FRAME)


def stepping_bare(step: Integrator, particles: Sequence[Particle]) -> Callable[[], None]:
    """Return what lets an integrator make a frame, without a world."""
    return lambda: step(particles, no_forces, FRAME)


def on_the_ground(kind: type[ParticleWorld]) -> ParticleWorld:
    """Return balls that lie on the ground, and a tenth of them that roll."""
    balls = [Particle(Vector3(2.0 * i), acceleration=DOWN) for i in range(BALLS)]
    return settled(kind(balls, [GroundPlane(balls)]))


def on_springs(kind: type[ParticleWorld]) -> ParticleWorld:
    """Return balls that hang still on springs, and a tenth of them that fly away on theirs."""
    balls = [Particle(Vector3(2.0 * i)) for i in range(BALLS)]
    world = kind(balls)
    for i, ball in enumerate(balls):
        world.registry.add(ball, AnchoredSpring(Vector3(2.0 * i, 1.0), 1e-3, 1.0))
    return settled(world)


def settled(world: ParticleWorld) -> ParticleWorld:
    """Return a world after enough frames for what lies still to sleep, if it ever is to."""
    for ball in world.particles[: BALLS // 10]:
        ball.velocity.z = 5.0
    for _ in range(FRAMES):
        world.step(FRAME)
    return world
