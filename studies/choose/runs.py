"""Simulate a user's scene with every model and several time steps, and time each run.

A model is a simulation method, such as an integrator.
"""

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
from studies.choose.clocks import check_forces
from studies.choose.halving import LEAST as CONVERGING
from studies.choose.halving import Halved, Run, distance, halved
from studies.choose.models import Model, models_of
from studies.choose.scene import OwnScene, SceneError, why

ROUNDS, SLOWEST = 3, 0.2  # s for the slowest run of a model
PATIENCE = 5  # times SLOWEST, for a model whose runs begin to converge
LONGEST = 10.0  # s for a run of a model that chooses its own steps
ORDERS = 3  # a slow model is given up only after this many orders, which takes five runs
STILL = 1e-12  # a change by less than this fraction of the measured values is only rounding


@dataclass
class Tried:
    """A simulation method that was tried on the user's scene, and the results of its runs.

    ``runs`` contains the values measured in each run, and ``times`` contains the processor times of
    each run in s. ``halved`` contains the errors, which are estimated by comparing runs with
    different time steps. If a run failed, ``failure`` says why.
    """

    model: Model
    runs: list[Run | None] = field(default_factory=list)
    times: list[list[float]] = field(default_factory=list)
    halved: Halved = field(default_factory=lambda: Halved([], []))
    failure: str = ""

    def add(self, run: Run | str, taken: float) -> None:
        """Add the result of a run with shorter time steps, and update all estimated errors.

        ``run`` contains the measured values, or a message that says why the run failed. ``taken``
        is the processor time of the run in s.
        """
        if isinstance(run, str):
            self.failure = run
        self.runs.append(None if isinstance(run, str) else run)
        self.times.append([taken])
        model = self.model
        ratio = model.choices[1] / model.choices[0]
        # If even the tightest tolerance repeats the run, then the run is exact.
        may_repeat = model.takes_tolerance and len(self.runs) < len(model.choices)
        self.halved = halved(
            self.runs,
            ratio,
            model.order,
            may_repeat=may_repeat,
            may_vary=model.takes_tolerance,
        )

    def is_enough(self, tolerance: float) -> bool:
        """Return True if the model does not need another run with shorter time steps.

        No further run is needed if the last runs are exact, or if the error is known to be small
        enough. In the second case, the estimates must be reliable, and the last three must be
        within ``tolerance``.
        """
        found = self.halved
        within = all(error <= tolerance for error in found.errors[-3:])
        return found.is_exact or (found.is_steady and within)

    def is_too_slow(self, taken: float) -> bool:
        """Return True if the model gets no run with shorter steps after a run of ``taken`` s.

        If the error falls at last, but not yet at a steady rate, the model may take longer. In a
        chaotic scene, the long steps are useless, and only short ones show the order.
        """
        found = self.halved
        if taken <= SLOWEST or len(found.orders) < ORDERS:
            return False
        is_promising = not found.is_steady and found.orders[-1] >= CONVERGING
        return not (is_promising and taken <= PATIENCE * SLOWEST)

    def points(self, scene: OwnScene) -> list[Point]:
        """Convert the runs to points, so that they can be compared as in the accuracy study.

        The ``work`` of a point is its number of time steps.
        """
        return [
            Point(
                str(scene.path),
                self.model.name,
                "ours",
                choice,
                error,
                choice * scene.frames,
                times,
            )
            for choice, error, times in zip(
                self.model.choices, self.halved.errors, self.times, strict=False
            )
        ]


def explore(scene: OwnScene, tolerance: float, hear: Callable[[str], None]) -> list[Tried]:
    """Simulate the scene with each model, and shorten the time step until the error is small.

    If a run takes longer than SLOWEST, the model gets no further runs, unless they are needed to
    judge its order of convergence. ``hear`` is called before each run with a description of the
    run, so that the caller can show the progress.

    Raises:
        SceneError: The scene cannot be run, a force has a memory, or none of the measured values
            changes.
    """
    start = scene.check()
    check_forces(scene)
    found = []
    for model in models_of(scene.built()):
        tried = Tried(model)
        for choice in model.choices:
            hear(f"{model.name}, {model.chosen(choice)}")
            run, taken = run_once(scene, model, choice)
            if isinstance(run, str) and taken > LONGEST and tried.runs:
                break  # what the model has done with larger tolerances still counts
            tried.add(run, taken)
            if tried.is_enough(tolerance) or tried.is_too_slow(taken):
                break
        found.append(tried)
    runs = [run for tried in found for run in tried.runs if run is not None]
    if not runs:
        raise SceneError(f"{scene.path}: no model could run the scene; {found[-1].failure}")
    size = max(map(abs, start))
    if all(distance(run, [start] * scene.frames) <= STILL * size for run in runs):
        seconds = scene.frames / RATE
        raise SceneError(f"{scene.path}: none of the measured values changes in {seconds:g} s")
    return found


def run_once(scene: OwnScene, model: Model, choice: int) -> tuple[Run | str, float]:
    """Simulate the scene once with one model, and record the measured values after every frame.

    A run fails if a value is not finite, or if an arithmetic error shows that the motion explodes.

    Returns:
        A tuple of the recorded values and the processor time in s. If the run failed, the first
        item is a message that says why.

    Raises:
        SceneError: The user's code raises an exception of any other kind.
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
        raise SceneError(f"{scene.path}: {model.name} {why(error, scene.path)}") from error
    taken = time.process_time() - start
    if not all(math.isfinite(value) for place in values for value in place):
        return f"{model.name} produced numbers that are not finite", taken
    if any(len(place) != len(values[0]) for place in values):
        raise SceneError(f"{scene.path}: measure() must always return the same number of values")
    return values, taken


def time_all(scene: OwnScene, found: Sequence[Tried], tolerance: float) -> None:
    """Repeat the runs that the report may choose from, to measure their times more accurately.

    For each model with reliable errors, these are all runs up to the first one that is accurate
    enough. They are repeated in several rounds, each in random order. If the computer is busy for a
    moment, this affects several models rather than only one.
    """
    every = []
    for tried in found:
        if tried.halved.is_steady:
            points = tried.points(scene)
            first = first_within(points, tolerance)
            every += [
                (tried.model, point) for point in points[: None if first is None else first + 1]
            ]
    for _ in range(ROUNDS):
        for model, point in random.sample(every, len(every)):
            if point.times[0] < LONG:
                point.times.append(seconds_of(scene, model, point.steps))


def seconds_of(scene: OwnScene, model: Model, choice: int) -> float:
    """Measure the processor time of a run in s, that of the fastest of several if it is short."""
    return fastest(lambda: run_once(scene, model, choice)[1], LEAST)
