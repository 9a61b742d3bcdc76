"""The answers to the scenes' questions hold for all parameters, and choices mean what they say."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy
import pytest

from lab.catalog import load
from lab.drawing.pen import Pen
from lab.scene import Scene
from studies.accuracy.scene import Model, Outcome

SPRING: Any = load("one-spring")
CHARTS: Any = load("charts")


def answer(scene: Scene) -> int:
    assert scene.predict is not None
    return scene.predict.answer(scene)


@pytest.mark.parametrize(
    "drags", [(0.0, 0.0), (0.0, 0.02), (0.02, 0.02), (0.1, 0.02), (0.02, 0.0)], ids=str
)
@pytest.mark.parametrize("masses", [(0.1, 10.0), (4.0, 4.0), (4.0, 0.5)], ids=str)
def test_the_ball_that_is_said_to_land_first_does(
    drags: tuple[float, float], masses: tuple[float, float]
) -> None:
    names = ("left_drag", "right_drag", "left_mass", "right_mass")
    values = dict(zip(names, (*drags, *masses), strict=True))
    scene: Any = load("fall-in-air")(**values, rate=240)
    while math.inf in scene.landed and scene.time < 80.0:
        scene.advance()
    left, right = scene.landed
    assert answer(scene) == (2 if left == right else 0 if left < right else 1)


@pytest.mark.parametrize("rate", load("frame-rates").rate.options)
def test_the_ball_with_the_longest_steps_flies_farthest(rate: float) -> None:
    scene: Any = load("frame-rates")(rate=rate)
    assert len(set(scene.rates)) == 3
    assert scene.rates[0] == min(scene.rates)
    for _ in range(360):
        scene.advance()
    flown = [path[-1][0] for path in scene.paths]
    assert answer(scene) == 0
    assert flown[0] == max(flown)


def growth(scene: Any) -> float:
    """Return the spectral radius of a step of one spring, which is above 1 if the motion grows."""
    h = 1.0 / scene.rate
    ends = []
    for v in (0.0, 1.0):
        scene.let_go(1.0, v / h)
        scene.step(h)
        ends.append((scene.ball.position.x, scene.ball.velocity.x * h))
    still, moving = numpy.array(ends)
    return float(max(abs(numpy.linalg.eigvals(numpy.array([still, moving - still])))))


@pytest.mark.parametrize("integrator", SPRING.integrator.options)
@pytest.mark.parametrize("rate", SPRING.rate.options)
def test_a_spring_is_stable_where_its_steps_do_not_grow(integrator: str, rate: float) -> None:
    """The grid covers the whole range of the sliders, and both sides of the limit."""
    stiffnesses = numpy.geomspace(SPRING.stiffness.low, SPRING.stiffness.high, 12)
    seen = set()
    for m, c in itertools.product((0.1, 1.0, 10.0), (0.0, 1.0, 9.3, 20.0)):
        for k in stiffnesses:
            scene = SPRING(integrator=integrator, rate=rate, stiffness=k, mass=m, damping=c)
            # A stable spring without damping neither grows nor decays, up to rounding.
            stable = growth(scene) <= 1.0 + 1e-9
            assert answer(scene) == int(not stable), (k, m, c)
            assert ("unstable" in scene.facts()) == (not stable)
            seen.add(stable)
    assert seen == {True, False} or rate > 120.0  # no spring is too stiff for the shortest steps


@pytest.mark.parametrize("rate", [15.0, 60.0])
@pytest.mark.parametrize(("mass", "damping"), [(1.0, 0.0), (1.0, 10.0), (0.1, 5.0)])
def test_pymunks_spring_is_stable_up_to_its_own_limit(
    rate: float, mass: float, damping: float
) -> None:
    limit = 2.0 * (1.0 + math.exp(damping / rate / mass)) * mass * rate**2
    for factor, unstable in ((0.98, 0), (1.02, 1)):
        stiffness = min(2e4, factor * limit)
        values = {"rate": rate, "mass": mass, "damping": damping, "stiffness": stiffness}
        scene = SPRING.peers["pymunk"](**values)
        assert answer(scene) == (unstable if factor * limit < 2e4 else 0)
        assert (growth(scene) > 1.0 + 1e-6) == bool(answer(scene))
    assert answer(SPRING.peers["exact"](stiffness=20_000.0, rate=15.0, mass=0.1)) == 0


def test_a_smaller_tolerance_gives_a_smaller_error() -> None:
    """The adaptive method takes a tolerance, so the number of steps does not change its run."""
    errors = []
    for tolerance in CHARTS.tolerance.options:
        scene = CHARTS(method="adaptive", tolerance=tolerance)
        assert f"a tolerance of {tolerance:g} m" in scene.facts()
        found = []
        for _ in range(scene.scene.frames):
            found.append(scene.error())
            scene.advance()
        errors.append(max(found))
        # Two seconds of an error of at most the tolerance per frame, as the integrator promises.
        assert errors[-1] * scene.scene.scale < 120 * tolerance
    assert errors == sorted(errors, reverse=True)
    assert errors[0] > 100.0 * errors[-1]


@pytest.mark.parametrize(
    ("method", "takes"),
    [
        ("leapfrog", "steps"),
        ("multistep, order 4", "long_steps"),
        ("adaptive", "tolerance"),
        ("closed form", "nothing, as it has no steps"),
    ],
)
def test_the_charts_run_what_was_chosen(
    method: str, takes: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A method runs with the number of the parameter that it takes, and ignores the others."""
    asked: list[int] = []

    def run(number: int) -> Outcome:
        asked.append(number)
        return Outcome([(0.0, 0.0)], 1)

    monkeypatch.setattr(Model, "run", property(lambda _: run), raising=False)
    for name in ("steps", "long_steps", "tolerance"):
        asked.clear()
        options = CHARTS.__dict__[name].options
        for value in options:
            CHARTS(charted="projectile with linear drag", method=method, **{name: value})
        if name == takes:
            assert asked == (options if name != "tolerance" else [100, 10**4, 10**6, 10**8])
        else:
            assert len({*asked}) == 1


def test_a_method_that_a_scene_does_not_have_is_named() -> None:
    scene = CHARTS(charted="net of 6 by 6 cables", method="leapfrog")
    pen = Pen()
    scene.draw(pen)
    (words,) = [item for item in pen.items if item[0] == "text"]
    assert "(there is no leapfrog in this scene)" in str(words)
