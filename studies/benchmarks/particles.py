"""Compare a time step of a particle with plain arithmetic, vector operators and pymunk."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable

from ch03_laws_of_motion.particle import Particle
from ch05_forces import particle as chapter_5
from scenes.clock import FRAME
from scenes.flight import DAMPED_FALL, PROJECTILE
from scenes.readings import Numbers
from scenes.setup import Setup
from scenes.timing import Measurement, Target, Timer, timer, versus
from scenes.twin import twin_of
from studies.accuracy.in_pymunk import reading

STEPS = 10_000
ROUNDS = 51
# How the positions of pymunk's bodies are read after each step.
IN_TURN, AT_ONCE, NOT = " and read every position", " and read all in one call", " only"


def lines() -> list[Measurement]:
    """Set up the benchmarks of a time step."""
    even = [FRAME] * STEPS
    uneven = [FRAME * random.uniform(0.8, 1.2) for _ in even]

    def moving(move: Callable[[Particle, list[float]], None], frames: list[float]) -> Timer:
        return timer(lambda: move(PROJECTILE.particle(Particle), frames))

    step = moving(steps, even)
    return [
        Measurement(
            "Particle.integrate / the same arithmetic in local variables",
            versus(step, timer(lambda: arithmetic(even))),
            ROUNDS,
            Target("at most", 2.0 if sys.version_info >= (3, 13) else 1.4),
        ),
        Measurement(
            "Particle.integrate / the same arithmetic, with steps of random length",
            versus(moving(steps, uneven), timer(lambda: arithmetic(uneven))),
            ROUNDS,
        ),
        Measurement(
            "a step written with + and *, which make new vectors / Particle.integrate",
            versus(moving(operator_steps, even), step),
            ROUNDS,
            Target("at least", 5),
        ),
        Measurement(
            "a step written with add_scaled and *= / Particle.integrate",
            versus(moving(in_place_steps, even), step),
            ROUNDS,
        ),
        *(_against_pymunk(bodies, IN_TURN) for bodies in (1, 10, 100, 1000)),
        *(_against_pymunk(bodies, AT_ONCE) for bodies in (10, 100, 1000)),
        *(_against_pymunk(bodies, NOT) for bodies in (1, 3, 10, 1000)),
    ]


def _against_pymunk(bodies: int, read: str) -> Measurement:
    """Set up a benchmark that compares pymunk and our engine on bodies that fall with damping.

    ``read`` says how the positions of pymunk's bodies are read after each step. Our positions are
    Python objects, but pymunk has to get each of its positions from its C library.
    """
    frames = max(1, 4000 // bodies)
    particles = [DAMPED_FALL.particle(Particle) for _ in range(bodies)]
    space, others = twin_of(
        Setup([DAMPED_FALL.particle(chapter_5.Particle) for _ in range(bodies)])
    )

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

    look: Callable[[], object] = in_turn
    if read != IN_TURN:
        look = reading(space, others) if read == AT_ONCE else lambda: None

    def theirs() -> None:
        for _ in range(frames):
            space.step(FRAME)
            look()

    what = f"{bodies} {'body' if bodies == 1 else 'bodies'}, step{read}"
    if read != IN_TURN and bodies > 1:
        what += " (below 1, pymunk is faster)"
    target = Target("at least", 2.0 if bodies >= 100 else 1.8) if read == IN_TURN else None
    figure = versus(timer(theirs), timer(ours))
    return Measurement(f"pymunk / Particle, {what}", figure, ROUNDS, target)


def steps(particle: Particle, frames: list[float]) -> None:
    for frame in frames:
        particle.integrate(frame)


def operator_steps(particle: Particle, frames: list[float]) -> None:
    """Move a particle with + and *, which create new vectors. The particle copies them again."""
    for frame in frames:
        particle.position = particle.position + particle.velocity * frame
        keep = particle.damping**frame
        particle.velocity = (particle.velocity + particle.acceleration * frame) * keep


def in_place_steps(particle: Particle, frames: list[float]) -> None:
    """Move a particle with methods such as add_scaled, which change a vector in place."""
    position, velocity = particle.position, particle.velocity
    for frame in frames:
        position.add_scaled(velocity, frame)
        velocity.add_scaled(particle.acceleration, frame)
        velocity *= particle.damping**frame


def arithmetic(frames: list[float]) -> Numbers:
    """Do the arithmetic of Particle.integrate without objects, and return the final position."""
    x, y, z = PROJECTILE.position
    vx, vy, vz = PROJECTILE.velocity
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
