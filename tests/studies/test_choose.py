"""`make choose`: what it says of a reader's scene, of a bad file and of built-in scenes."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from ch05_forces.particle import Particle
from ch08_mass_aggregate.world import ParticleWorld
from studies import choose
from studies.accuracy.catalog import scenes_with
from studies.accuracy.measure import Point
from studies.choose import runs
from studies.choose.models import models_of
from studies.choose.report import told_beside, told_of
from studies.choose.scene import load

FOLDER = ROOT / "studies/choose"
Tell = Callable[..., tuple[int, str]]

HEAD = """
import math
import random
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
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
WIND = """
DURATION = 0.5

def build():
    body = Particle()
    world = ParticleWorld([body])
    world.registry.add(body, AnchoredSpring(Vector3(), 4.0, 0.0))
    world.registry.add(body, Wind())
    return world

class Wind:
    time, last = 0.0, None

    def update_force(self, particle, duration):
        {}
        particle.add_force(Vector3(force))
"""
CLOCK = WIND.format("force, self.time = 10.0 * math.sin(3.0 * self.time), self.time + duration")
LATE = WIND.format("force, self.time = 1.0 + (self.time > 0.4), self.time + duration")
RANDOM = WIND.format("force = random.random()")
# This clock stands still while the particle does, so that it is not found before the runs.
HIDDEN = WIND.format("""force = 10.0 * math.cos(3.0 * self.time)
        if self.last not in (None, particle.position.x):
            self.time += duration
        self.last = particle.position.x""")
MEMORY = "Wind gave different forces, although no particle had moved. "
GUESSES = "Warning: errors marked ? are only guesses"
# What the command prints about a file, and its exit status.
TOLD = [
    ("", 0, ["exact steps", "error about 3e-12"]),  # 1e-12 of the lowest position, 2 - 5 = -3 m
    (BALL.format(""), 0, ["cheapest: time division, once per frame", GUESSES]),
    # With a cable that is never taut, contacts are not those of detectors alone.
    (
        BALL.format(", AnchoredCable(ball, Vector3(), 9.0)"),
        1,
        [
            "cheapest: no model is accurate enough with runs of up to ",
            "Warning: no model converges.",
        ],
    ),
    (CHAOS, 1, ["Warning: no model converges. If the motion is chaotic, shorten DURATION"]),
    *(
        (text, 2, [f"my_scene.py: {MEMORY}", "as in studies/choose/example_driven.py"])
        for text in (CLOCK, LATE, RANDOM)
    ),
]
# Lines that make a file bad, and what is said of it.
BAD = {
    "del build": "build is missing. Define it as a function that returns a ParticleWorld",
    "DURATION = 0": ("DURATION must be a number of seconds, at least one frame of 1/60 s, got 0"),
    "def (": "the file stopped on line 16 with SyntaxError: invalid syntax",
    "raise SystemExit(3)": "the file stopped on line 16 with SystemExit: 3",
    "build = lambda: Particle(mass=-1.0)": (
        "build() stopped on line 16 with ValueError: mass must be positive, got -1.0"
    ),
    "build = lambda: [1]": "build() must return a ParticleWorld, got [1]",
    "build = ParticleWorld": "the world that build() returns has no particles",
    "build = lambda: ParticleWorld([Particle()])": "none of the measured values changes in 1 s",
    "measure = lambda _: float('nan')": "measure() must be finite at the start, got (nan,)",
    "measure = lambda w: [1.0] * (1 + (w.particles[0].position.x > 1.5))": (
        "measure() must always return the same number of values"
    ),
    "it = ParticleWorld([Particle()])\nbuild = lambda: it": (
        "build() must make new particles on every call"
    ),
    "build = lambda: ParticleWorld([Particle(Vector3(random.random()))])": (
        "seed any random numbers"
    ),
    WIND.format("force = Vector3()"): (
        "explicit Euler stopped on line 31 with TypeError: float() argument must be"
    ),
    WIND.format("1 / 0"): "no model could run the scene; ",
}


@pytest.fixture
def tell(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Tell:
    """Return a function that runs the command on a file, with its status and its text."""
    monkeypatch.setattr(runs, "SLOWEST", 0.01)
    monkeypatch.setattr(runs, "ROUNDS", 1)

    def run(text: str, *options: str) -> tuple[int, str]:
        file = tmp_path / "my_scene.py"
        file.write_text(HEAD + text, encoding="utf-8")
        try:
            status = choose.main([*(options or [str(file)])])
        except SystemExit as stopped:
            status = int(stopped.code or 0)
        told = capsys.readouterr()
        return status, " ".join((told.out + told.err).split())

    return run


@pytest.mark.parametrize(("text", "status", "words"), TOLD)
def test_a_scene_is_answered_with_reasons(
    text: str, status: int, words: list[str], tell: Tell
) -> None:
    found, told = tell(text)
    assert found == status
    assert [each for each in words if each not in told] == [], told
    assert status == 2 or told.endswith(" timing"), "into a pipe, progress goes to stderr"
    assert ("Warning" in told) == any("Warning" in each for each in words)


@pytest.mark.parametrize("text", BAD)
def test_a_bad_file_is_refused_in_a_sentence(text: str, tell: Tell) -> None:
    status, told = tell(text)
    assert status == 2
    assert "my_scene.py: " in told
    assert BAD[text] in told


def test_models_that_contradict_each_other_are_not_called_accurate(
    tell: Tell, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock is right if a step calls it once, and runs faster in Verlet and Runge-Kutta."""
    made = ParticleWorld([Particle()])
    made.registry.add(
        made.particles[0], load(FOLDER / "example_driven.py").build().registry.pairs()[0][1]
    )
    two = [model for model in models_of(made) if model.name in ("leapfrog", "Runge-Kutta 4")]
    monkeypatch.setattr(runs, "models_of", lambda _: two)
    monkeypatch.setattr(runs, "SLOWEST", 1.0)
    status, told = tell(HIDDEN)
    assert status == 1
    says = "cheapest: unknown, because the models disagree: leapfrog and Runge-Kutta 4 differ by "
    gap, mine, other = re.findall(
        rf"{says}(\S+), but by their own estimates their errors are only (\S+) and (\S+)\. ", told
    )[0]
    assert 0.05 < float(gap) < 10.0
    assert max(float(mine), float(other)) < 1e-3
    assert "cheaper, but" not in told
    assert len(re.findall(r"\? 0\.000\d+ ", told)) == 2  # the errors of both are marked
    assert "Check that every force depends only on the current state of the particles." in told


def test_the_example_with_links_shows_that_the_resolver_fails_and_a_net_does_not(
    tell: Tell, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The resolver corrects one rod at a time, and 20 kg hang on 1 kg."""
    monkeypatch.setattr(runs, "SLOWEST", 0.02)
    status, told = tell("", str(FOLDER / "example_links.py"), "--tolerance", "1e-2")
    assert status == 0
    assert re.search(r"cheapest: (direct|smooth) net, ", told)
    assert GUESSES in told


def test_the_cheapest_built_in_model_that_will_do_is_named_with_one_that_will_not(
    tell: Tell,
) -> None:
    status, told = tell("", "elastic", "--tolerance", "1e-5")
    assert status == 0
    assert told.startswith("elastic pendulum: 2 s, error at most 1e-05 of the scene's size")
    # Which model is the cheapest depends on the machine.
    found = re.search(r"cheapest: .* cheaper, but: (.*?): .* pymunk: (.*)", told)
    assert found
    assert found[1] in ("not accurate enough", "accurate only by chance")
    assert found[2].startswith(("pymunk at its best", "not accurate enough"))
    progress = "elastic pendulum: pymunk at its best, from two runs"  # on stderr, into a pipe
    assert told.endswith(progress)
    status, told = tell("", "k = 100 ", "--tolerance", "1e-20")
    assert status == 1
    assert "cheapest: none of our models is accurate enough" in told


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["rope", "--tolerance", "0"], "must be positive and finite"),
        (["rope", "--tolerance", "nan"], "must be positive and finite"),
        (["nowhere.py"], "nowhere.py: there is no such file"),
    ],
)
def test_a_mistake_on_the_command_line_is_refused(
    options: list[str], words: str, tell: Tell
) -> None:
    status, told = tell("", *options)
    assert status == 2
    assert words in told


def test_a_run_is_told_with_its_tolerance_or_its_frames() -> None:
    (orbit,) = scenes_with("orbit of eccentricity 0.9")
    point = Point(orbit.name, "adaptive", "ours", 10**6, 3e-5, 834, [1e-3])
    told = told_of(orbit, 1e-4, point)
    assert told.startswith("adaptive, tolerance 1e-06: 1 ms")
    assert "834 evaluations" in told
    (scene,) = scenes_with("double pendulum")
    model = next(model for model in scene.models if model.per > 1)
    point = Point(scene.name, model.name, "ours", 3, 4e-4, 240, [1e-3])
    assert f"{model.name}, 3 steps per {model.per} frames: " in told_of(scene, 1e-3, point)
    once = replace(point, steps=1)
    assert f"{model.name}, once per {model.per} frames: " in told_of(scene, 1e-3, once)


@pytest.mark.parametrize(
    ("tolerance", "error", "told"),
    [
        (1e-3, 4e-4, "0.0004"),
        (1e-3, 0.001004, "0.001004"),
        (1e-3, 1e-3, "0.001"),
        (1.5e-3, 0.00144, "0.001"),
        (1e-3, 0.0010000000000000002, "0.0010000000000000002"),
    ],
)
def test_an_error_is_not_rounded_to_the_tolerance(
    tolerance: float, error: float, told: str
) -> None:
    assert told_beside(tolerance, error) == told
