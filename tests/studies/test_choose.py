"""The cheapest model of a reader's scene: estimated errors, the choice, warnings and bad files."""

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
from ch05_forces.forces import Drag, ForceGenerator, Gravity, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable, AnchoredRod
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from scenes.integrators import INTEGRATORS
from studies import choose
from studies.accuracy.catalog import scenes_with
from studies.accuracy.measure import Point
from studies.accuracy.results import cheapest, first_within
from studies.accuracy.scene import Scene
from studies.choose import runs
from studies.choose.doubts import warnings
from studies.choose.halving import distance, halved
from studies.choose.models import models_of
from studies.choose.scene import OwnScene, load

EXAMPLE = ROOT / "studies/choose/example.py"
DOWN = Vector3(0.0, -10.0)


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


# The same scenes in the catalog, whose exact solutions have tests of their own.
BUILT: dict[str, Callable[[], ParticleWorld]] = {
    "spring, k = 100 ": spring,
    "fall with quadratic drag": fall,
    "orbit of eccentricity 0.5": orbit,
    "pendulum from horizontal": pendulum,
}


def explored(part: str, tolerance: float) -> tuple[Scene, list[runs.Tried]]:
    (exact,) = scenes_with(part)

    def measure(world: ParticleWorld) -> list[float]:
        return [world.particles[0].position.x, world.particles[0].position.y]

    own = OwnScene(Path(part), exact.frames, BUILT[part], measure)
    return exact, runs.explore(own, tolerance, lambda _: None)


@pytest.mark.parametrize("part", BUILT)
def test_estimated_errors_are_the_true_ones(part: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    exact, found = explored(part, 1e-3)
    truth = [exact.truth(frame / RATE) for frame in range(1, exact.frames + 1)]
    steady = [tried for tried in found if tried.halved.is_steady]
    assert len(steady) >= 2
    for tried in steady:
        for run, error in zip(tried.runs, tried.halved.errors, strict=True):
            true = distance(run, truth) if run else math.inf
            # Below that, rounding hides both: 1e-12 of the 45 m that the body falls is 5e-11.
            assert error == pytest.approx(true, rel=0.5, abs=1e-10), tried.model.name


# How often a model evaluates the forces in a step, which stands for its time.
WORK = {"velocity Verlet": 2, "Runge-Kutta 4": 4}


@pytest.mark.parametrize("part", ["spring, k = 100 ", "fall with quadratic drag"])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-3])
def test_the_choice_is_that_of_the_true_errors(
    part: str, tolerance: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    exact, found = explored(part, tolerance)
    allowed = tolerance * exact.scale  # the catalog measures in units of its scale
    models = {model.name: model for model in exact.models}
    true, estimated = [], []
    for tried in found:
        name = tried.model.name
        if name == "adaptive":
            continue
        for choice, error in zip(tried.model.choices, tried.halved.errors, strict=False):
            times = [float(choice * WORK.get(name, 1))]
            known = exact.error(models[name].run(choice)) * exact.scale
            true.append(Point(part, name, "ours", choice, known, 0, times))
            estimated.append(Point(part, name, "ours", choice, error, 0, times))
    mine, catalogs = (cheapest(points, allowed)[0] for points in (estimated, true))
    assert mine is not None
    assert catalogs is not None
    assert (mine.model, mine.steps) == (catalogs.model, catalogs.steps)


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


def test_the_example_with_links_shows_that_the_resolver_fails_and_a_net_does_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The resolver corrects one rod at a time, and 20 kg hang on 1 kg."""
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    assert choose.main([str(EXAMPLE.with_name("example_links.py")), "--tolerance", "1e-2"]) == 0
    told = capsys.readouterr().out
    assert re.search(r"cheapest: +(direct|smooth) net, ", told)
    assert "Warning: errors marked ? are only guesses" in told


def test_a_model_that_no_other_confirms_warns() -> None:
    mine = runs.Tried(replace(models_of(spring())[0], name="mine"))
    for n in range(5):
        mine.add([[1.0 + 0.5**n]], 1.0)
    chosen = Point("", "mine", "ours", 16, mine.halved.errors[-1], 0)
    assert warnings([mine, runs.Tried(replace(mine.model, name="none"))], chosen, 0.1) == [
        "none: its runs hardly differ",
        "only mine converges, so no other model confirms its error",
    ]


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


def test_the_example_is_chosen_rightly_and_is_in_the_readme(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    assert choose.main([str(EXAMPLE), "--tolerance", "1e-3"]) == 0
    told = capsys.readouterr().out
    assert "2 s, error at most 0.001 in every frame" in told
    # The clear engine takes about as long for either of them.
    either = r"(Runge-Kutta 4, once|leapfrog, 8 steps|velocity Verlet, 4 steps) per frame: "
    assert re.search(rf"cheapest: +{either}", told)
    assert "make choose SCENE=studies/choose/example.py" in (ROOT / "studies/README.md").read_text(
        encoding="utf-8"
    )

    def rates(_: float, state: list[float]) -> list[float]:
        x, y, u, v = state
        length, speed = math.hypot(x, y), math.hypot(u, v)
        pull, drag = 400.0 * (length - 1.0) / length, 0.1 + 0.05 * speed
        return [u, v, -(pull * x + drag * u) / 2.0, -(pull * y + drag * v) / 2.0 - 9.81]

    times = [frame / RATE for frame in range(1, 121)]
    start = [1.2, 0.0, 0.0, 0.0]
    exact = solve_ivp(rates, (0.0, 2.0), start, "DOP853", times, rtol=1e-12, atol=1e-12).y[:2].T
    scene = load(EXAMPLE)
    for tried in runs.explore(scene, 1e-3, lambda _: None):
        first = first_within(tried.points(scene), 1e-3)
        if first is not None:
            run = numpy.array(tried.runs[first])[:, :2]
            assert abs(run - exact).max() <= 1e-3, tried.model.name


HEAD = """
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 1.0
THROWN = Vector3(1.0), Vector3(1.0, 2.0), Vector3(0.0, -10.0)

def build():
    return ParticleWorld([Particle(*THROWN)])
"""
BALL = """
DURATION = 2.0

def build():
    ball = Particle(Vector3(0.0, 1.1), acceleration=Vector3(0.0, -10.0))
    return ParticleWorld([ball], [GroundPlane([ball], radius=0.1, restitution=0.8){}])
"""
CHAOS = """
DURATION = 20.0

def build():
    body = Particle(Vector3(0.2))
    world = ParticleWorld([body])
    for x, y in ((0, 1), (1, -1), (-1, -1)):
        world.registry.add(body, Star(Vector3(x, y)))
    return world

class Star:
    def __init__(self, center):
        self.center = center

    def update_force(self, particle, duration):
        offset = self.center - particle.position
        particle.add_force(offset * (5.0 / (offset.squared_magnitude() + 0.01) ** 1.5))
"""


def run_on(
    folder: Path,
    text: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> tuple[int, str]:
    """Return the status of the command, and what it printed in one line."""
    monkeypatch.setattr(runs, "SLOWEST", 0.01)
    monkeypatch.setattr(runs, "ROUNDS", 1)
    file = folder / "my_scene.py"
    file.write_text(HEAD + text, encoding="utf-8")
    status = choose.main([str(file)])
    return status, " ".join(capsys.readouterr().out.split())


def test_bounces_warn_that_halving_does_not_converge(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    status, told = run_on(tmp_path, BALL.format(""), monkeypatch, capsys)
    assert status == 0
    assert "cheapest: time division, once per frame" in told
    assert "Warning: errors marked ? are only guesses" in told
    # With a cable that is never taut, contacts are not those of detectors alone.
    cable = ", AnchoredCable(ball, Vector3(), 9.0)"
    status, told = run_on(tmp_path, BALL.format(cable), monkeypatch, capsys)
    assert status == 1
    assert "cheapest: no model is accurate enough with runs of up to " in told
    assert "Warning: no model converges." in told


def test_chaos_warns(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    status, told = run_on(tmp_path, CHAOS, monkeypatch, capsys)
    assert status == 1
    assert "Warning: no model converges. If the motion is chaotic, shorten DURATION" in told


def test_exact_models_are_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    status, told = run_on(tmp_path, "", monkeypatch, capsys)
    assert status == 0
    assert "exact steps" in told
    assert "error about 3e-12" in told  # 1e-12 of the lowest position, 2 - 5 = -3 m
    assert "Warning" not in told


FORCE = """
class Force:
    def update_force(self, particle, duration):
        {}

def build():
    body = Particle()
    world = ParticleWorld([body])
    world.registry.add(body, Force())
    return world
"""
BAD = {
    "build is missing. Define it as a function that returns a ParticleWorld": "del build",
    "build must be a function, got 3": "build = 3",
    "DURATION is missing. Set it to the time in s that the scene should run": "del DURATION",
    "DURATION must be a number of seconds, at least one frame of 1/60 s, got 0": "DURATION = 0",
    "DURATION must be a number of seconds, at least one frame of 1/60 s, got 'two'": (
        "DURATION = 'two'"
    ),
    "the file stopped on line 13 with SyntaxError: invalid syntax": "def (",
    "the file stopped on line 13 with ZeroDivisionError: division by zero": "1 / 0",
    "the file stopped on line 13 with SystemExit: 3": "raise SystemExit(3)",
    "build() stopped on line 13 with ValueError: mass must be positive, got -1.0": (
        "build = lambda: Particle(mass=-1.0)"
    ),
    "build() must return a ParticleWorld, got [1]": "build = lambda: [1]",
    "the world that build() returns has no particles": "build = ParticleWorld",
    "none of the measured values changes in 1 s": "build = lambda: ParticleWorld([Particle()])",
    "measure() must be finite at the start, got (nan,)": "measure = lambda _: float('nan')",
    "measure() must return a number, a Vector3, or a list of these, got 'far'": (
        "measure = lambda _: 'far'"
    ),
    "measure() returned no numbers": "measure = lambda _: []",
    "measure() must always return the same number of values": (
        "measure = lambda w: [1.0] * (1 + (w.particles[0].position.x > 1.5))"
    ),
    "build() must make new particles on every call": (
        "it = ParticleWorld([Particle()])\nbuild = lambda: it"
    ),
    "seed any random numbers": (
        "import random\nbuild = lambda: ParticleWorld([Particle(Vector3(random.random()))])"
    ),
    "explicit Euler stopped on line 16 with TypeError: force must be a Vector3": (
        FORCE.format("particle.add_force(3)")
    ),
    "no model could run the scene; ": FORCE.format("1 / 0"),
}


@pytest.mark.parametrize("message", BAD)
def test_a_bad_file_is_refused_in_a_sentence(
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit) as stopped:
        run_on(tmp_path, BAD[message], monkeypatch, capsys)
    assert stopped.value.code == 2
    told = capsys.readouterr().err
    assert "my_scene.py: " in told
    assert message in told


def test_a_file_that_is_not_there_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        choose.main(["nowhere.py"])
    assert "nowhere.py: there is no such file" in capsys.readouterr().err
