"""Measure how accurate and how fast every model of every scene is.

Errors and work are the same in every run, so they are measured once, and times in several rounds.
Each round times all models in random order, so that a slowdown does not always affect the same one.
"""

from __future__ import annotations

import hashlib
import json
import math
import platform
import random
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from datetime import date
from importlib import metadata
from pathlib import Path

import pymunk  # noqa: F401 - otherwise the first run of a pymunk model would include the import
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from autograder.files import replace_bytes
from autograder.manifest import ROOT
from scenes.timing import fastest, quartiles
from studies.accuracy.scene import Model, Outcome, Scene

EXACT = 1e-13  # an error that more steps cannot reduce, because it comes from rounding
LEAST = 1e-2  # s for one measurement; a faster run is repeated
LONG, FEW = 1.0, 2  # a run that takes longer than LONG s is timed in only FEW rounds
SAVED_EVERY = 10.0  # s; an interrupted run loses at most this much of a round


@dataclass
class Point:
    """A point in a chart: the error, work and time of a model with a given number of steps."""

    scene: str
    model: str
    by: str
    steps: int  # or 1 / tolerance
    error: float
    work: int
    times: list[float] = field(default_factory=list)  # processor time in s of each round
    is_formula: bool = False

    @property
    def time(self) -> float:
        """The median processor time of the run over all timing rounds, in s."""
        return statistics.median(self.times)

    @property
    def spread(self) -> tuple[float, float]:
        """The lower and upper quartiles of the run's processor times, in s."""
        return quartiles(self.times)


@dataclass
class Measured:
    """The points so far. Those that the present round has timed have rounds + 1 times."""

    points: list[Point]
    rounds: int = 0  # finished
    day: str = ""  # of the last round


def measured_in(
    console: Console,
    scenes: Sequence[Scene],
    rounds: int,
    slowest: float,
    theirs: float,
    file: Path | None = None,
) -> Measured:
    """Measure all models in all scenes, with the limits of ``explore``, and show the progress.

    If an earlier run with the same code and limits left a ``file``, it is resumed.
    """
    sign = sign_of([scene.name for scene in scenes], slowest, theirs) if file else ""
    found = (load(file, sign) if file else None) or Measured([])
    saved = time.monotonic()

    def keep(every: float = 0.0) -> None:
        nonlocal saved
        if file and time.monotonic() - saved >= every:
            save(found, file, sign)
            saved = time.monotonic()

    def advance() -> None:
        progress.advance(task)
        keep(SAVED_EVERY)

    def hear(what: str) -> None:
        progress.update(task, description=what, advance=1)
        if hidden:
            print(what, file=sys.stderr, flush=True)

    if found.points:
        console.print(f"resuming an earlier run after {found.rounds} of {rounds} rounds")
    explored = {point.scene for point in found.points}
    new = [scene for scene in scenes if scene.name not in explored]
    left = max(rounds - found.rounds, 0)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    hidden = not console.is_terminal
    with Progress(*columns, console=console, transient=True, disable=hidden) as progress:
        task = progress.add_task("", total=sum(len(scene.models) for scene in new))
        for scene in new:
            found.points += explore(scene, slowest, theirs, hear)
            keep()
        progress.remove_task(task)
        task = progress.add_task("timing", total=left * len(found.points))
        for _ in range(left):
            time_once(found, scenes, advance)
            keep()
    return found


def explore(
    scene: Scene, slowest: float, theirs: float, hear: Callable[[str], None]
) -> list[Point]:
    """Measure the error and the work of every model of a scene, but not the times.

    The steps become shorter until only rounding is left or a run takes too long: ``theirs`` seconds
    for pymunk's models, and ``slowest`` for ours. ``hear`` gets a line of text before each model.
    """
    points = []
    for model in scene.models:
        hear(f"{scene.name}: {model.name}")
        for steps in model.steps:
            start = time.process_time()
            outcome = run(model, steps)
            taken = time.process_time() - start
            points.append(point_of(scene, model, steps, outcome))
            slow = taken > (theirs if model.by == "pymunk" else slowest)
            if slow or points[-1].error < EXACT:
                break
    return points


def point_of(scene: Scene, model: Model, steps: int, outcome: Outcome | None) -> Point:
    """Return the point of a run, whose error is infinite if the run failed."""
    error, work = (scene.error(outcome), outcome.work) if outcome else (math.inf, 0)
    names = scene.name, model.name, model.by
    return Point(*names, steps, error, work, is_formula=model.is_formula)


def run(model: Model, steps: int) -> Outcome | None:
    """Run a model with ``steps`` steps per frame. Return None if it is unstable with such steps."""
    try:
        return model.run(steps)
    except (ArithmeticError, ValueError):
        return None


def time_once(measured: Measured, scenes: Sequence[Scene], hear: Callable[[], None]) -> None:
    """Run one more timing round, or the rest of an interrupted one.

    A run that takes longer than LONG seconds is skipped after FEW rounds. ``hear`` is called after
    each run, timed or skipped.
    """
    models = {(scene.name, model.name): model for scene in scenes for model in scene.models}
    for point in random.sample(measured.points, len(measured.points)):
        is_done = len(point.times) > measured.rounds
        if not is_done and (len(point.times) < FEW or point.time < LONG):
            point.times.append(seconds_of(models[point.scene, point.model], point.steps))
        hear()
    measured.rounds += 1
    measured.day = date.today().isoformat()


def seconds_of(model: Model, steps: int) -> float:
    """Measure the processor time in s of one simulation, the fastest of several if it is short."""

    def once() -> float:
        start = time.process_time()
        run(model, steps)
        return time.process_time() - start

    return fastest(once, LEAST)


def save(measured: Measured, path: Path, sign: str) -> None:
    """Save all measurements so far, with their signature from ``sign_of``."""
    replace_bytes(path, json.dumps({"sign": sign, **asdict(measured)}).encode())


def load(path: Path, sign: str) -> Measured | None:
    """Load the measurements of an interrupted run. Return None if there are none with this sign."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        if data["sign"] != sign:
            return None
        points = [Point(**point) for point in data["points"]]
        return Measured(points, data["rounds"], data["day"])
    except (OSError, ValueError, KeyError, TypeError):
        return None


def sign_of(names: Sequence[str], slowest: float, theirs: float) -> str:
    """Compute a signature of all that affects the results: names, limits, code and versions."""
    digest = hashlib.sha256(f"{[*names]} {slowest} {theirs}".encode())
    for folder in ("solutions", "chapters", "scenes", "studies"):
        for file in sorted((ROOT / folder).rglob("*.py")):
            if file.parent != ROOT / "studies" / "charts":
                digest.update(file.read_bytes())
    versions = f"{platform.python_version()} {metadata.version('pymunk')} {platform.platform()}"
    digest.update(versions.encode())
    return digest.hexdigest()
