"""Measure every model of some scenes: its error and work once, its time in turn with all others.

The times of a round are taken in shuffled order, so that what else the machine does hits no model
alone. What is measured is kept in a file after every round, and a run that was stopped goes on
where it was, as long as code and versions are the same.
"""

from __future__ import annotations

import hashlib
import json
import math
import platform
import random
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from importlib import metadata
from pathlib import Path

import pymunk  # noqa: F401 - else the first run of a model of pymunk's would pay for the import

from autograder.manifest import ROOT
from studies.accuracy.scene import Model, Outcome, Scene
from studies.timing import quartiles

EXACT = 1e-13  # an error that more steps cannot lower: rounding
LEAST = 2e-3  # s for one measurement: what is faster is run several times
LONG, FEW = 1.0, 2  # s: what takes longer is timed in the first two rounds alone


@dataclass
class Point:
    """A model of a scene, with one of its choices. ``times`` are in s, of the rounds it is in.

    ``steps`` is the choice: steps a frame, or 1 / tolerance for a model that takes a tolerance.
    """

    scene: str
    model: str
    by: str
    steps: int
    error: float
    work: int
    times: list[float] = field(default_factory=list)

    @property
    def time(self) -> float:
        """The median of the rounds."""
        return statistics.median(self.times)

    @property
    def spread(self) -> tuple[float, float]:
        """The quartiles of the rounds."""
        return quartiles(self.times)


@dataclass
class Measured:
    """All points of a run, and how many rounds of times they have."""

    points: list[Point]
    rounds: int = 0


def explore(
    scenes: Sequence[Scene], slowest: float, theirs: float, hear: Callable[[str], None]
) -> Measured:
    """Return the points of these scenes, without times: error and work of each model.

    A model is not asked for more steps once a run takes ``slowest`` s, or ``theirs`` if it is
    pymunk's, nor once it is exact.
    """
    points = []
    for scene in scenes:
        for model in scene.models:
            hear(f"{scene.name}: {model.name}")
            for steps in model.steps:
                start = time.process_time()
                outcome = run(model, steps)
                taken = time.process_time() - start
                error, work = (scene.error(outcome), outcome.work) if outcome else (math.inf, 0)
                points.append(Point(scene.name, model.name, model.by, steps, error, work))
                if taken > (theirs if model.by == "pymunk" else slowest) or error < EXACT:
                    break
    return Measured(points)


def run(model: Model, steps: int) -> Outcome | None:
    """Run a model; None where it breaks off, as steps that are too long make it."""
    try:
        return model.run(steps)
    except (ArithmeticError, ValueError):
        return None


def time_once(measured: Measured, scenes: Sequence[Scene], hear: Callable[[], None]) -> None:
    """Add a round of times to all points, in shuffled order."""
    models = {(scene.name, model.name): model for scene in scenes for model in scene.models}
    for point in random.sample(measured.points, len(measured.points)):
        if len(point.times) < FEW or point.time < LONG:
            point.times.append(seconds_of(models[point.scene, point.model], point.steps))
        hear()
    measured.rounds += 1


def seconds_of(model: Model, steps: int) -> float:
    """Return the processor time of a run in s, of several where one is short."""
    count = 0
    start = time.process_time()
    while (taken := time.process_time() - start) < LEAST or not count:
        run(model, steps)
        count += 1
    return taken / count


def save(measured: Measured, path: Path, sign: str) -> None:
    """Keep what is measured, all or nothing, with what it was measured of."""
    data = {"sign": sign, "rounds": measured.rounds, "points": [*map(asdict, measured.points)]}
    part = path.with_suffix(".part")
    part.write_text(json.dumps(data), encoding="utf-8")
    part.replace(path)


def load(path: Path, sign: str) -> Measured | None:
    """Return what was kept, or None where there is nothing, or it is of other code or versions."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        if data["sign"] != sign:
            return None
        return Measured([Point(**point) for point in data["points"]], data["rounds"])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def sign_of(names: Sequence[str], slowest: float, theirs: float) -> str:
    """Return what stands for these scenes, all code that they run, and the versions."""
    digest = hashlib.sha256(f"{[*names]} {slowest} {theirs}".encode())
    for folder in ("solutions", "chapters", "studies"):
        for file in sorted((ROOT / folder).rglob("*.py")):
            digest.update(file.read_bytes())
    versions = f"{platform.python_version()} {metadata.version('pymunk')} {platform.platform()}"
    digest.update(versions.encode())
    return digest.hexdigest()
