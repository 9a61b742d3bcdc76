"""The errors that `make choose` estimates are the true ones, or are marked as doubtful."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from scipy.integrate import solve_ivp

from autograder.manifest import ROOT
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceGenerator, Gravity, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import AnchoredCable, AnchoredRod
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from scenes.integrators import INTEGRATORS
from studies import choose
from studies.accuracy.catalog import scenes_with
from studies.accuracy.measure import Point
from studies.accuracy.results import cheapest, first_within
from studies.choose import runs
from studies.choose.doubts import contradiction, is_guess, warnings
from studies.choose.halving import distance, halved
from studies.choose.models import models_of
from studies.choose.scene import OwnScene, load

EXAMPLE, DRIVEN = (ROOT / f"studies/choose/example{which}.py" for which in ("", "_driven"))
DOWN = Vector3(0.0, -10.0)


@pytest.fixture(autouse=True)
def _runs_are_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.02)


def world(particle: Particle, *forces: ForceGenerator) -> ParticleWorld:
    made = ParticleWorld([particle])
    for force in forces:
        made.registry.add(particle, force)
    return made


def spring() -> ParticleWorld:
    return world(Particle(Vector3(1.0)), AnchoredSpring(Vector3(), 100.0, 0.0, 2.0))


def fall() -> ParticleWorld:
    return world(Particle(), Gravity(Vector3(0.0, -9.81)), Drag(0.0, 0.05))


def orbit() -> ParticleWorld:
    start = Particle(Vector3(0.5), Vector3(0.0, math.sqrt(3.0)))
    return world(start, InverseSquareGravity(Vector3(), 1.0))


def pendulum() -> ParticleWorld:
    bob = Particle(Vector3(1.0), acceleration=DOWN)
    return ParticleWorld([bob], [AnchoredRod(bob, Vector3(), 1.0)])


def seen(world: ParticleWorld) -> list[float]:
    return [world.particles[0].position.x, world.particles[0].position.y]


# The same scenes in the catalog, whose exact solutions have tests of their own.
BUILT: dict[str, Callable[[], ParticleWorld]] = {
    "spring, k = 100 ": spring,
    "fall with quadratic drag": fall,
    "orbit of eccentricity 0.5": orbit,
    "pendulum from horizontal": pendulum,
}


def expect_true(found: list[runs.Tried], truth: list[list[float]]) -> set[str]:
    """Expect that the errors of steady models are the true ones, and return their names."""
    steady = [tried for tried in found if tried.halved.is_steady]
    for tried in steady:
        for run, error in zip(tried.runs, tried.halved.errors, strict=True):
            true = distance(run, truth) if run else math.inf
            # Below that, rounding hides both: 1e-12 of the 45 m that the body falls is 5e-11.
            assert error == pytest.approx(true, rel=0.5, abs=1e-10), tried.model.name
    return {tried.model.name for tried in steady}


@pytest.mark.parametrize("part", BUILT)
def test_estimated_errors_are_the_true_ones_and_so_is_the_choice(part: str) -> None:
    (exact,) = scenes_with(part)
    own = OwnScene(Path(part), exact.frames, BUILT[part], seen)
    found = runs.explore(own, 1e-3, lambda *_: None)
    truth = [[*exact.truth(frame / RATE)] for frame in range(1, exact.frames + 1)]
    assert len(expect_true(found, truth)) >= 2
    allowed = 1e-3 * exact.scale  # the catalog measures in units of its scale
    models = {model.name: model for model in exact.models}
    work = {"velocity Verlet": 2, "Runge-Kutta 4": 4}  # evaluations in a step, for its time
    true, estimated = [], []
    for tried in found:
        name = tried.model.name
        if name not in INTEGRATORS or part.startswith("pendulum"):
            continue
        for choice, error in zip(tried.model.choices, tried.halved.errors, strict=False):
            times = [float(choice * work.get(name, 1))]
            known = exact.error(models[name].run(choice)) * exact.scale
            true.append(Point(part, name, "ours", choice, known, 0, times))
            estimated.append(Point(part, name, "ours", choice, error, 0, times))
    mine, catalogs = (cheapest(points, allowed)[0] for points in (estimated, true))
    assert (mine and (mine.model, mine.steps)) == (catalogs and (catalogs.model, catalogs.steps))


def test_a_clock_that_is_a_particle_keeps_the_orders_and_the_errors() -> None:
    """The equation is x'' = -100 x + 10 cos(8 t), from rest at 0."""
    scene = load(DRIVEN)
    times = [frame / RATE for frame in range(1, scene.frames + 1)]
    truth = [10.0 / (100.0 - 64.0) * (math.cos(8.0 * t) - math.cos(10.0 * t)) for t in times]
    found = runs.explore(scene, 1e-3, lambda *_: None)
    steady = expect_true(found, [[x, 0.0, 0.0] for x in truth])
    assert {"leapfrog", "velocity Verlet", "Runge-Kutta 4"} <= steady
    assert contradiction(found, 1e-3) == ""


def test_the_example_is_chosen_rightly_and_is_in_the_readme(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert choose.main([str(EXAMPLE), "--tolerance", "1e-3"]) == 0
    told = capsys.readouterr().out
    assert "2 s, error at most 0.001 in every frame" in told
    # The clear engine takes about as long for either of them.
    either = r"(Runge-Kutta 4, once|leapfrog, 8 steps|velocity Verlet, 4 steps) per frame: "
    assert re.search(rf"cheapest: +{either}", told)
    page = (ROOT / "studies/README.md").read_text(encoding="utf-8")
    assert "make choose SCENE=studies/choose/example.py" in page

    def rates(_: float, state: list[float]) -> list[float]:
        x, y, u, v = state
        length, speed = math.hypot(x, y), math.hypot(u, v)
        pull, drag = 400.0 * (length - 1.0) / length, 0.1 + 0.05 * speed
        return [u, v, -(pull * x + drag * u) / 2.0, -(pull * y + drag * v) / 2.0 - 9.81]

    times = [frame / RATE for frame in range(1, 121)]
    start = [1.2, 0.0, 0.0, 0.0]
    exact = solve_ivp(rates, (0.0, 2.0), start, "DOP853", times, rtol=1e-12, atol=1e-12).y[:2].T
    scene = load(EXAMPLE)
    for tried in runs.explore(scene, 1e-3, lambda *_: None):
        first = first_within(tried.points(scene), 1e-3)
        if first is not None:
            run = [place[:2] for place in tried.runs[first] or []]
            assert abs(exact - run).max() <= 1e-3, tried.model.name


def test_models_follow_from_the_scene() -> None:
    def special(made: ParticleWorld) -> list[str]:
        names = [model.name for model in models_of(made)]
        fixed = [name.removesuffix(", then contacts") in INTEGRATORS for name in names]
        assert sum(fixed) in (0, len(INTEGRATORS))
        return [name for name, is_one in zip(names, fixed, strict=True) if not is_one]

    def held(restitution: float) -> ParticleWorld:
        ball = Particle()
        return ParticleWorld([ball], [AnchoredCable(ball, Vector3(), 1.0, restitution)])

    assert special(world(Particle())) == ["exact steps", "adaptive"]
    assert special(spring()) == ["adaptive"]
    assert special(world(Particle(damping=0.9), Gravity(DOWN))) == []
    assert special(held(0.0)) == ["direct net", "smooth net", "small steps"]
    assert special(held(0.5)) == ["small steps"]
    ball = Particle()
    assert special(ParticleWorld([ball], [GroundPlane([ball])])) == [
        "time division",
        "sequential impulses",
        "small steps",
    ]
    assert special(SleepingWorld([Particle()])) == ["its own step"]


def test_piles_are_tried_with_the_solvers_for_piles() -> None:
    def pile() -> ParticleWorld:
        balls = [Particle(Vector3(0.0, y), acceleration=DOWN) for y in (0.5, 1.5)]
        return ParticleWorld(balls, [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)])

    def heights(world: ParticleWorld) -> list[float]:
        return [particle.position.y for particle in world.particles]

    found = runs.explore(OwnScene(Path("pile"), 30, pile, heights), 1e-3, lambda *_: None)
    solved = {tried.model.name: tried for tried in found}
    for name in ("sequential impulses", "small steps"):
        last = solved[name].runs[-1]
        assert last is not None
        assert distance(last, [[0.5, 1.5]] * 30) <= 2e-3  # it stays at rest


def test_errors_of_runs_that_failed_or_repeat_are_not_known() -> None:
    values = [None, *([[1.0 + 0.5**n]] for n in range(5))]
    found = halved(values, 2.0, 1.0)
    assert found.is_steady
    assert found.errors == pytest.approx([math.inf, *(0.5**n for n in range(5))])
    same = [[[1.0]]] * 4
    assert halved(same, 10.0, 1.0).is_exact
    unknown = halved(same, 10.0, 1.0, may_repeat=True)
    assert not unknown.is_steady
    assert unknown.errors == [math.inf] * 4
    assert halved(values[:2], 2.0, 1.0).errors == [math.inf] * 2
    jumping = halved([[[0.0]], [[4.0]], [[3.0]], [[3.5]], [[3.0]]], 2.0, 1.0)
    assert (jumping.is_steady, jumping.errors[-1]) == (False, 1.0)
    # A method of order 1 that shows order 3 by chance is believed to have order 1.
    assert halved([[[0.125**n]] for n in range(5)], 2.0, 1.0).errors[-1] == pytest.approx(
        7.0 * 0.125**4
    )


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


def test_chaos_is_accepted_only_if_short_steps_show_the_order() -> None:
    """In chaos, the first runs show orders from -0.5 to 4.4. These are errors of three stars."""
    errors = [3.1, 0.4, 0.52, 0.11, 0.0052, 5.2e-3 / 2**5, 5.2e-3 / 2**9]
    assert not halved([[[error]] for error in errors[:5]], 2.0, 4.0).is_steady
    found = halved([[[error]] for error in errors], 2.0, 4.0)
    assert found.is_steady
    assert min(found.orders) < 0.0
    assert 0.9 * errors[-2] <= found.errors[-2] <= 3.0 * errors[-2]
    (model,) = (model for model in models_of(orbit()) if model.name == "Runge-Kutta 4")
    one = runs.Tried(model)
    for error in errors[:6]:
        one.add([[error]], 1.0)
    patient = runs.PATIENCE * runs.SLOWEST  # with a model that begins to converge
    assert not one.is_too_slow(0.9 * patient)
    assert one.is_too_slow(1.1 * patient)


def tried(name: str, limit: float, count: int = 5) -> runs.Tried:
    found = runs.Tried(replace(models_of(spring())[0], name=name))
    for n in range(count):
        found.add([[limit + 0.5**n]], 1.0)
    return found


MINE = tried("mine", 1.0)
CHOSEN = Point("", "mine", "ours", 16, MINE.halved.errors[-1], 0)


def test_a_contradiction_counts_only_beyond_the_tolerance() -> None:
    alike, other = tried("alike", 1.01), tried("other", 2.0)
    assert MINE.halved.errors[-1] == pytest.approx(0.5**4)
    assert contradiction([MINE, alike], 0.1) == ""
    told = "the models disagree: mine and other differ by 1, but by their own estimates"
    assert contradiction([MINE, alike, other], 0.1).startswith(told)
    assert contradiction([MINE, other], 1.5) == ""  # both are accurate enough all the same
    assert contradiction([MINE, other], 0.01) == ""  # neither claims to be accurate
    (milder,) = warnings([MINE, other], CHOSEN, 1.5)
    assert milder.startswith("mine and other differ by 1. This is less than the tolerance")


def test_warnings_name_models_that_are_unknown_alone_or_guessed() -> None:
    none, failed = (runs.Tried(replace(MINE.model, name=name)) for name in ("none", "failed"))
    failed.add("failed because of its steps", 1.0)
    alone = "only mine converges, so no other model confirms its error"
    assert warnings([MINE, none], CHOSEN, 0.1) == ["none: its runs hardly differ", alone]
    assert warnings([MINE, failed], CHOSEN, 0.1) == ["failed because of its steps", alone]
    assert not is_guess(failed)
    guessed = tried("guessed", 1.0, 3)
    assert is_guess(guessed)
    assert "errors marked ? are only guesses" in warnings([MINE, guessed], CHOSEN, 0.1)[0]


def test_a_run_that_chooses_its_own_steps_is_stopped(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = load(DRIVEN)
    (model,) = (model for model in models_of(scene.built()) if model.takes_tolerance)
    monkeypatch.setattr(runs, "LONGEST", 0.0)
    told, _ = runs.run_once(scene, model, 10)
    assert "the run is not finished after 0 s" in str(told)
