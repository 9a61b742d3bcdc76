"""The pendulums and chains of the charts agree with other equations and have their orders."""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from plots.drawing import slope
from scenes.clock import RATE
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.scene import Scene

NAMES = ("pendulum", "rods", "rope of")
SCENES = {scene.name: scene for part in NAMES for scene in scenes_with(part)}
# The length of a rod, the masses, the angle in degrees and gravity.
CHAINS: dict[str, tuple[float, list[float], float, float]] = {
    "pendulum from horizontal": (1.0, [1.0], 90.0, 10.0),
    "double pendulum": (1.0, [1.0, 1.0], 60.0, 9.81),
    "five rods, heavy tip": (1.0, [1.0, 1.0, 1.0, 1.0, 10.0], 60.0, 9.81),
    "rope of 30 links": (0.1, [0.1] * 30, 30.0, 10.0),
}


def expect_truth(scene: Scene, rates: Any, start: Any, place: Any) -> None:
    """Compare a scene's exact solution with SciPy's solution of other equations, at ten times."""
    times = numpy.linspace(0.1, 1.0, 10) * scene.frames / RATE
    span = (0.0, times[-1])
    found = solve_ivp(rates, span, start, "DOP853", times, rtol=1e-12, atol=1e-13)
    for time, state in zip(times, found.y.T, strict=True):
        # SciPy's own error is 1e-12 per step. It adds up over some thousand steps along the path.
        assert scene.truth(time) == pytest.approx(place(state), abs=2e-9)


@pytest.mark.parametrize("name", CHAINS)
def test_the_truth_of_a_chain_is_that_of_points_held_by_tensions(name: str) -> None:
    """Use Newton's equations of points in the plane, with tensions that keep the rods' lengths.

    For each rod, r.r'' = -r'.r'. With the rods' ends as rows of a matrix of 1 and -1, one dense
    solve gives the tensions per m of length. The scene's own solution uses angles and no tensions.
    """
    length, masses, degrees, gravity = CHAINS[name]
    count, inverse = len(masses), 1.0 / numpy.array(masses)
    ends = numpy.eye(count) - numpy.eye(count, k=-1)  # rod i runs from mass i - 1 to mass i
    shared = (ends * inverse) @ ends.T
    free = numpy.tile([0.0, -gravity], (count, 1))

    def rates(_: float, state: Any) -> Any:
        p, v = state.reshape(2, count, 2)
        rod, turn = ends @ p, ends @ v
        wanted = ((ends @ free) * rod + turn**2).sum(axis=1)
        tension = numpy.linalg.solve(shared * (rod @ rod.T), wanted)
        pull = ends.T @ (tension[:, None] * rod)
        return numpy.stack([v, free - inverse[:, None] * pull]).ravel()

    angle = math.radians(degrees)
    along = length * numpy.array([math.sin(angle), -math.cos(angle)])
    places = numpy.arange(1.0, count + 1.0)[:, None] * along
    start = numpy.stack([places, numpy.zeros((count, 2))]).ravel()
    expect_truth(SCENES[name], rates, start, lambda state: [*state[: 2 * count]])


def test_the_truth_of_the_elastic_pendulum_is_that_of_its_polar_equations() -> None:
    def rates(_: float, state: Any) -> list[float]:
        r, angle, dr, turn = state  # the angle is measured from straight down
        pull = 200.0 * (r - 1.0)
        ddr = r * turn**2 + 9.81 * math.cos(angle) - pull
        return [dr, turn, ddr, -(9.81 * math.sin(angle) + 2.0 * dr * turn) / r]

    def place(state: Any) -> list[float]:
        r, angle, _, _ = state
        return [r * math.sin(angle), -r * math.cos(angle)]

    start = [1.2, 0.5 * math.pi, 0.0, 1.5 / 1.2]
    expect_truth(SCENES["elastic pendulum"], rates, start, place)


@pytest.mark.parametrize(
    ("scene", "model", "order"),
    [
        ("elastic pendulum", "Runge-Kutta 4", 4),
        ("elastic pendulum", "velocity Verlet", 2),
        ("elastic pendulum", "leapfrog", 2),
        ("elastic pendulum", EXAMPLES, 1),
        ("elastic pendulum", BEST, 2),
        ("elastic pendulum", "pymunk, force by hand", 1),
        ("pendulum from horizontal", "rods as forces, Runge-Kutta 4", 4),
        ("double pendulum", "by its two angles, Runge-Kutta 4", 4),
        ("double pendulum", "by its angles, Runge-Kutta 4", 4),
        ("double pendulum", "rods as forces, Runge-Kutta 4", 4),
        ("double pendulum", "direct chain", 2),
        ("double pendulum", EXAMPLES, 1),
        ("double pendulum", at_best(2), 2),
        ("double pendulum", at_best(10), 2),
        ("five rods, heavy tip", "by its angles, Runge-Kutta 4", 4),
        ("five rods, heavy tip", "rods as forces, Runge-Kutta 4", 4),
        ("five rods, heavy tip", "direct chain", 2),
        ("five rods, heavy tip", EXAMPLES, 1),
        ("five rods, heavy tip", at_best(50), 2),
        ("rope of 30 links", "by its angles, Runge-Kutta 4", 4),
        ("rope of 30 links", "direct chain", 2),
    ],
)
def test_errors_fall_by_the_order_of_the_model(scene: str, model: str, order: int) -> None:
    steps = (4, 8, 16) if order == 4 else (16, 32, 64)
    (run,) = [found.run for found in SCENES[scene].models if found.name == model]
    errors = [SCENES[scene].error(run(count)) for count in steps]
    # The next order contributes at most a twentieth.
    assert slope([1.0 / count for count in steps], errors) == pytest.approx(order, abs=0.1)


def test_the_work_of_chains_is_rods_solved_for_in_every_evaluation() -> None:
    frames = {"double pendulum": 120, "five rods, heavy tip": 120}
    for name, rods in (("double pendulum", 2), ("five rods, heavy tip", 5)):
        models = [model for model in SCENES[name].models if model.per == 1]
        work = {model.name: model.run(2).work for model in models if not model.takes_tolerance}
        once = 2 * frames[name] * rods
        assert work["direct chain"] == once
        assert work["by its angles, Runge-Kutta 4"] == 4 * once
        assert work["rods as forces, Runge-Kutta 4"] == 4 * once
        assert work[EXAMPLES] == 10 * once
        most = {2: 10, 5: 50}[rods]
        assert work[at_best(most)] == most * once
