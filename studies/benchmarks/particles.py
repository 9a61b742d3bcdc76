"""The step of a particle against its own arithmetic, against operators and against pymunk."""

from __future__ import annotations

import random
import timeit
from typing import Any

import pymunk

from ch03_laws_of_motion.particle import Particle
from studies.scenes import DAMPED_FALL, PROJECTILE, Numbers, make_particle
from studies.timing import Line, Timer, ratio

FRAME = 1.0 / 60.0
STEPS = 10_000
ROUNDS = 51
BODIES = (1, 10, 100, 1000)


def lines() -> list[Line]:
    """Return every line about particles."""
    step = _timer(lambda: steps(make_particle(PROJECTILE), [FRAME] * STEPS))
    uneven = [FRAME * random.uniform(0.8, 1.2) for _ in range(STEPS)]
    measured = [
        Line(
            "Particle.integrate / its own arithmetic in local variables",
            *ratio(step, _timer(arithmetic), ROUNDS, "arithmetic"),
            "at most 1.6 on 3.11, 2.0 on 3.13",
        ),
        Line(
            "the step with vector operators / Particle.integrate",
            *ratio(
                _timer(lambda: operator_steps(make_particle(PROJECTILE))),
                step,
                ROUNDS,
                "operators",
            ),
            "at least 5",
        ),
        Line(
            "Particle.integrate in frames of random length / in equal frames",
            *ratio(
                _timer(lambda: steps(make_particle(PROJECTILE), uneven)), step, ROUNDS, "frames"
            ),
            "",
        ),
    ]
    for bodies in BODIES:
        measured.append(_against_pymunk(bodies, read=True))
    measured += [_against_pymunk(bodies, read=False) for bodies in (BODIES[0], BODIES[-1])]
    return measured


def _against_pymunk(bodies: int, *, read: bool) -> Line:
    """Time as many damped falls in both engines, with every position read after each step or not.

    Our positions lie in Python already; pymunk's are fetched one by one from its library in C.
    """
    frames = max(1, 4000 // bodies)
    particles = [make_particle(DAMPED_FALL) for _ in range(bodies)]
    space, others = _pymunk_space(bodies)

    def ours() -> None:
        for _ in range(frames):
            for particle in particles:
                particle.integrate(FRAME)
            if read:
                [particle.position for particle in particles]

    def theirs() -> None:
        for _ in range(frames):
            space.step(FRAME)
            if read:
                [body.position for body in others]

    many = "1 body" if bodies == 1 else f"{bodies} bodies"
    what = "step and read every position" if read else "step only"
    measured = ratio(_timer(theirs), _timer(ours), ROUNDS, f"pymunk, {many}")
    target = "at least 1.8" if read else "below 1: pymunk wins" if bodies > 1 else ""
    return Line(f"pymunk / Particle, {many}, {what}", *measured, target)


def _pymunk_space(bodies: int) -> tuple[pymunk.Space, list[pymunk.Body]]:
    space = pymunk.Space()
    space.gravity, space.damping = DAMPED_FALL.acceleration[:2], DAMPED_FALL.damping
    made = [pymunk.Body(mass=1.0, moment=1.0) for _ in range(bodies)]
    space.add(*made)
    return space, made


def steps(particle: Particle, frames: list[float]) -> None:
    for frame in frames:
        particle.integrate(frame)


def operator_steps(particle: Particle) -> None:
    """Step by the same equations, with the operators of Vector3."""
    for frame in [FRAME] * STEPS:
        particle.position = particle.position + particle.velocity * frame
        keep = particle.damping**frame
        particle.velocity = (particle.velocity + particle.acceleration * frame) * keep


def arithmetic() -> Numbers:
    """Step by the same equations in local variables, and return the position at the end.

    This is what a step costs without any objects.
    """
    x, y, z = PROJECTILE.start.position
    vx, vy, vz = PROJECTILE.start.velocity
    ax, ay, az = PROJECTILE.acceleration
    damping = PROJECTILE.damping
    for frame in [FRAME] * STEPS:
        x += vx * frame
        y += vy * frame
        z += vz * frame
        keep = damping**frame
        vx = (vx + ax * frame) * keep
        vy = (vy + ay * frame) * keep
        vz = (vz + az * frame) * keep
    return x, y, z


def _timer(run: Any) -> Timer:
    return lambda: timeit.timeit(run, number=1)
