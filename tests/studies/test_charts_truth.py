"""The scenes of the charts: their exact solutions, the orders of the models, and their work."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from plots.drawing import slope
from scenes.clock import RATE
from scenes.dropped_balls import DroppedBalls
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.scene import Model, Outcome, Scene

SCENES = {scene.name: scene for scene in scenes_with("")}
G = 9.81
SPRING = "spring, k = {} N/m, c = {} N s/m"
HORIZONTAL, DOUBLE, FIVE = "pendulum from horizontal", "double pendulum", "five rods, heavy tip"

Equation = tuple[Callable[..., Any], Any, Callable[[Any], Any]]  # rates, start, and what is seen


def pulled(mu: float, x: float, v: float) -> Equation:
    """Return the equation of an orbit, which begins on the x axis with a velocity along y."""

    def rates(_: float, s: Any) -> list[float]:
        return [s[2], s[3], *(-mu * x / math.hypot(s[0], s[1]) ** 3 for x in s[:2])]

    return rates, [x, 0.0, 0.0, v], lambda s: [s[0], s[1]]


def spring(k: float, c: float) -> Equation:
    return lambda _, s: [s[1], -k * s[0] - c * s[1]], [1.0, 0.0], lambda s: [s[0], 0.0]


def elastic_pendulum(_: float, state: Any) -> list[float]:
    """Return the rates of polar coordinates. The angle is measured from straight down."""
    r, angle, dr, turn = state
    ddr = r * turn**2 + G * math.cos(angle) - 200.0 * (r - 1.0)
    return [dr, turn, ddr, -(G * math.sin(angle) + 2.0 * dr * turn) / r]


def chain(length: float, masses: list[float], degrees: float, gravity: float) -> Equation:
    """Return Newton's equations of points in the plane, with tensions that keep the rods' lengths.

    For each rod, r.r'' = -r'.r'. The scene's own solution uses angles and no tensions.
    """
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
    return rates, start, lambda state: [*state[: 2 * count]]


EQUATIONS: dict[str, Equation] = {
    "projectile with linear drag": (
        lambda _, s: [s[2], s[3], math.log(0.6) * s[2], -G + math.log(0.6) * s[3]],
        [0.0, 1.5, 20.0, 20.0],
        lambda s: [s[0], s[1]],
    ),
    "fall with quadratic drag": (
        lambda _, s: [s[1], -G - 0.05 * abs(s[1]) * s[1]],
        [0.0, 0.0],
        lambda s: [0.0, s[0]],
    ),
    "orbit of eccentricity 0.5": pulled(1.0, 0.5, math.sqrt(3.0)),
    "orbit of eccentricity 0.9": pulled((2.0 * math.pi) ** 2, 0.1, 2.0 * math.pi * math.sqrt(19.0)),
    "floating block": (
        lambda _, s: [s[1], -G + 1000.0 * 0.001 * G / 0.5 * (0.05 - s[0]) / 0.1],
        [0.04, 0.0],
        lambda s: [0.0, s[0]],
    ),
    SPRING.format("10", "0.632"): spring(10.0, 0.2 * math.sqrt(10.0)),
    SPRING.format("100", "2"): spring(100.0, 2.0),
    SPRING.format("10000", "20"): spring(1e4, 20.0),
    "elastic pendulum": (
        elastic_pendulum,
        [1.2, 0.5 * math.pi, 0.0, 1.5 / 1.2],
        lambda s: [s[0] * math.sin(s[1]), -s[0] * math.cos(s[1])],
    ),
    HORIZONTAL: chain(1.0, [1.0], 90.0, 10.0),
    DOUBLE: chain(1.0, [1.0, 1.0], 60.0, G),
    FIVE: chain(1.0, [1.0, 1.0, 1.0, 1.0, 10.0], 60.0, G),
    "rope of 30 links": chain(0.1, [0.1] * 30, 30.0, 10.0),
}


@pytest.mark.parametrize("name", EQUATIONS)
def test_the_truth_of_a_scene_is_that_of_its_equation(name: str) -> None:
    rates, start, place = EQUATIONS[name]
    times = numpy.linspace(0.1, 1.0, 10) * SCENES[name].frames / RATE
    found = solve_ivp(rates, (0.0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-13)
    for time, state in zip(times, found.y.T, strict=True):
        # SciPy's own error is 1e-12 per step. It adds up over some hundred steps along an orbit.
        assert SCENES[name].truth(time) == pytest.approx(place(state), abs=2e-9)


def test_the_truth_of_bounces_is_that_of_drops_and_of_momentum() -> None:
    balls = DroppedBalls((2.1,), 0.8, radius=0.1)
    first = math.sqrt(2.0 * 2.0 / 10.0)
    # The ball rises for 0.8 of the time of the fall, to 0.64 of its height.
    (top,), (down,) = balls.heights_at([1.8 * first, 2.6 * first])
    assert top == pytest.approx(0.64 * 2.0 + 0.1, abs=1e-12)
    assert down == pytest.approx(0.1, abs=1e-12)
    two = DroppedBalls((1.1, 1.3 + 1e-9), 0.9, (1.0, 0.1), 0.8, 0.1)
    speed = math.sqrt(2.0 * 10.0)
    after = 0.01
    _, upper = two.heights_at([speed / 10.0 + after])[0]
    # Exercise 7.3: 0.9 of the speed upward meets the speed downward, in their common frame.
    gone = (1.0 * 0.9 - 0.1) / 1.1 + 0.8 * 1.0 / 1.1 * 1.9
    # A gap of 1e-9 m closes in 1e-10 s.
    assert upper == pytest.approx(0.3 + speed * gone * after - 5.0 * after**2, abs=1e-8)


def model_of(scene: str, name: str) -> Model:
    return next(model for model in SCENES[scene].models if model.name == name)


def errors_of(scene: str, model: str, numbers: list[int]) -> list[float]:
    return [SCENES[scene].error(model_of(scene, model).run(number)) for number in numbers]


@pytest.mark.parametrize("name", SCENES)
def test_closed_forms_and_exact_ways_are_exact(name: str) -> None:
    ways = {"closed form", "exact steps", "time division", "its impacts alone"}
    for way in ways & {model.name for model in SCENES[name].models}:
        # The tolerance allows for some hundred roundings, at k t = 1e3 rad for the stiffest spring.
        assert errors_of(name, way, [1])[0] < 1e-12


@pytest.mark.parametrize(
    ("scene", "model", "order"),
    [
        ("projectile with linear drag", "damping in the particle", 1),
        ("projectile with linear drag", "velocity Verlet", 2),
        ("projectile with linear drag", EXAMPLES, 1),
        ("projectile with linear drag", BEST, 2),
        ("fall with quadratic drag", BEST, 2),
        ("floating block", "Runge-Kutta 4", 4),
        ("floating block", BEST, 2),
        (SPRING.format("100", "2"), "trapezoidal rule", 2),
        (SPRING.format("100", "2"), EXAMPLES, 1),
        (SPRING.format("100", "2"), "pymunk, force by hand", 1),
        (SPRING.format("10000", "20"), BEST, 2),
        (HORIZONTAL, "by its angle, Runge-Kutta 4", 4),
        (HORIZONTAL, at_best(1), 2),
        ("elastic pendulum", EXAMPLES, 1),
        ("elastic pendulum", BEST, 2),
        (DOUBLE, "by its angles, Runge-Kutta 4", 4),
        (DOUBLE, EXAMPLES, 1),
        (DOUBLE, at_best(10), 2),
        (FIVE, "rods as forces, Runge-Kutta 4", 4),
        (FIVE, at_best(50), 2),
        ("rope of 30 links", "direct chain", 2),
    ],
)
def test_errors_fall_by_the_order_of_the_model(scene: str, model: str, order: int) -> None:
    steps = [4, 8, 16] if order == 4 else [16, 32, 64]
    # The next order contributes at most a twentieth.
    found = slope([1.0 / count for count in steps], errors_of(scene, model, steps))
    assert found == pytest.approx(order, abs=0.1)


def test_work_is_what_was_worked_out() -> None:
    """Count evaluations of forces, impacts, and the rods that are solved for in an evaluation."""
    orbit, ball = "orbit of eccentricity 0.5", "bouncing ball, restitution 0.8"
    asked = {"explicit Euler": 1, "leapfrog": 1, "velocity Verlet": 2, "Runge-Kutta 4": 4, BEST: 1}
    for name, times in asked.items():
        assert model_of(orbit, name).run(2).work == 2 * times * SCENES[orbit].frames
    # At 1 m, one step per frame is enough.
    assert model_of(orbit, "adaptive").run(1).work == 7 * SCENES[orbit].frames
    # From 2 m the impacts are at 0.632 s and after flights of 1.012, 0.810, ... s: three in 3 s.
    assert model_of(ball, "time division").run(1).work == SCENES[ball].frames + 3
    rods = {
        "direct chain": 1,
        "by its angles, Runge-Kutta 4": 4,
        "rods as forces, Runge-Kutta 4": 4,
        EXAMPLES: 10,
        at_best(50): 50,
    }
    for name, times in rods.items():
        assert model_of(FIVE, name).run(2).work == 2 * times * SCENES[FIVE].frames * 5


def test_a_run_that_breaks_off_or_has_no_numbers_has_an_infinite_error() -> None:
    def run(_: int) -> Outcome:
        return Outcome([(0.0,), (math.nan,)], 2)

    scene = Scene("none", 2, 1.0, lambda _: (0.0,), [Model("nan", run)])
    assert scene.error(run(1)) == math.inf
