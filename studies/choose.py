"""Choose the cheapest model of a scene that meets a tolerance, by measuring every model.

The next cheaper model is named too, with its error. Model no more than a scene needs.
"""

from __future__ import annotations

import argparse
import math
import sys
from typing import TYPE_CHECKING

from rich.console import Console

from autograder.manifest import ROOT

if TYPE_CHECKING:
    from studies.accuracy.measure import Point
    from studies.accuracy.scene import Scene

ROUNDS, SLOWEST = 3, 0.2  # s for the slowest run of a model


def main(arguments: list[str]) -> int:
    """Measure and report. Return 1 if no model of ours meets the tolerance."""
    parser = argparse.ArgumentParser(prog="python -m studies choose", description=__doc__)
    parser.add_argument("scene", help="a part of a scene's name, such as pendulum")
    parser.add_argument(
        "--tolerance", type=float, default=1e-3, help="the error that is allowed, of the scale"
    )
    options = parser.parse_args(arguments)
    if not 0.0 < options.tolerance < math.inf:
        parser.error(f"--tolerance must be positive and finite, got {options.tolerance!r}")
    sys.path[:0] = [str(ROOT / "solutions"), str(ROOT / "chapters")]
    # These import chapters.
    from studies.accuracy import measure, results
    from studies.accuracy.catalog import scenes_with
    from studies.accuracy.scene import RATE

    try:
        scenes = scenes_with(options.scene)
    except ValueError as error:
        parser.error(str(error))
    console = Console(highlight=False)
    with console.status("measuring") as status:
        measured = measure.explore(scenes, SLOWEST, SLOWEST, status.update)
        for done in range(ROUNDS):
            status.update(f"timing, round {done + 1} of {ROUNDS}")
            measure.time_once(measured, scenes, lambda: None)
    missed = False
    for scene in scenes:
        own = [point for point in measured.points if point.scene == scene.name]
        console.print(
            f"{scene.name}: {scene.frames / RATE:.3g} s, to {options.tolerance:g} of its scale of "
            f"{scene.scale:.3g} m",
            style="bold",
            soft_wrap=True,
        )
        ours, others = results.split(own)
        found, cheaper = results.cheapest(ours, options.tolerance)
        theirs, _ = results.cheapest(others, options.tolerance)
        missed |= found is None
        for title, point, none in (
            ("cheapest", found, "no model of ours meets it within the time that was tried"),
            ("next cheaper", cheaper, "nothing is cheaper"),
            ("pymunk", theirs, "does not meet it within the time that was tried"),
        ):
            told = _told(scene, point) if point else none
            if point and point is cheaper:
                told += ": fails" if point.error > options.tolerance else ": by luck"
            console.print(f"  {title + ':':14}{told}", soft_wrap=True)
    return 1 if missed else 0


def _told(scene: Scene, point: Point) -> str:
    """Describe a point of the chart: the model, its cost and its error."""
    model = next(model for model in scene.models if model.name == point.model)
    steps = "once" if point.steps == 1 else f"{point.steps} steps"
    choice = f"tolerance {1.0 / point.steps:g}" if model.takes_tolerance else f"{steps} a frame"
    return (
        f"{point.model}, {choice}: {1e3 * point.time:.3g} ms, {point.work} "
        f"{scene.counted}, error {point.error:.2g}"
    )
