"""Run random worlds with the engine that is on the path, and print their states as JSON.

    python worlds.py SEED FOLDER ...

Each folder of the engine is one argument.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable
from random import Random
from typing import Any

sys.path[1:1] = sys.argv[2:]

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs import integrators
from ch06_springs.springs import AnchoredBungee, AnchoredSpring, Bungee, Spring, connect
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredRod, Cable, Rod, TwoSidedRod
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
STEPS = 60
GRAVITY = Vector3(0.0, -9.81, 0.0)


def vector(rng: Random, size: float) -> Vector3:
    return Vector3(*(rng.uniform(-size, size) for _ in range(3)))


class Slowed(Particle):
    """A particle with a kick and a drift of its own, which every integrator has to call."""

    __slots__ = ()

    def kick(self, duration: float) -> None:
        super().kick(duration)
        self.velocity *= 0.99

    def drift(self, duration: float) -> None:
        super().drift(0.5 * duration)
        super().drift(0.5 * duration)


def drawn(rng: Random, count: int, kind: type[Particle] = Particle) -> list[Particle]:
    """Draw particles near the origin. About one in five is immovable, and some are damped."""
    return [
        kind(
            vector(rng, 3.0),
            vector(rng, 2.0),
            GRAVITY,
            mass=rng.choice([0.5, 1.0, 2.0, 7.0, float("inf")]),
            damping=rng.choice([1.0, 0.9, 0.3]),
        )
        for _ in range(count)
    ]


def falling(rng: Random) -> Iterable[Particle]:
    """Throw particles, and push some of them in some of the steps."""
    particles = drawn(rng, 12)
    for _ in range(STEPS):
        for particle in particles:
            if rng.random() < 0.3:
                particle.add_force(vector(rng, 20.0))
            particle.integrate(rng.choice([FRAME, 0.5 * FRAME]))
        if rng.random() < 0.1:
            particles[0].damping, particles[1].mass = rng.random(), 1.0 + rng.random()
    return particles


def on_springs(name: str) -> Callable[[Random], Iterable[Particle]]:
    """Return a function that lets particles on springs and ropes swing by an integrator.

    Of the eight particles, all or only the first one move, and a subclass has its own kicks.
    """

    def run(rng: Random, kind: type[Particle], moving: int) -> list[Particle]:
        particles = drawn(rng, 8, kind)
        registry = ForceRegistry()
        for one, other in zip(particles, [*particles[1:], particles[0]], strict=True):
            connect(registry, one, other, rng.uniform(1.0, 40.0), rng.uniform(0.0, 2.0), 0.1)
            registry.add(one, Spring(other, rng.uniform(1.0, 20.0), 1.0, rng.uniform(0.0, 0.5)))
            registry.add(one, Bungee(other, 15.0, rng.uniform(0.5, 3.0), 0.2))
            registry.add(one, AnchoredSpring(vector(rng, 1.0), 10.0, 1.0, 0.3))
            registry.add(one, AnchoredBungee(vector(rng, 1.0), 5.0, 1.0))
            registry.add(one, Drag(0.1, 0.02))
        step = getattr(integrators, name)
        for _ in range(STEPS):
            for particle in particles:
                if rng.random() < 0.2:
                    particle.add_force(vector(rng, 5.0))
            step(particles[:moving], registry.update_forces, FRAME)
        return particles

    kinds = ((Particle, 8), (Particle, 1), (Slowed, 8))
    return lambda rng: [particle for kind in kinds for particle in run(rng, *kind)]


def in_contact(kind: Callable[..., Any]) -> Callable[[Random], Iterable[Particle]]:
    """Return a function that lets balls, rods and cables fall, in a world or with a solver."""

    def run(rng: Random) -> Iterable[Particle]:
        balls = drawn(rng, 8)
        for i, ball in enumerate(balls):
            ball.position, ball.mass = Vector3(1.3 * i, rng.uniform(0.4, 1.5)), rng.uniform(0.5, 3)
        rods: list[Any] = [TwoSidedRod(balls[0], balls[1], 1.4), Rod(balls[6], balls[7], 1.3)]
        rods.append(AnchoredRod(balls[4], Vector3(5.2, 3.0), 2.0))
        ground = GroundPlane(balls, radius=0.3, restitution=0.4)
        cable, pairs = Cable(balls[2], balls[3], 1.5, 0.2), ParticlePairs(balls, 0.3, 0.5)
        world = kind(balls, [ground, pairs, *rods, cable])
        for i, ball in enumerate(balls) if isinstance(world, ParticleWorld) else ():
            world.registry.add(ball, AnchoredSpring(Vector3(1.3 * i, 0.5), 3.0, 0.2, 0.5))
        for _ in range(STEPS):
            world.step(0.5 * FRAME)
        return balls

    return run


def asleep_on_springs(rng: Random) -> Iterable[Particle]:
    """Let balls fall asleep on springs, and move an anchor, a ball or nothing at random."""
    balls = [Particle(Vector3(2.0 * i), mass=rng.uniform(0.5, 3.0)) for i in range(8)]
    world = SleepingWorld(balls, sleep_frames=5)
    springs = [AnchoredSpring(Vector3(2.0 * i, 1.0), rng.uniform(1.0, 9.0), 1.0) for i in range(8)]
    for ball, spring in zip(balls, springs, strict=True):
        world.registry.add(ball, spring)
    world.registry.add(balls[0], Spring(balls[1], 2.0, 2.0, 0.1))
    for _ in range(STEPS):
        world.start_frame()
        one = rng.randrange(8)
        match rng.randrange(20):
            case 0:
                springs[one].anchor += vector(rng, 0.1)
            case 1:
                springs[one].stiffness *= 2.0
            case 2:
                balls[one].position += vector(rng, 0.1)
            case 3:
                balls[one].velocity = vector(rng, 0.1)
            case 4:
                balls[one].add_force(vector(rng, 1.0))
            case 5:
                balls[one].add_force(Vector3())  # which wakes nothing
        world.run_physics(FRAME)
    assert 0 < len(world.asleep) < 8, "choose other numbers"
    return balls


def on_a_chain(rng: Random) -> Iterable[Particle]:
    """Let a chain of rods swing, with an immovable last particle in half of the worlds."""
    particles = [
        Particle(Vector3(0.3 * i, 0.0, rng.uniform(-0.1, 0.1)), acceleration=GRAVITY, damping=0.9)
        for i in range(1, 9)
    ]
    for particle in particles[:-1]:
        particle.mass = rng.uniform(0.5, 3.0)
    particles[-1].mass, particles[-1].velocity.y = rng.choice([2.0, float("inf")]), 0.5
    chain = DirectChain(particles, Vector3())
    for _ in range(STEPS):
        particles[2].add_force(vector(rng, 5.0))
        chain.step(0.25 * FRAME)
    return particles


WORLDS: dict[str, Callable[[Random], Iterable[Particle]]] = {
    "falling": falling,
    "explicit Euler": on_springs("explicit_euler"),
    "semi-implicit Euler": on_springs("semi_implicit_euler"),
    "leapfrog": on_springs("leapfrog"),
    "velocity Verlet": on_springs("velocity_verlet"),
    "Runge-Kutta": on_springs("runge_kutta_4"),
    "sleep on springs": asleep_on_springs,
    "contacts": in_contact(ParticleWorld),
    "contacts and sleep": in_contact(SleepingWorld),
    "chain": on_a_chain,
    "sequential impulses": in_contact(SequentialImpulses),
    "small steps": in_contact(SmallSteps),
}


def state(particle: Particle) -> list[float]:
    vectors = (particle.position, particle.velocity, particle.last_acceleration)
    return [number for vector in vectors for number in vector]


if __name__ == "__main__":
    found = {
        name: [state(particle) for particle in run(Random(f"{sys.argv[1]} {name}"))]
        for name, run in WORLDS.items()
    }
    print(json.dumps(found))
