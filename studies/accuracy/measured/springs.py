"""Measure a body on a spring, along a line or as an elastic pendulum, beside pymunk."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import FakeStiffSpring
from scenes import elastic_pendulum as elastic
from scenes.clock import RATE
from scenes.integrators import SOLVERS, Solver
from scenes.setup import Setup, alone
from scenes.spring_on_a_wall import START, SpringOnAWall
from scenes.twin import InSpace, twin_of
from studies.accuracy.in_plane import in_plane, on_all, stepped
from studies.accuracy.in_pymunk import BEST, EXAMPLES, by_pymunk, from_two_runs, lone
from studies.accuracy.scene import (
    Made,
    Model,
    Place,
    Scene,
    by_formula,
    by_integrators,
    by_setup,
    by_steps,
    exact_steps,
    solved,
)
from studies.models.exact_frames import oscillation_in_frames

FRAMES = 120


def spring(stiffness: float, damping: float) -> Scene:
    """Create the scene of a body of 1 kg that oscillates along a line on a damped spring."""
    wall = SpringOnAWall(stiffness, damping)

    def truth(time: float) -> Place:
        """Compute the exact position as the sum of two exponentials, without critical damping."""
        root = cmath.sqrt(0.25 * damping * damping - stiffness)
        a, b = -0.5 * damping + root, -0.5 * damping - root
        return ((b * cmath.exp(a * time) - a * cmath.exp(b * time)) / (b - a)).real, 0.0

    def in_equal_frames() -> list[Place]:
        places = oscillation_in_frames(START, stiffness, damping, 1.0 / RATE, FRAMES)
        return [(x, 0.0) for x in places]

    def faked() -> Setup:
        fake = FakeStiffSpring(Vector3(), stiffness, damping)
        return alone(Particle(Vector3(START)), fake)

    def acceleration(position: complex, velocity: complex) -> complex:
        return -stiffness * position - damping * velocity

    def ahead(duration: float) -> InSpace:
        stiffer = stiffness * math.exp(0.5 * damping * duration)
        space, (body,) = twin_of(SpringOnAWall(stiffer, damping).setup(), iterations=1)
        body.velocity = -0.5 * stiffness * duration, 0.0
        return space, [body]

    by_hand, *_ = lone(wall.setup, acceleration, FRAMES)
    best = by_pymunk(BEST, ahead, FRAMES)
    models = [
        by_formula(lambda time: (wall.state(time)[0], 0.0), FRAMES),
        exact_steps(in_equal_frames),
        *by_integrators(wall.setup, FRAMES),
        *in_plane([START], [0.0], on_all(acceleration), FRAMES, is_damped=True),
        *(by_steps(name, partial(solving, way, wall), FRAMES) for name, way in SOLVERS.items()),
        Model("faked stiff spring", by_setup(faked, semi_implicit_euler, FRAMES), is_formula=True),
        by_pymunk(EXAMPLES, lambda _: twin_of(wall.setup(), iterations=1), FRAMES),
        by_hand,
        best,
        from_two_runs(best),
    ]
    name = f"spring, k = {stiffness:g} N/m, c = {damping:.3g} N s/m"
    return Scene(name, FRAMES, START, truth, models)


def elastic_pendulum() -> Scene:
    """Create the scene of an elastic pendulum that swings for 2 s, as SciPy computes it."""
    by_hand, *_ = lone(elastic.setup, elastic.acceleration, FRAMES)
    best = by_pymunk(BEST, lambda h: twin_of(elastic.setup(), ahead=h, iterations=1), FRAMES)
    models = [
        *stepped(elastic.setup, elastic.acceleration, FRAMES, is_damped=False),
        by_pymunk(EXAMPLES, lambda _: twin_of(elastic.setup(), iterations=1), FRAMES),
        by_hand,
        best,
        from_two_runs(best),
    ]
    start = [*elastic.PLACE, *elastic.VELOCITY]
    truth = solved(elastic.rates, start, lambda state: (state[0], state[1]), FRAMES)
    return Scene("elastic pendulum", FRAMES, elastic.LENGTH, truth, models)


def solving(solver: Solver, wall: SpringOnAWall, _: float) -> Made:
    """Return what simulates a body on a spring with a solver."""
    x, v = START, 0.0

    def step(duration: float) -> None:
        nonlocal x, v
        x, v = solver(x, v, wall.stiffness, wall.damping, wall.mass, duration)

    return step, lambda: (x, 0.0)


# Every spring has a tenth of critical damping, c = 0.2 sqrt(k), except for one with a hundredth.
SPRINGS: list[Callable[[], Scene]] = [
    *(partial(spring, k, 0.2 * math.sqrt(k)) for k in (10.0, 100.0, 1e4)),
    partial(spring, 1e6, 20.0),
    partial(spring, 1e6, 200.0),
    elastic_pendulum,
]
