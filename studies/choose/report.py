"""Print the report of `make choose` on a scene that the user wrote, or on built-in scenes."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.text.wrapping import print_wrapped
from scenes.clock import RATE
from studies.accuracy.measure import Point, measured_in
from studies.accuracy.results import cheapest, first_within, split
from studies.accuracy.scene import Model, Scene
from studies.choose import models, runs
from studies.choose.doubts import contradiction, is_guess, warnings
from studies.choose.runs import Tried
from studies.choose.scene import OwnScene, load

MOST_DIGITS = 17  # of a number, enough to tell any two numbers apart


def choose(path: Path, tolerance: float, console: Console) -> int:
    """Report the fastest model whose estimated error is at most ``tolerance``.

    Return 0 if there is such a model that no other model contradicts, and 1 otherwise. Raise
    SceneError if the file does not describe a valid scene.
    """
    scene = load(path)
    with console.status("measuring") as status:
        heard: list[str] = []

        def hear(what: str, choice: str = "") -> None:
            status.update(f"{what}, {choice}" if choice else what)
            if not console.is_terminal and what not in heard:
                heard.append(what)
                print(what, file=sys.stderr, flush=True)

        found = runs.explore(scene, tolerance, hear)
        hear("timing")
        runs.time_all(scene, found, tolerance)
    console.print(
        f"{scene.path}: {scene.frames / RATE:.3g} s, error at most {tolerance:g} in every frame",
        style="bold",
        soft_wrap=True,
    )

    def told(point: Point) -> str:
        run = _run(point, [tried.model for tried in found], scene.frames)
        return f"{run}, error about {told_beside(tolerance, point.error)}"

    chosen = None
    if doubt := contradiction(found, tolerance):
        _print_line(console, "cheapest", f"unknown, because {doubt}")
    else:
        steady = [point for one in found if one.halved.is_steady for point in one.points(scene)]
        longest = max(taken for tried in found for times in tried.times for taken in times)
        none = f"no model is accurate enough with runs of up to {longest:.2g} s"
        chosen = _print_choice(console, steady, tolerance, told, (none, "no model is cheaper"))
    console.print(_table(found, scene, tolerance, is_doubtful=bool(doubt)))
    for warning in warnings(found, chosen, tolerance, is_doubtful=bool(doubt)):
        print_wrapped(console, f"Warning: {warning}", hanging=2)
    return 0 if chosen else 1


def choose_built_in(scenes: Sequence[Scene], tolerance: float, console: Console) -> int:
    """Report the fastest accurate model of each built-in scene. Return 1 if a scene has none."""
    points = measured_in(console, scenes, runs.ROUNDS, runs.SLOWEST, runs.SLOWEST).points
    chosen = [_print_built_in(scene, points, tolerance, console) for scene in scenes]
    return 0 if all(chosen) else 1


def _print_built_in(
    scene: Scene, points: list[Point], tolerance: float, console: Console
) -> Point | None:
    """Print the cheapest accurate runs of our models and of pymunk's, and return ours."""
    console.print(
        f"{scene.name}: {scene.frames / RATE:.3g} s, error at most {tolerance:g} of the scene's "
        f"size, {scene.scale:.3g} m",
        style="bold",
        soft_wrap=True,
    )
    ours, others = split([point for point in points if point.scene == scene.name])
    limit = f"with runs of up to {runs.SLOWEST:g} s"
    none = f"none of our models is accurate enough {limit}", "none of our models is cheaper"
    told = partial(told_of, scene, tolerance)
    chosen = _print_choice(console, ours, tolerance, told, none)
    theirs, _ = cheapest(others, tolerance)
    text = told(theirs) if theirs else f"not accurate enough {limit}"
    if chosen and theirs and theirs.time < chosen.time:
        text += ": cheaper than all of ours"
    _print_line(console, "pymunk", text)
    return chosen


def told_of(scene: Scene, tolerance: float, point: Point) -> str:
    """Describe a run of a built-in scene, with its steps, time, work and error."""
    run = _run(point, scene.models, scene.frames)
    return f"{run}, {point.work} {scene.counted}, error {told_beside(tolerance, point.error, 2)}"


def _print_choice(
    console: Console,
    points: list[Point],
    tolerance: float,
    told: Callable[[Point], str],
    none: tuple[str, str],
) -> Point | None:
    """Print the cheapest accurate run and a cheaper one that fails, with texts for ``none``."""
    chosen, cheaper = cheapest(points, tolerance)
    _print_line(console, "cheapest", told(chosen) if chosen else none[0])
    if chosen and cheaper:
        fails = cheaper.error > tolerance
        why = "not accurate enough" if fails else "accurate only by chance"
        _print_line(console, "cheaper, but", f"{why}: {told(cheaper)}")
    elif chosen:
        _print_line(console, "cheaper", none[1])
    return chosen


def _print_line(console: Console, title: str, text: str) -> None:
    """Print a line of the report, such as the cheapest run."""
    print_wrapped(console, f"  {title + ':':14}{text}", hanging=16)


def told_beside(tolerance: float, error: float, digits: int = 1) -> str:
    """Round an error to so many digits that it is seen whether it exceeds the tolerance.

    ``digits`` is the smallest number of digits.
    """
    for count in range(digits, MOST_DIGITS):
        told = f"{error:.{count}g}"
        if error == tolerance or (float(told) - tolerance) * (error - tolerance) > 0.0:
            return told
    return f"{error:.{MOST_DIGITS}g}"


def _run(point: Point, every: Iterable[Model | models.Model], frames: int) -> str:
    """Describe a run, its steps, and how long it took in total and for each frame on average."""
    steps = next(model.chosen(point.steps) for model in every if model.name == point.model)
    milliseconds = 1e3 * point.time
    return (
        f"{point.model}, {steps}: {milliseconds:.3g} ms ({milliseconds / frames:.2g} ms per frame)"
    )


def _table(found: list[Tried], scene: OwnScene, tolerance: float, *, is_doubtful: bool) -> Table:
    """Build the table of all models. One that is never accurate enough has its finest run there."""
    table = Table("model", "steps / frame", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("error", "ms", "order"):
        table.add_column(heading, justify="right")
    for tried in found:
        points = tried.points(scene)
        first = first_within(points, tolerance)
        point = points[-1] if first is None else points[first]
        choice = tried.model.chosen(point.steps).replace(" steps per frame", "")
        failed = "failed" if tried.runs[-1] is None else "unknown"
        mark = "? " if is_doubtful or is_guess(tried) else ""
        error = mark + told_beside(tolerance, point.error)
        table.add_row(
            tried.model.name,
            f"not with {choice}" if first is None else choice,
            error if math.isfinite(point.error) else failed,
            f"{1e3 * point.time:.3g}",
            _order(tried),
        )
    return table


def _order(tried: Tried) -> str:
    """Describe the observed order of convergence, as in "1.9 of 2" or "exact"."""
    if tried.halved.is_exact:
        return "exact"
    seen = f"{tried.halved.orders[-1]:.1f}" if tried.halved.orders else "?"
    return f"{seen} of {tried.model.order}"
