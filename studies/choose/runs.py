"""Simulate a user's scene with every model and several time steps, and time each run."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from scenes.clock import RATE
from scenes.timing import fastest
from studies.accuracy.measure import LEAST, LONG, Point
from studies.accuracy.results import first_within
from studies.choose.halving import LEAST as CONVERGING
from studies.choose.halving import Halved, Run, distance, halved
from studies.choose.models import Model, models_of
from studies.choose.scene import OwnScene, SceneError, check_forces, why

ROUNDS, SLOWEST = 3, 0.2  # s for the slowest run of a model
PATIENCE = 5  # times SLOWEST, for a model whose runs begin to converge
LONGEST = 10.0  # s for a run of a model that chooses its own steps
ORDERS = 3  # a slow model is given up only after this many orders, which takes five runs
STILL = 1e-12  # a change by less than this fraction of the measured values is only rounding


@dataclass
class Tried:
    """A simulation method that was tried on the user's scene, and the results of its runs."""

    model: Model
    runs: list[Run | None] = field(default_factory=list)
    times: list[list[float]] = field(default_factory=list)  # processor times in s
    halved: Halved = field(default_factory=lambda: Halved([], []))
    failure: str = ""  # why a run failed

    def add(self, run: Run | str, taken: float) -> None:
        """Add a run with shorter time steps, or why it failed, and update all estimated errors."""
        if isinstance(run, str):
            self.failure = run
        self.runs.append(None if isinstance(run, str) else run)
        self.times.append([taken])
        model, may_vary = self.model, self.model.takes_tolerance
        ratio = model.choices[1] / model.choices[0]
        # If even the tightest tolerance repeats the run, then the run is exact.
        repeats = may_vary and len(self.runs) < len(model.choices)
        self.halved = halved(self.runs, ratio, model.order, may_repeat=repeats, may_vary=may_vary)

    def is_enough(self, tolerance: float) -> bool:
        """Return True if the last runs are exact, or reliably within ``tolerance``."""
        found = self.halved
        within = all(error <= tolerance for error in found.errors[-3:])
        return found.is_exact or (found.is_steady and within)

    def is_too_slow(self, taken: float) -> bool:
        """Return True if the model gets no run with shorter steps after a run of ``taken`` s.

        A model whose error begins to fall may take longer. In a chaotic scene, only short steps
        show the order.
        """
        found = self.halved
        if taken <= SLOWEST or len(found.orders) < ORDERS:
            return False
        is_promising = not found.is_steady and found.orders[-1] >= CONVERGING
        return not (is_promising and taken <= PATIENCE * SLOWEST)

    def points(self, scene: OwnScene) -> list[Point]:
        """Convert the runs to points of the accuracy study. Their work is the number of steps."""
        start = str(scene.path), self.model.name, "ours"
        runs = zip(self.model.choices, self.halved.errors, self.times, strict=False)
        return [Point(*start, n, error, n * scene.frames, times) for n, error, times in runs]


def explore(scene: OwnScene, tolerance: float, hear: Callable[[str, str], None]) -> list[Tried]:
    """Simulate the scene with each model, and shorten the time step until the error is small.

    ``hear`` is called with the model and its steps before each run. Raise SceneError if the scene
    cannot be run, a force has a memory, or none of the measured values changes.
    """
    start = scene.check()
    check_forces(scene)
    found = []
    for model in models_of(scene.built()):
        tried = Tried(model)
        for choice in model.choices:
            hear(model.name, model.chosen(choice))
            run, taken = run_once(scene, model, choice)
            if isinstance(run, str) and taken > LONGEST and tried.runs:
                break  # what the model has done with larger tolerances still counts
            tried.add(run, taken)
            if tried.is_enough(tolerance) or tried.is_too_slow(taken):
                break
        found.append(tried)
    runs = [run for tried in found for run in tried.runs if run is not None]
    if not runs:
        raise SceneError(f"no model could run the scene; {found[-1].failure}")
    size = max(map(abs, start))
    if all(distance(run, [start] * scene.frames) <= STILL * size for run in runs):
        raise SceneError(f"none of the measured values changes in {scene.frames / RATE:g} s")
    return found


def run_once(scene: OwnScene, model: Model, choice: int) -> tuple[Run | str, float]:
    """Simulate the scene once, and return the values after every frame, and the time in s.

    If the motion explodes, a message replaces the values. Any other exception in the user's code
    becomes a SceneError.
    """
    world, values = scene.built(), []
    start = time.process_time()
    try:
        step, steps = model.steps_of(world, choice)
        duration = 1.0 / (RATE * steps)
        for _ in range(scene.frames):
            for _ in range(steps):
                step(duration)
            values.append(scene.measured(world))
            if model.takes_tolerance and time.process_time() - start > LONGEST:
                raise ArithmeticError(f"the run is not finished after {LONGEST:g} s")
    except SceneError:
        raise
    except (ArithmeticError, ValueError) as error:
        return f"{model.name} {why(error, scene.path)}", time.process_time() - start
    except Exception as error:
        raise SceneError(f"{model.name} {why(error, scene.path)}") from error
    taken = time.process_time() - start
    if not all(math.isfinite(value) for place in values for value in place):
        return f"{model.name} produced numbers that are not finite", taken
    if any(len(place) != len(values[0]) for place in values):
        raise SceneError("measure() must always return the same number of values")
    return values, taken


def time_all(scene: OwnScene, found: Sequence[Tried], tolerance: float) -> None:
    """Repeat the runs that the report may choose from, in several rounds of random order."""
    every = []
    for tried in found:
        if tried.halved.is_steady:
            points = tried.points(scene)
            first = first_within(points, tolerance)
            last = None if first is None else first + 1
            every += [(tried.model, point) for point in points[:last]]
    for _ in range(ROUNDS):
        for model, point in random.sample(every, len(every)):
            if point.times[0] < LONG:
                point.times.append(seconds_of(scene, model, point.steps))


def seconds_of(scene: OwnScene, model: Model, choice: int) -> float:
    """Measure the processor time of a run in s."""
    return fastest(lambda: run_once(scene, model, choice)[1], LEAST)
