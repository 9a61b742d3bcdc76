"""Define scenes with a body on a spring, in which our engine is compared with pymunk.

In four scenes, the body oscillates along a line, each time on a spring of a different stiffness. In
another scene, it swings as an elastic pendulum.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import backward_euler, semi_implicit_euler, trapezoidal
from ch06_springs.springs import AnchoredSpring, FakeStiffSpring
from studies.accuracy.in_plane import in_plane, on_all
from studies.accuracy.in_pymunk import (
    BEST,
    EXAMPLES,
    InSpace,
    Pair,
    by_pymunk,
    from_two_runs,
    lone,
    space_with,
)
from studies.accuracy.scene import (
    RATE,
    Made,
    Model,
    Outcome,
    Place,
    Scene,
    by_forces,
    by_formula,
    by_integrators,
    in_frames,
    solved,
)
from studies.models.exact_frames import oscillation_in_frames
from studies.runs.stability import Solver

FRAMES = 120


def spring(stiffness: float, damping: float) -> Scene:
    """Create the scene of a body of 1 kg that oscillates along a line on a damped spring.

    The body is released 1 m from the anchor of the spring, whose rest length is 0.
    """

    def place_at(time: float) -> Place:
        return damped_spring_state(1.0, 0.0, stiffness, damping, 1.0, time)[0], 0.0

    def truth(time: float) -> Place:
        """Compute the exact position of the body as the sum of two complex exponentials.

        The formula is not valid at critical damping, but no spring in these scenes is critically
        damped.
        """
        root = cmath.sqrt(0.25 * damping * damping - stiffness)
        a, b = -0.5 * damping + root, -0.5 * damping - root
        return ((b * cmath.exp(a * time) - a * cmath.exp(b * time)) / (b - a)).real, 0.0

    def in_equal_frames(_: int) -> Outcome:
        places = oscillation_in_frames(1.0, stiffness, damping, 1.0 / RATE, FRAMES)
        return Outcome([(x, 0.0) for x in places], FRAMES)

    def make() -> Made:
        return Particle(Vector3(1.0)), [AnchoredSpring(Vector3(), stiffness, 0.0, damping)]

    def make_fake() -> Made:
        return Particle(Vector3(1.0)), [FakeStiffSpring(Vector3(), stiffness, damping)]

    def acceleration(position: complex, velocity: complex) -> complex:
        return -stiffness * position - damping * velocity

    def ahead(duration: float) -> InSpace:
        stiffer = stiffness * math.exp(0.5 * damping * duration)
        start = (-0.5 * stiffness * duration, 0.0)
        return on_spring((1.0, 0.0), start, stiffer, damping)

    def as_in_examples(_: float) -> InSpace:
        return on_spring((1.0, 0.0), (0.0, 0.0), stiffness, damping)

    by_hand, *_ = lone((1.0, 0.0), (0.0, 0.0), acceleration, FRAMES)
    best = by_pymunk(BEST, ahead, FRAMES)
    models = [
        by_formula(place_at, FRAMES),
        Model("exact steps", in_equal_frames, (1,), is_formula=True),
        *by_integrators(make, FRAMES),
        *in_plane([1.0], [0.0], on_all(acceleration), FRAMES, is_damped=True),
        Model("backward Euler", partial(by_solver, backward_euler, stiffness, damping)),
        Model("trapezoidal rule", partial(by_solver, trapezoidal, stiffness, damping)),
        Model(
            "faked stiff spring",
            by_forces(make_fake, semi_implicit_euler, FRAMES),
            is_formula=True,
        ),
        by_pymunk(EXAMPLES, as_in_examples, FRAMES),
        by_hand,
        best,
        from_two_runs(best),
    ]
    name = f"spring, k = {stiffness:g} N/m, c = {damping:.3g} N s/m"
    return Scene(name, FRAMES, 1.0, truth, models)


def elastic_pendulum() -> Scene:
    """Create the scene of an elastic pendulum: a body of 1 kg that swings on a spring for 2 s.

    The spring is undamped, and has a stiffness of 200 N/m and a rest length of 1 m. The body starts
    1.2 m to the side of the anchor, moving upward at 1.5 m/s. Its motion has no closed form, so
    SciPy computes it.
    """
    stiffness, rest, gravity = 200.0, 1.0, 9.81
    place, velocity = (1.2, 0.0), (0.0, 1.5)

    def acceleration(position: complex, _: complex) -> complex:
        return -stiffness * (1.0 - rest / abs(position)) * position - 1j * gravity

    def rates(_: float, state: Sequence[float]) -> list[float]:
        x, y, vx, vy = state
        length = math.hypot(x, y)
        tension = stiffness * (length - rest)
        return [vx, vy, -tension * x / length, -tension * y / length - gravity]

    def make() -> Made:
        body = Particle(Vector3(*place), Vector3(*velocity), Vector3(0.0, -gravity))
        return body, [AnchoredSpring(Vector3(), stiffness, rest)]

    def in_space(duration: float) -> InSpace:
        first = acceleration(complex(*place), 0j) * 0.5 * duration
        start = (velocity[0] + first.real, velocity[1] + first.imag)
        space, bodies = on_spring(place, start, stiffness, 0.0, rest)
        space.gravity = (0.0, -gravity)
        return space, bodies

    by_hand, *_ = lone(place, velocity, acceleration, FRAMES)
    best = by_pymunk(BEST, in_space, FRAMES)
    models = [
        *by_integrators(make, FRAMES),
        *in_plane(
            [complex(*place)], [complex(*velocity)], on_all(acceleration), FRAMES, is_damped=False
        ),
        by_pymunk(EXAMPLES, lambda _: in_space(0.0), FRAMES),
        by_hand,
        best,
        from_two_runs(best),
    ]
    truth = solved(rates, [*place, *velocity], lambda state: (state[0], state[1]), FRAMES)
    return Scene("elastic pendulum", FRAMES, rest, truth, models)


def on_spring(
    position: Pair, velocity: Pair, stiffness: float, damping: float, rest: float = 0.0
) -> InSpace:
    """Create a pymunk space with a body of 1 kg on a spring that is anchored at the origin."""
    import pymunk  # here, because a chapter's plots do not need it

    space, (body,) = space_with(position, velocity)
    still = space.static_body
    space.add(pymunk.DampedSpring(body, still, (0, 0), (0, 0), rest, stiffness, damping))
    return space, [body]


def by_solver(solver: Solver, stiffness: float, damping: float, steps: int) -> Outcome:
    """Simulate a body on a spring with a solver for linear springs, such as backward Euler.

    The work is the number of steps, because each step counts as one evaluation.
    """
    x, v = 1.0, 0.0

    def step(duration: float) -> None:
        nonlocal x, v
        x, v = solver(x, v, stiffness, damping, 1.0, duration)

    return Outcome(in_frames(step, lambda: (x, 0.0), FRAMES, steps), FRAMES * steps)


# Every spring has a tenth of critical damping, c = 0.2 sqrt(k), except for one with a hundredth.
SPRINGS: list[Callable[[], Scene]] = [
    *(partial(spring, k, 0.2 * math.sqrt(k)) for k in (10.0, 100.0, 1e4)),
    partial(spring, 1e6, 20.0),
    partial(spring, 1e6, 200.0),
    elastic_pendulum,
]
