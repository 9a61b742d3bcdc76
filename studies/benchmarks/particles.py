"""Measure how long one time step of a particle takes in our engine.

The time is compared with that of plain arithmetic, of vector operators and of pymunk.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable

from ch03_laws_of_motion.particle import Particle
from scenes.drag_flight import DAMPED_FALL, PROJECTILE, Numbers, make_particle, make_space
from scenes.timing import Measurement, Target, timer, versus
from studies.accuracy.in_pymunk import reading

FRAME = 1.0 / 60.0
STEPS = 10_000
ROUNDS = 51
# How the positions of pymunk's bodies are read after each step.
IN_TURN, AT_ONCE, NOT = " and read every position", " and read all in one call", " only"


def lines() -> list[Measurement]:
    """Set up the benchmarks that measure how long one time step of a particle takes.

    They compare Particle.integrate with plain arithmetic, with vector operators and with pymunk.
    """
    even = [FRAME] * STEPS
    uneven = [FRAME * random.uniform(0.8, 1.2) for _ in even]
    step = timer(lambda: steps(make_particle(PROJECTILE), even))
    uneven_step = timer(lambda: steps(make_particle(PROJECTILE), uneven))
    operators = timer(lambda: operator_steps(make_particle(PROJECTILE), even))
    in_place = timer(lambda: in_place_steps(make_particle(PROJECTILE), even))
    found = [
        Measurement(
            "Particle.integrate / the same arithmetic in local variables",
            versus(step, timer(lambda: arithmetic(even))),
            ROUNDS,
            Target("at most", 2.0 if sys.version_info >= (3, 13) else 1.4),
        ),
        Measurement(
            "Particle.integrate / the same arithmetic, with steps of random length",
            versus(uneven_step, timer(lambda: arithmetic(uneven))),
            ROUNDS,
        ),
        Measurement(
            "a step written with + and *, which make new vectors / Particle.integrate",
            versus(operators, step),
            ROUNDS,
            Target("at least", 5),
        ),
        Measurement(
            "a step written with add_scaled and *= / Particle.integrate",
            versus(in_place, step),
            ROUNDS,
        ),
    ]
    found += [_against_pymunk(bodies, IN_TURN) for bodies in (1, 10, 100, 1000)]
    found += [_against_pymunk(bodies, AT_ONCE) for bodies in (10, 100, 1000)]
    found += [_against_pymunk(bodies, NOT) for bodies in (1, 3, 10, 1000)]
    return found


def _against_pymunk(bodies: int, read: str) -> Measurement:
    """Set up a benchmark that compares pymunk and our engine on bodies that fall with damping.

    ``read`` says how the positions of pymunk's bodies are read after each step. Our engine stores
    positions as Python objects, so reading them is cheap. Pymunk has to get each position from its
    C library.
    """
    frames = max(1, 4000 // bodies)
    particles = [make_particle(DAMPED_FALL) for _ in range(bodies)]
    space, others = make_space(DAMPED_FALL, bodies)

    def ours() -> None:
        for _ in range(frames):
            for particle in particles:
                particle.integrate(FRAME)
            if read != NOT:
                for particle in particles:
                    position = particle.position
                    position.x, position.y  # noqa: B018 - reading them is the purpose

    def in_turn() -> None:
        for body in others:
            position = body.position
            position.x, position.y  # noqa: B018

    ways: dict[str, Callable[[], object]]
    ways = {IN_TURN: in_turn, AT_ONCE: reading(space, others), NOT: lambda: None}
    look = ways[read]

    def theirs() -> None:
        for _ in range(frames):
            space.step(FRAME)
            look()

    many = "1 body" if bodies == 1 else f"{bodies} bodies"
    what = f"step{read}"
    if read != IN_TURN and bodies > 1:
        what += " (below 1, pymunk is faster)"
    target = Target("at least", 2.0 if bodies >= 100 else 1.8) if read == IN_TURN else None
    figure = versus(timer(theirs), timer(ours))
    return Measurement(f"pymunk / Particle, {many}, {what}", figure, ROUNDS, target)


def steps(particle: Particle, frames: list[float]) -> None:
    for frame in frames:
        particle.integrate(frame)


def operator_steps(particle: Particle, frames: list[float]) -> None:
    """Move a particle with operators such as + and *, which create a new vector each time.

    The particle also checks and copies every vector that is assigned to it.
    """
    for frame in frames:
        particle.position = particle.position + particle.velocity * frame
        keep = particle.damping**frame
        particle.velocity = (particle.velocity + particle.acceleration * frame) * keep


def in_place_steps(particle: Particle, frames: list[float]) -> None:
    """Move a particle with methods such as add_scaled, which change a vector in place.

    ``frames`` lists the durations of the time steps in s.
    """
    position, velocity = particle.position, particle.velocity
    for frame in frames:
        position.add_scaled(velocity, frame)
        velocity.add_scaled(particle.acceleration, frame)
        velocity *= particle.damping**frame


def arithmetic(frames: list[float]) -> Numbers:
    """Do the same arithmetic as Particle.integrate, but with numbers in local variables.

    The time that this takes shows how fast a step could be without any objects. The extra time that
    Particle.integrate takes is the cost of its objects and calls. Return the final position.
    """
    x, y, z = PROJECTILE.start.position
    vx, vy, vz = PROJECTILE.start.velocity
    ax, ay, az = PROJECTILE.acceleration
    damping = PROJECTILE.damping
    for frame in frames:
        x += vx * frame
        y += vy * frame
        z += vz * frame
        keep = damping**frame
        vx = (vx + ax * frame) * keep
        vy = (vy + ay * frame) * keep
        vz = (vz + az * frame) * keep
    return x, y, z
