"""Compare how long our engine and pymunk take to simulate a scene with the same accuracy.

Each model makes the fewest steps per frame with which it meets a tolerance. If pymunk does not meet
it in MOST steps, its time is extrapolated with its order, or the ratio is a lower bound.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Sequence
from functools import partial

from scenes.clock import FRAME
from scenes.timing import Measurement, Target, timer, versus
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.measure import Point, point_of, run, seconds_of
from studies.accuracy.measured.chains import G
from studies.accuracy.results import order_of
from studies.accuracy.scene import Model, Outcome, Scene
from studies.models.order_8 import Accelerations
from studies.models.plane_rods import accelerations_on_rods

TOLERANCE = 1e-4
RK4 = "Runge-Kutta 4"
BY_ANGLE, BY_ANGLES = f"by its angle, {RK4}", f"by its two angles, {RK4}"
MOST = 2_000_000  # steps per run, which take pymunk a few seconds


def lines() -> list[Measurement]:
    """Set up the comparisons with pymunk: first as its examples use it, and then at its best."""
    usual = [
        line("spring, k = 100 N/m", RK4, EXAMPLES, 15, Target("at least", 250)),
        line("elastic pendulum", RK4, EXAMPLES, 7, Target("at least", 30)),
        line("double pendulum", BY_ANGLES, EXAMPLES, 7, Target("at least", 30)),
    ]
    steps = ("leapfrog", "multistep, order 4", "multistep, order 6")
    best = [
        line(part, name, model, 15, Target("at least", bound), tolerance)
        for part, ours, theirs, bounds in (
            ("spring, k = 100 N/m", ("trapezoidal rule", *steps[1:]), BEST, (0.8, 2, 15)),
            ("elastic pendulum", steps, BEST, (0.8, 2, 15)),
            ("orbit of eccentricity 0.5", steps, BEST, (0.8, 2, 15)),
            ("double pendulum", ("direct chain", *steps[1:]), at_best(10), (0.8, 2, 15)),
            ("projectile with linear drag", [None] * 3, BEST, (3, 30, 300)),
            ("spring, k = 100 N/m", [None] * 3, BEST, (3, 30, 300)),
            ("from horizontal", [BY_ANGLE] * 3, at_best(1), (3, 30, 300)),
        )
        for name, model, tolerance, bound in zip(
            ours,
            (theirs, *[f"{theirs}, from two runs"] * 2),
            (1e-2, 1e-4, 1e-6),
            bounds,
            strict=True,
        )
    ]
    return [
        *usual,
        *best,
        line("bouncing ball, restitution 0.8", None, BEST, 15, Target("at least", 30)),
        *lines_of_adaptive(),
        *lines_of_arithmetic(),
    ]


def lines_of_adaptive() -> list[Measurement]:
    """Compare Runge-Kutta 4 with `adaptive` on a comet's orbit, at an error of at most 1e-6."""
    (scene,) = scenes_with("orbit of eccentricity 0.9")
    fixed, own = model_of(scene, RK4), model_of(scene, "adaptive")
    steps, fixed_run = coarsest(scene, fixed, range(1, 513), 1e-6)
    finer, own_run = coarsest(scene, own, [round(10.0 ** (n / 4.0)) for n in range(4, 49)], 1e-6)
    what = (
        f"{scene.name}, error at most 1e-6: %s of {RK4} with {steps} steps per frame / "
        f"of adaptive with tolerance {1.0 / finer:.2g}"
    )
    ratio = fixed_run.work / own_run.work
    counts = f"evaluations ({fixed_run.work:,} / {own_run.work:,})"
    time = versus(partial(seconds_of, fixed, steps), partial(seconds_of, own, finer))
    return [
        Measurement(what % counts, lambda: ratio, 1, Target("at least", 10)),
        Measurement(what % "time", time, 9),
    ]


def lines_of_arithmetic() -> list[Measurement]:
    """Divide pymunk's time by that of bare arithmetic, in the scenes where we miss our goals.

    It evaluates the forces once per frame. A method that does the same stays below this ratio.
    """
    double = accelerations_on_rods([1.0, 1.0], [1.0, 1.0], G)
    five = accelerations_on_rods([1.0, 1.0, 1.0, 1.0, 10.0], [1.0] * 5, G)
    found = []
    for part, theirs, work in (
        ("double pendulum", at_best(2), evaluating(double, 2)),
        ("five rods, heavy tip", at_best(35), evaluating(five, 5)),
        ("spring, k = 10 N/m", BEST, evaluating(lambda x, v: [-10.0 * x[0] - 0.632 * v[0]], 1)),
        ("projectile with linear drag", BEST, falling),
    ):
        (scene,) = scenes_with(part)
        model = model_of(scene, theirs)
        finest = tried_steps(scene, model, TOLERANCE)[-1]
        what = f"{scene.name}: {told(model, finest)} / the bare arithmetic of its frames"
        pymunk, bare = partial(seconds_of, model, finest.steps), partial(work, scene.frames)
        found.append(Measurement(what, versus(pymunk, timer(bare)), 15))
    return found


def coarsest(
    scene: Scene, model: Model, choices: Sequence[int], tolerance: float
) -> tuple[int, Outcome]:
    """Find the first of ever finer settings with which a model meets ``tolerance``, and its run."""

    def is_within(choice: int) -> bool:
        return point_of(scene, model, choice, run(model, choice)).error <= tolerance

    choice = choices[bisect_left(choices, True, key=is_within)]
    return choice, model.run(choice)


def line(
    part: str,
    ours: str | None,
    theirs: str,
    rounds: int,
    target: Target | None = None,
    tolerance: float = TOLERANCE,
) -> Measurement:
    """Set up a benchmark that divides pymunk's time by ours in one scene, at the same accuracy.

    ``part`` is part of the scene's name. If ``ours`` is None, it is our fastest exact model.
    """
    (scene,) = scenes_with(part)
    mine = model_of(scene, ours) if ours else fastest_exact(scene)
    other = model_of(scene, theirs)
    least, tried = tried_steps(scene, mine, tolerance)[-1], tried_steps(scene, other, tolerance)
    finest = tried[-1]
    what = f"{scene.name}: {told(other, finest)} / {told(mine, least)}"
    figure = versus(
        partial(seconds_of, other, finest.steps), partial(seconds_of, mine, least.steps)
    )
    if finest.error <= tolerance:
        return Measurement(what, figure, rounds, target)
    order = order_of(tried)
    if order is None:
        what += f"; a lower bound, because pymunk does not reach {tolerance:g}"
        return Measurement(what, figure, rounds, target)
    more = math.pow(finest.error / tolerance, 1.0 / order)
    what += f"; pymunk's time is extrapolated to {tolerance:g} with its order of {order:.2f}"
    return Measurement(what, lambda: more * figure(), rounds, target)


def model_of(scene: Scene, name: str) -> Model:
    """Find one of the models of a scene by its name, such as "leapfrog"."""
    return next(model for model in scene.models if model.name == name)


def fastest_exact(scene: Scene) -> Model:
    """Find the fastest of our exact models, such as a closed form, which need no smaller steps."""
    exact = [model for model in scene.models if model.by == "ours" and tuple(model.steps) == (1,)]
    return min(exact, key=lambda model: seconds_of(model, 1))


def tried_steps(scene: Scene, model: Model, tolerance: float) -> list[Point]:
    """Run a model in ever more steps, until it meets ``tolerance`` or would exceed MOST."""
    tried: list[Point] = []
    for steps in model.steps:
        tried.append(point_of(scene, model, steps, run(model, steps)))
        if tried[-1].error <= tolerance or 2 * steps * scene.frames > MOST:
            break
    return tried


def told(model: Model, point: Point) -> str:
    """Describe a model and its accuracy, as in "leapfrog (8 steps per frame, error 3e-05)"."""
    return f"{model.name} ({model.chosen(point.steps)}, error {point.error:.1g})"


def evaluating(accelerations: Accelerations, count: int) -> Callable[[int], object]:
    """Return a function that evaluates the forces once per frame, for ``count`` bodies on rods."""
    positions = [complex(0.6 * i, -0.8 * i) for i in range(1, count + 1)]
    velocities = [complex(0.1 * i, 0.2) for i in range(1, count + 1)]

    def work(frames: int) -> None:
        for _ in range(frames):
            accelerations(positions, velocities)

    return work


def falling(frames: int) -> None:
    """Move a body with two additions and two products per frame, and keep its positions."""
    z, w, places, h = 0j, 20.0 + 20.0j, [], FRAME
    for _ in range(frames):
        z += w * h
        w = w * 0.99 - 0.16j
        places.append((z.real, z.imag))
