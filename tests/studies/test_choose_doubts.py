"""Clocks, contradictions, chaos and numbers in the report of `make choose` on a reader's scene."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy
import pytest
from scipy.integrate import solve_ivp

from autograder.manifest import ROOT
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from scenes.integrators import INTEGRATORS
from studies import choose
from studies.accuracy.catalog import scenes_with
from studies.accuracy.measure import Point
from studies.choose import runs
from studies.choose.doubts import contradiction, is_guess, warnings
from studies.choose.halving import distance, halved
from studies.choose.models import models_of
from studies.choose.report import told_beside, told_of
from studies.choose.scene import OwnScene, load

DRIVEN = ROOT / "studies/choose/example_driven.py"

Tell = Callable[[str], tuple[int, str]]

WORLD = """
import math
import random
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 0.5

def build():
    body = Particle()
    world = ParticleWorld([body])
    world.registry.add(body, AnchoredSpring(Vector3(), 4.0, 0.0))
    world.registry.add(body, Wind())
    return world
"""
CLOCK = """
class Wind:
    time = 0.0

    def update_force(self, particle, duration):
        particle.add_force(Vector3(10.0 * math.sin(3.0 * self.time)))
        self.time += duration
"""
LATE = """
class Wind:
    time = 0.0

    def update_force(self, particle, duration):
        particle.add_force(Vector3(1.0 if self.time < 0.4 else 2.0))
        self.time += duration
"""
RANDOM = """
class Wind:
    def update_force(self, particle, duration):
        particle.add_force(Vector3(random.random()))
"""
# This clock stands still while the particle does, so that it is not found before the runs.
HIDDEN = """
class Wind:
    time, last = 0.0, None

    def update_force(self, particle, duration):
        particle.add_force(Vector3(10.0 * math.cos(3.0 * self.time)))
        if self.last not in (None, particle.position.x):
            self.time += duration
        self.last = particle.position.x
"""


@pytest.fixture
def tell(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Tell:
    """Return a function that runs the command on a file, with its status and its text."""
    monkeypatch.setattr(runs, "SLOWEST", 0.01)
    monkeypatch.setattr(runs, "ROUNDS", 1)

    def run(text: str) -> tuple[int, str]:
        file = tmp_path / "my_scene.py"
        file.write_text(text, encoding="utf-8")
        try:
            status = choose.main([str(file)])
        except SystemExit as stopped:
            status = int(stopped.code or 0)
        told = capsys.readouterr()
        return status, " ".join((told.out + told.err).split())

    return run


@pytest.mark.parametrize("wind", [CLOCK, LATE, RANDOM])
def test_a_force_with_a_memory_is_refused(wind: str, tell: Tell) -> None:
    status, told = tell(WORLD + wind)
    assert status == 2
    assert "my_scene.py: Wind gave different forces, although no particle had moved." in told
    assert "a clock that is a particle, as in studies/choose/example_driven.py" in told


def test_models_that_contradict_each_other_are_not_called_accurate(
    tell: Tell, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock is right if a step calls it once, and runs faster in Verlet and Runge-Kutta."""
    two = [model for model in models_of(clocked()) if model.name in ("leapfrog", "Runge-Kutta 4")]
    monkeypatch.setattr(runs, "models_of", lambda _: two)
    monkeypatch.setattr(runs, "SLOWEST", 1.0)
    status, told = tell(WORLD + HIDDEN)
    assert status == 1
    says = "cheapest: unknown, because the models disagree: leapfrog and Runge-Kutta 4 differ by "
    gap, mine, other = re.findall(
        rf"{says}(\S+), but by their own estimates their errors are only (\S+) and (\S+)\. ", told
    )[0]
    assert 0.05 < float(gap) < 10.0
    assert max(float(mine), float(other)) < 1e-3
    assert "next cheaper" not in told
    assert len(re.findall(r"\? 0\.000\d+ ", told)) == 2  # the errors of both are marked
    assert "Check that every force depends only on the current state of the particles." in told


def clocked() -> ParticleWorld:
    """Build a world with a force and without contacts."""
    made = ParticleWorld([Particle()])
    made.registry.add(made.particles[0], load(DRIVEN).build().registry.pairs()[0][1])
    return made


def tried(name: str, limit: float, count: int = 5) -> runs.Tried:
    found = runs.Tried(replace(models_of(clocked())[0], name=name))
    for n in range(count):
        found.add([[limit + 0.5**n]], 1.0)
    return found


def test_a_contradiction_counts_only_beyond_the_tolerance() -> None:
    mine, alike, other = tried("mine", 1.0), tried("alike", 1.01), tried("other", 2.0)
    assert mine.halved.errors[-1] == pytest.approx(0.5**4)
    assert contradiction([mine, alike], 0.1) == ""
    told = "the models disagree: mine and other differ by 1, but by their own estimates"
    assert contradiction([mine, alike, other], 0.1).startswith(told)
    assert contradiction([mine, other], 1.5) == ""  # both are accurate enough all the same
    assert contradiction([mine, other], 0.01) == ""  # neither claims to be accurate
    chosen = Point("", "mine", "ours", 16, mine.halved.errors[-1], 0)
    (milder,) = warnings([mine, other], chosen, 1.5)
    assert milder.startswith("mine and other differ by 1. This is less than the tolerance")


def test_marks_are_explained_only_if_there_are_any() -> None:
    steady, failed = tried("steady", 1.0), runs.Tried(replace(tried("", 1.0).model, name="failed"))
    failed.add("failed because of its steps", 1.0)
    chosen = Point("", "steady", "ours", 16, steady.halved.errors[-1], 0)
    assert not is_guess(failed)
    assert warnings([steady, failed], chosen, 0.1)[0] == "failed because of its steps"
    assert not any("marked ?" in told for told in warnings([steady, failed], chosen, 0.1))
    guessed = tried("guessed", 1.0, 3)
    assert is_guess(guessed)
    assert "errors marked ? are only guesses" in warnings([steady, guessed], chosen, 0.1)[0]


def test_an_error_is_not_rounded_to_the_tolerance() -> None:
    assert told_beside(1e-3, 4e-4) == "0.0004"
    assert told_beside(1e-3, 0.00098) == "0.00098"
    assert told_beside(1e-3, 0.001004) == "0.001004"
    assert told_beside(1e-3, 0.00144) == "0.0014"
    assert told_beside(1e-3, 1e-3) == "0.001"
    assert told_beside(1.5e-3, 0.00144) == "0.001"
    assert told_beside(1.5e-3, 0.00154) == "0.002"
    assert told_beside(1e-3, 0.0294, 2) == "0.029"
    assert told_beside(1e-3, math.nextafter(1e-3, 1.0)) == "0.0010000000000000002"


def test_steps_longer_than_a_frame_are_counted_in_several_frames() -> None:
    (scene,) = scenes_with("double pendulum")
    model = next(model for model in scene.models if model.per > 1)
    point = Point(scene.name, model.name, "ours", 3, 4e-4, 240, [1e-3])
    assert f"{model.name}, 3 steps per {model.per} frames: " in told_of(scene, 1e-3, point)
    once = replace(point, steps=1)
    assert f"{model.name}, once per {model.per} frames: " in told_of(scene, 1e-3, once)


def stars() -> tuple[OwnScene, list[list[float]]]:
    """Build a chaotic scene, three stars that attract a body, and its motion by SciPy."""
    places = [(0.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]

    class Star:
        def __init__(self, center: Vector3) -> None:
            self.center = center

        def update_force(self, particle: Particle, _: float) -> None:
            offset = self.center - particle.position
            particle.add_force(offset * (5.0 / (offset.squared_magnitude() + 0.01) ** 1.5))

    def build() -> ParticleWorld:
        body = Particle(Vector3(0.2))
        world = ParticleWorld([body])
        for x, y in places:
            world.registry.add(body, Star(Vector3(x, y)))
        return world

    def rates(_: float, state: list[float]) -> list[float]:
        x, y, u, v = state
        pulls = [(a - x, b - y, ((a - x) ** 2 + (b - y) ** 2 + 0.01) ** 1.5) for a, b in places]
        return [u, v, *(sum(5.0 * pull[i] / pull[2] for pull in pulls) for i in (0, 1))]

    frames = round(6.0 * RATE)
    times = [frame / RATE for frame in range(1, frames + 1)]
    exact = solve_ivp(rates, (0, 6.0), [0.2, 0, 0, 0], "DOP853", times, rtol=1e-13, atol=1e-13)

    def measure(world: ParticleWorld) -> list[float]:
        return [world.particles[0].position.x, world.particles[0].position.y]

    return OwnScene(Path("stars"), frames, build, measure), exact.y[:2].T.tolist()


def test_chaos_is_accepted_if_short_steps_show_the_order(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first runs of Runge-Kutta 4 show orders from -0.5 to 4.4, and the next one order 5."""
    scene, truth = stars()
    (model,) = (model for model in models_of(scene.built()) if model.name == "Runge-Kutta 4")
    monkeypatch.setattr(runs, "models_of", lambda _: [model])
    monkeypatch.setattr(runs, "SLOWEST", 1e-9)  # every run is slow, on any computer
    monkeypatch.setattr(runs, "PATIENCE", 1e12)
    (found,) = runs.explore(scene, 1e-3, lambda _: None)
    assert found.halved.is_steady
    assert min(found.halved.orders) < 0.0
    for run, error in zip(found.runs[-3:], found.halved.errors[-3:], strict=True):
        assert run is not None
        true = distance(run, truth)
        assert 0.9 * true <= error <= 3.0 * true
    assert not halved(found.runs[:5], 2.0, 4.0).is_steady  # five runs are not enough


def test_the_error_of_an_adaptive_method_falls_with_the_tolerance_on_average() -> None:
    gaps = [10.0**-n for n in (0.0, 0.5, 2.7, 3.0)]  # orders 0.5, 2.2 and 0.3, as in a run
    values = [[[sum(gaps[n:])]] for n in range(5)]
    assert not halved(values, 10.0, 1.0).is_steady
    varies = halved(values, 10.0, 1.0, may_vary=True)
    assert varies.is_steady
    assert varies.errors[-1] == pytest.approx(1e-3 / (10.0**0.3 - 1.0))  # by the lowest order
    assert not halved([*values, [[-1.0]]], 10.0, 1.0, may_vary=True).is_steady
    higher = halved([[[3.0 ** -(n * n)]] for n in range(1, 8)], 2.0, 1.0)
    assert higher.is_steady  # at least order 1 every time, which the estimate then uses
    assert higher.errors[-1] == pytest.approx(3.0**-36 - 3.0**-49, rel=1e-6)


def test_a_run_that_chooses_its_own_steps_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = load(DRIVEN)
    (model,) = (model for model in models_of(scene.built()) if model.takes_tolerance)
    monkeypatch.setattr(runs, "LONGEST", 0.0)
    told, _ = runs.run_once(scene, model, 10)
    assert "the run is not finished after 0 s" in str(told)


def test_piles_are_tried_with_the_solvers_for_piles(monkeypatch: pytest.MonkeyPatch) -> None:
    def pile() -> ParticleWorld:
        balls = [Particle(Vector3(0.0, y), acceleration=Vector3(0, -10)) for y in (0.5, 1.5)]
        return ParticleWorld(balls, [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)])

    def heights(world: ParticleWorld) -> list[float]:
        return [particle.position.y for particle in world.particles]

    monkeypatch.setattr(runs, "SLOWEST", 0.05)
    found = runs.explore(OwnScene(Path("pile"), 30, pile, heights), 1e-3, lambda _: None)
    solved = {tried.model.name: tried for tried in found}
    for name in ("sequential impulses", "small steps"):
        last = solved[name].runs[-1]
        assert last is not None
        assert distance(last, [[0.5, 1.5]] * 30) <= 2e-3  # it stays at rest


# The orders of convergence in theory. The wind of the example does not depend on the velocity.
ORDERS = dict.fromkeys(INTEGRATORS, 1) | {"leapfrog": 2, "velocity Verlet": 2, "Runge-Kutta 4": 4}


def driven(time: float) -> float:
    """Solve x'' = -100 x + 10 cos(8 t) from rest at 0, at a time in s."""
    return 10.0 / (100.0 - 64.0) * (math.cos(8.0 * time) - math.cos(10.0 * time))


@pytest.mark.parametrize("name", INTEGRATORS)
def test_a_clock_particle_keeps_the_order_of_each_integrator(name: str) -> None:
    def error(steps: int) -> float:
        world, duration = load(DRIVEN).build(), 1.0 / (RATE * steps)
        world.integrator = INTEGRATORS[name]
        worst = 0.0
        for frame in range(1, 121):
            for _ in range(steps):
                world.step(duration)
            clock, sign = world.particles
            assert clock.position.x == pytest.approx(frame / RATE, rel=1e-12)
            worst = max(worst, abs(sign.position.x - driven(frame / RATE)))
        return worst

    # Between 16 and 32 steps per frame, terms of higher order change the ratio by a few percent.
    assert math.log2(error(16) / error(32)) == pytest.approx(ORDERS[name], abs=0.15)


def test_a_clock_particle_keeps_the_tolerance_of_adaptive_steps() -> None:
    for tolerance in (1e-6, 1e-9):
        world, worst = load(DRIVEN).build(), 0.0
        world.integrator = adaptive(tolerance)
        for frame in range(1, 121):
            world.step(1.0 / RATE)
            worst = max(worst, abs(world.particles[1].position.x - driven(frame / RATE)))
        # The errors of the steps add up to ten to a few hundred tolerances.
        assert worst <= 300.0 * tolerance


def test_the_errors_of_the_driven_example_are_the_true_ones(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    scene = load(DRIVEN)
    truth = [[driven(frame / RATE), 0.0, 0.0] for frame in range(1, scene.frames + 1)]
    found = runs.explore(scene, 1e-3, lambda _: None)
    steady = [tried for tried in found if tried.halved.is_steady]
    assert {"leapfrog", "velocity Verlet", "Runge-Kutta 4"} <= {t.model.name for t in steady}
    assert contradiction(found, 1e-3) == ""
    for tried in steady:
        for run, error in zip(tried.runs, tried.halved.errors, strict=True):
            true = numpy.inf if run is None else distance(run, truth)
            assert error == pytest.approx(true, rel=0.5, abs=1e-10), tried.model.name
