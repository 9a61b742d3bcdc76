"""Compare how long our engine and pymunk take to simulate a scene with the same accuracy.

A model is one way to simulate a scene, for example with a certain integrator. Each result is the
time of one of pymunk's models divided by the time of one of ours. The error of the positions must
not exceed a given fraction of the scene's size in any frame. To find the fewest steps per frame
that achieve this, each model is run with 1, 2, 4 and more steps.

If pymunk does not achieve this with up to MOST steps per run, its time is extrapolated from its
order of convergence. The report then says so. If pymunk's error does not fall steadily, the result
is only a lower bound.

The last two benchmarks compare the ``adaptive`` integrator with fixed steps on an orbit.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Sequence
from functools import partial

from scenes.timing import Measurement, Target, versus
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.measure import Point, run, seconds_of
from studies.accuracy.results import order_of
from studies.accuracy.scene import Model, Outcome, Scene

TOLERANCE = 1e-4
RK4 = "Runge-Kutta 4"
BY_ANGLE, BY_ANGLES = f"by its angle, {RK4}", f"by its two angles, {RK4}"
MOST = 2_000_000  # steps per run, which take pymunk a few seconds


def lines() -> list[Measurement]:
    """Set up the benchmarks that compare our engine with pymunk at the same accuracy.

    The scenes include a spring, an orbit and a double pendulum. The first three use pymunk as its
    examples do, and the others use it at its best.
    """
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
    ]


def lines_of_adaptive() -> list[Measurement]:
    """Set up two benchmarks that compare Runge-Kutta 4 with `adaptive` on a comet's orbit.

    One compares the number of force evaluations, and the other compares the times. The error must
    be at most 1e-6 of the semi-major axis in every frame. Runge-Kutta 4 uses the fewest steps per
    frame that achieve this. The integrator `adaptive` uses the loosest tolerance that does, chosen
    from four per power of ten.
    """
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


def coarsest(
    scene: Scene, model: Model, choices: Sequence[int], tolerance: float
) -> tuple[int, Outcome]:
    """Find by bisection the coarsest setting with which a model meets ``tolerance``.

    ``choices`` lists the settings from the coarsest to the finest, such as 1 to 512 steps per
    frame. Return the setting and the result of its run.
    """

    def is_within(choice: int) -> bool:
        outcome = run(model, choice)
        return outcome is not None and scene.error(outcome) <= tolerance

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

    ``part`` is part of the scene's name. ``ours`` and ``theirs`` name the two models to compare,
    such as "leapfrog". If ``ours`` is None, our fastest exact model is used.
    """
    (scene,) = scenes_with(part)
    mine = model_of(scene, ours) if ours else fastest_exact(scene)
    other = model_of(scene, theirs)
    steps, error = fewest_steps(scene, mine, tolerance)
    tried = tried_steps(scene, other, tolerance)
    finest = tried[-1]
    sides = f"{told(other, finest.steps, finest.error)} / {told(mine, steps, error)}"
    what = f"{scene.name}: {sides}"
    figure = versus(partial(seconds_of, other, finest.steps), partial(seconds_of, mine, steps))
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
    """Find one of the models of ``scene`` by its name, such as "leapfrog".

    A model is one way to simulate the scene.
    """
    return next(model for model in scene.models if model.name == name)


def fastest_exact(scene: Scene) -> Model:
    """Find the fastest of our exact models of a scene.

    An exact model, such as a closed form, always runs with one step per frame.
    """
    exact = [model for model in scene.models if model.by == "ours" and is_exact(model)]
    return min(exact, key=lambda model: seconds_of(model, 1))


def is_exact(model: Model) -> bool:
    """Return True if a model is exact, such as a closed form.

    More steps per frame would not change the result, so the model's ``steps`` attribute is (1,).
    """
    return tuple(model.steps) == (1,)


def fewest_steps(scene: Scene, model: Model, tolerance: float) -> tuple[int, float]:
    """Find the fewest steps of a model with which it meets ``tolerance``.

    Return the number of steps and the error. If the model needs more than MOST steps per run,
    return the largest number of steps per frame that was tried, and its error.
    """
    finest = tried_steps(scene, model, tolerance)[-1]
    return finest.steps, finest.error


def tried_steps(scene: Scene, model: Model, tolerance: float) -> list[Point]:
    """Run a model with more and more steps per frame until its error is small enough.

    This ends when a run meets ``tolerance``, or when the next run would take more than MOST steps.
    Return one point per run, with its error and its work.
    """
    tried: list[Point] = []
    for steps in model.steps:
        outcome = run(model, steps)
        error, work = (scene.error(outcome), outcome.work) if outcome else (math.inf, 0)
        tried.append(Point(scene.name, model.name, model.by, steps, error, work))
        if error <= tolerance or 2 * steps * scene.frames > MOST:
            break
    return tried


def told(model: Model, steps: int, error: float) -> str:
    """Describe a model and its accuracy, as in "leapfrog (8 steps per frame, error 3e-05)"."""
    return f"{model.name} ({model.chosen(steps)}, error {error:.1g})"
