"""Measure the overhead of a ParticleWorld, and the time that sleep and a DirectChain save."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.sleeping import LOOK_EVERY, SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import FRAME
from scenes.hanging_rope import hang_by_direct_chain, hang_by_rods, polygon_sag
from scenes.resolving import no_forces
from scenes.spheres import GRAVITY
from scenes.timing import Measurement, Target, timer, versus
from studies.models.heap_resolver import HeapResolver

COUNT = 1000  # particles that fly freely
BALLS = 300  # of which a tenth move
FRAMES = 40  # enough for resting balls to fall asleep
RATE = 240  # Hz, of the direct chain
SUBSTEPS = 16  # per frame, of the rods
DOWN = Vector3(0.0, -GRAVITY)


def lines() -> list[Measurement]:
    """Set up the benchmarks for particle worlds, sleeping balls and hanging ropes."""
    loop = partial(integrate, flying())
    bare = stepping_bare(semi_implicit_euler, flying())
    return [
        overhead("explicit Euler", "a plain loop", explicit_euler, loop),
        overhead("semi-implicit Euler", "the integrator", semi_implicit_euler, bare),
        asleep("on the ground", on_the_ground, Target("at least", 7)),
        asleep("on springs, without contacts", on_springs, Target("at least", 2)),
        rope(10, 11),
        rope(100, 3),
    ]


def overhead(
    name: str, other: str, integrator: Integrator, bare: Callable[[], None]
) -> Measurement:
    """Set up a benchmark that measures how much longer a world takes than its integrator alone."""
    world = ParticleWorld(flying(), integrator=integrator)
    return Measurement(
        f"{COUNT:,} particles, {name}: ParticleWorld.step / {other}",
        versus(timer(stepping(world), 5), timer(bare, 5)),
        101,
        Target("at most", 1.15),
    )


def asleep(
    what: str, make: Callable[[type[ParticleWorld]], ParticleWorld], target: Target
) -> Measurement:
    """Set up a benchmark that measures how much time is saved if nine tenths of the balls sleep."""
    worlds = make(ParticleWorld), make(SleepingWorld)
    return Measurement(
        f"{BALLS} balls {what}: ParticleWorld / SleepingWorld with nine tenths of them asleep",
        # Each measured time includes one of the frames that check whether anything pushes a ball.
        versus(*(timer(stepping(world), LOOK_EVERY) for world in worlds)),
        21,
        target,
    )


def rope(links: int, rounds: int) -> Measurement:
    """Set up a benchmark of a hanging rope that also states the error in the sag of both ropes."""
    rods = partial(hang_by_rods, links, SUBSTEPS, 1.0, HeapResolver())
    chain = partial(hang_by_direct_chain, links, RATE, 1.0)
    wanted = polygon_sag(links)
    low, off = rods().sag - wanted, chain().sag - wanted
    return Measurement(
        f"one second of a rope of {links} links: rods in {SUBSTEPS} substeps by HeapResolver "
        f"(error {low:.2g} m) / DirectChain at {RATE} Hz (error {off:.1g} m)",
        versus(timer(rods), timer(chain)),
        rounds,
        Target("at least", 10),
    )


def flying() -> list[Particle]:
    """Create COUNT particles that fly freely, each with a different velocity."""
    return [
        Particle(Vector3(i), Vector3(1.0, 0.001 * i, 2.0), DOWN, damping=0.99) for i in range(COUNT)
    ]


def integrate(particles: Sequence[Particle]) -> None:
    """Advance particles by one frame in a plain loop instead of a ParticleWorld."""
    for particle in particles:
        particle.integrate(FRAME)


def stepping(world: ParticleWorld) -> Callable[[], None]:
    return lambda: world.step(FRAME)


def stepping_bare(step: Integrator, particles: Sequence[Particle]) -> Callable[[], None]:
    """Return a function that advances particles by one frame without a ParticleWorld."""
    return lambda: step(particles, no_forces, FRAME)


def on_the_ground(kind: type[ParticleWorld]) -> ParticleWorld:
    """Create a world in which one ball in ten rolls on the ground, and the others lie still."""
    balls = [Particle(Vector3(2.0 * i), acceleration=DOWN) for i in range(BALLS)]
    return settled(kind(balls, [GroundPlane(balls)]))


def on_springs(kind: type[ParticleWorld]) -> ParticleWorld:
    """Create a world in which one ball in ten flies away, and the others hang still on springs."""
    balls = [Particle(Vector3(2.0 * i)) for i in range(BALLS)]
    world = kind(balls)
    for i, ball in enumerate(balls):
        world.registry.add(ball, AnchoredSpring(Vector3(2.0 * i, 1.0), 1e-3, 1.0))
    return settled(world)


def settled(world: ParticleWorld) -> ParticleWorld:
    """Push one ball in ten, and run the world until a SleepingWorld lets the others sleep."""
    for ball in world.particles[: BALLS // 10]:
        ball.velocity.z = 5.0
    for _ in range(FRAMES):
        world.step(FRAME)
    return world
