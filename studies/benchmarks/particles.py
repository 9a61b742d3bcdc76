"""Compare steps of a particle with arithmetic, pymunk and, for many sparks, a closed form."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from functools import partial
from typing import Any

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import burst_positions, state_after
from ch04_particle_engine.fireworks import GRAVITY, FireworkRule, FireworksShow
from ch05_forces import particle as chapter_5
from ch05_forces.forces import Gravity
from scenes.clock import FRAME
from scenes.flight import DAMPED_FALL, PROJECTILE
from scenes.setup import Setup, alone
from scenes.timing import Measurement, Target, Timer, timer, versus
from scenes.twin import twin_of
from studies.accuracy.in_pymunk import reading
from studies.models.plain_numbers import flight_in_numbers, pushed_in_numbers

STEPS = 10_000
ROUNDS = 51
PUSHED = PROJECTILE, (1.0, 2.0, 3.0)  # with the force in N
# How the positions of pymunk's bodies are read after each step.
IN_TURN, AT_ONCE, NOT = " and read every position", " and read all in one call", " only"
OURS, BARE = "Particle.integrate", "the same arithmetic"

SPARKS = 1000
SECONDS = 2.0
START = (0.0, 1e6, 0.0)  # so high that no spark lands while it is timed
DAMPING = 0.5
SPARK_ROUNDS = 31

# The sparks burn for longer than they are timed, so that only the steps are measured.
RULE = FireworkRule(1, 1e6, 1e6, (-5.0, -5.0, -5.0), (5.0, 5.0, 5.0), DAMPING)


def lines() -> list[Measurement]:
    """Set up the benchmarks of a time step, and of what it costs to apply forces."""
    even = [FRAME] * STEPS
    uneven = [FRAME * random.uniform(0.8, 1.2) for _ in even]

    def moving(
        move: Callable[[Any, list[float]], None], kind: type[Particle] = chapter_5.Particle
    ) -> Timer:
        return timer(lambda: move(PROJECTILE.particle(kind), even))

    step, free = moving(steps, Particle), moving(steps)
    in_place = moving(in_place_steps, Particle)
    randomly = timer(lambda: steps(PROJECTILE.particle(Particle), uneven))
    bare = timer(partial(flight_in_numbers, PROJECTILE, even))
    bare_randomly = timer(partial(flight_in_numbers, PROJECTILE, uneven))
    forced, bare_forced = moving(forced_steps), timer(partial(pushed_in_numbers, *PUSHED, even))
    generated, constant = "gravity as a force generator in the registry", "as constant acceleration"
    operators = "a step written with + and *, which make new vectors"
    little = Target("at most", 2.0 if sys.version_info >= (3, 13) else 1.4)
    nothing, twice, much = Target("at most", 1.1), Target("at most", 2.1), Target("at least", 5)
    return [
        _ratio(f"{OURS} / {BARE} in local variables", step, bare, little),
        _ratio(f"{OURS} / {BARE}, with steps of random length", randomly, bare_randomly),
        _ratio(f"{operators} / {OURS}", moving(operator_steps, Particle), step, much),
        _ratio(f"a step written with add_scaled and *= / {OURS}", in_place, step),
        *(_against_pymunk(bodies, IN_TURN) for bodies in (1, 10, 100, 1000)),
        *(_against_pymunk(bodies, AT_ONCE) for bodies in (10, 100, 1000)),
        *(_against_pymunk(bodies, NOT) for bodies in (1, 3, 10, 1000)),
        _ratio(f"{OURS} of chapter 5 without forces / that of chapter 3", free, step, nothing),
        _ratio(f"add_force and {OURS} / {BARE} in local variables", forced, bare_forced, twice),
        _ratio(f"{generated} / {constant}", moving(generator_steps), free),
    ]


def _ratio(what: str, first: Timer, second: Timer, target: Target | None = None) -> Measurement:
    return Measurement(what, versus(first, second), ROUNDS, target)


def _against_pymunk(bodies: int, read: str) -> Measurement:
    """Compare falling bodies. Pymunk gets each position that is read from its C library."""
    frames = max(1, 4000 // bodies)
    particles = [DAMPED_FALL.particle(Particle) for _ in range(bodies)]
    twins = [DAMPED_FALL.particle(chapter_5.Particle) for _ in range(bodies)]
    space, others = twin_of(Setup(twins))

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
    return _ratio(f"pymunk / Particle, {what}", timer(theirs), timer(ours), target)


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


def forced_steps(particle: chapter_5.Particle, frames: list[float]) -> None:
    """Move a particle on which a constant force acts."""
    force = Vector3(*PUSHED[1])
    for frame in frames:
        particle.add_force(force)
        particle.integrate(frame)


def generator_steps(particle: chapter_5.Particle, frames: list[float]) -> None:
    """Move a particle with gravity as a force generator."""
    registry = alone(particle, Gravity(particle.acceleration)).registry()
    particle.acceleration = Vector3()
    for frame in frames:
        registry.update_forces(frame)
        particle.integrate(frame)


def lines_of_sparks() -> list[Measurement]:
    """Set up the benchmarks that compare time steps with a closed form for computing sparks."""
    show = burst()
    speeds, one = speeds_of(show), show.fireworks[0].particle
    frames = round(SECONDS / FRAME)

    def against_formula(what: str, frames: int, axes: str, target: int | None) -> Measurement:
        stepping = timer(lambda: step(show, frames, axes))
        closed = timer(lambda: positions(speeds, SECONDS, axes))
        bound = Target("at least", target) if target else None
        return Measurement(f"{what} / closed form", versus(stepping, closed), SPARK_ROUNDS, bound)

    one_frame, read = f"one frame of {SPARKS:,} sparks in", "stepping and reading"
    after = f"{SPARKS:,} sparks after {SECONDS:g} s, in x, y and z: {frames} steps"
    return [
        against_formula(f"{one_frame} x and y: {read}", 1, "xy", 4),
        against_formula(f"{one_frame} x, y and z: {read}", 1, "xyz", None),
        against_formula(after, frames, "xyz", 250),
        Measurement(
            f"one particle after {SECONDS:g} s: {frames} steps / state_after",
            versus(
                timer(lambda: steps(one, [FRAME] * frames), 20),
                timer(lambda: state_after(one, SECONDS), 20),
            ),
            SPARK_ROUNDS,
        ),
    ]


def burst() -> FireworksShow:
    """Create a fireworks show whose sparks have just been lit."""
    show = FireworksShow([RULE], SPARKS, seed=1)
    show.light([(1, SPARKS, Particle(Vector3(*START)))])
    return show


def speeds_of(show: FireworksShow) -> list[list[float]]:
    """List the velocities of all sparks as three lists, one each for x, y and z."""
    velocities = [firework.particle.velocity for firework in show.fireworks]
    return [[v.x for v in velocities], [v.y for v in velocities], [v.z for v in velocities]]


def step(show: FireworksShow, frames: int, axes: str) -> list[list[float]]:
    """Advance a fireworks show, and return a list of coordinates for each axis, "xy" or "xyz"."""
    for _ in range(frames):
        show.update(FRAME)
    places = [firework.particle.position for firework in show.fireworks]
    read = [[p.x for p in places], [p.y for p in places]]
    return [*read, [p.z for p in places]] if axes == "xyz" else read


def positions(speeds: list[list[float]], time: float, axes: str) -> list[list[float]]:
    """Return the same lists at ``time`` with a closed form, from the velocities at the start."""
    return [
        burst_positions(START[axis], speeds[axis], GRAVITY[axis], DAMPING, time)
        for axis in range(len(axes))
    ]
