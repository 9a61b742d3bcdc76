"""Measure what bare arithmetic costs in the scenes where we miss our goals.

Each line divides pymunk's time by that of one evaluation of the forces per frame, and nothing else.
A method with one evaluation per frame stays below this ratio, however good it is. Only a method
with fewer evaluations than frames can exceed it. For the projectile, the arithmetic is that of the
velocity and the position.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from scenes.clock import RATE
from scenes.timing import Measurement, timer, versus
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, at_best
from studies.accuracy.measure import seconds_of
from studies.accuracy.scenes.chains import G
from studies.benchmarks.accuracy import fewest_steps, model_of, told
from studies.models.order_8 import Accelerations
from studies.models.plane_rods import accelerations_on_rods

TOLERANCE = 1e-4


def lines() -> list[Measurement]:
    """Set up the measurements for chains of rods, a spring and a body that only falls."""
    double = accelerations_on_rods([1.0, 1.0], [1.0, 1.0], G)
    five = accelerations_on_rods([1.0, 1.0, 1.0, 1.0, 10.0], [1.0] * 5, G)
    stiffness, damping = 10.0, 0.632
    return [
        line(part, theirs, work)
        for part, theirs, work in (
            ("double pendulum", at_best(2), evaluating(double, 2)),
            ("five rods, heavy tip", at_best(35), evaluating(five, 5)),
            (
                "spring, k = 10 N/m",
                BEST,
                evaluating(lambda x, v: [-stiffness * x[0] - damping * v[0]], 1),
            ),
            ("projectile with linear drag", BEST, falling),
        )
    ]


def line(part: str, theirs: str, work: Callable[[int], object]) -> Measurement:
    """Divide pymunk's time by the time of bare arithmetic in as many frames."""
    (scene,) = scenes_with(part)
    model = model_of(scene, theirs)
    steps, error = fewest_steps(scene, model, TOLERANCE)
    what = f"{scene.name}: {told(model, steps, error)} / the bare arithmetic of its frames"
    figure = versus(partial(seconds_of, model, steps), timer(partial(work, scene.frames)))
    return Measurement(what, figure, 15)


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
    z, w, places, h = 0j, 20.0 + 20.0j, [], 1.0 / RATE
    for _ in range(frames):
        z += w * h
        w = w * 0.99 - 0.16j
        places.append((z.real, z.imag))
