"""Find the fastest method that simulates a scene, such as a pendulum, accurately enough.

The command measures how long different models take. A model is an integrator, a closed form or a
contact solver. The report shows the fastest model whose error is small enough. For comparison, it
also shows the next faster model and its error.

Choose a built-in scene by part of its name, such as "pendulum". You can also describe a scene of
your own in a Python file, as in studies/choose/example.py. Such a scene has no exact solution, so
its error is estimated by running it again with shorter time steps.
"""

from __future__ import annotations

import argparse
import math
import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.commands import TUNED, find_engine
from autograder.text.wrapping import plain_console

if TYPE_CHECKING:
    from studies.accuracy.measure import Point
    from studies.accuracy.scene import Scene

ROUNDS, SLOWEST = 3, 0.2  # s for the slowest run of a model


def main(arguments: list[str]) -> int:
    """Print the fastest method that is accurate enough. Return 1 if a scene has none."""
    parser = argparse.ArgumentParser(prog="python -m studies choose", description=__doc__)
    parser.add_argument("scene", help="part of a scene's name, such as pendulum, or a .py file")
    largest = "largest error, as a fraction of the scene's size; for a file, in its own units"
    parser.add_argument("--tolerance", type=float, default=1e-3, help=largest)
    options = parser.parse_args(arguments)
    if not 0.0 < options.tolerance < math.inf:
        parser.error(f"--tolerance must be positive and finite, got {options.tolerance!r}")
    sys.path[:0] = map(str, find_engine(TUNED))
    # These modules import chapters.
    if options.scene.endswith(".py"):
        from studies.choose.report import choose
        from studies.choose.scene import SceneError

        try:
            return choose(Path(options.scene), options.tolerance, plain_console())
        except SceneError as error:
            parser.error(str(error))
    from scenes.clock import RATE
    from studies.accuracy import results
    from studies.accuracy.catalog import scenes_with
    from studies.accuracy.measure import measured_in
    from studies.choose.report import print_choice, print_line

    try:
        scenes = scenes_with(options.scene)
    except ValueError as error:
        parser.error(str(error))
    console = plain_console()
    measured = measured_in(console, scenes, ROUNDS, SLOWEST, SLOWEST)
    missed = False
    for scene in scenes:
        own = [point for point in measured.points if point.scene == scene.name]
        console.print(
            f"{scene.name}: {scene.frames / RATE:.3g} s, error at most {options.tolerance:g} of "
            f"the scene's size, {scene.scale:.3g} m",
            style="bold",
            soft_wrap=True,
        )
        ours, others = results.split(own)
        found, cheaper = results.cheapest(ours, options.tolerance)
        theirs, _ = results.cheapest(others, options.tolerance)
        missed |= found is None
        limit = f"with runs of up to {SLOWEST:g} s"
        none = f"none of our models is accurate enough {limit}", "none of our models is cheaper"
        told = partial(_told, scene, tolerance=options.tolerance)
        print_choice(console, found, cheaper, options.tolerance, told, none)
        text = told(theirs) if theirs else f"not accurate enough {limit}"
        if found and theirs and theirs.time < found.time:
            text += ": cheaper than all of ours"
        print_line(console, "pymunk", text)
    return 1 if missed else 0


def _told(scene: Scene, point: Point, tolerance: float) -> str:
    """Describe one timed run for the report, with its steps, time, work and error."""
    from studies.choose.report import told_beside, took  # it imports chapters

    model = next(model for model in scene.models if model.name == point.model)
    return (
        f"{point.model}, {model.chosen(point.steps)}: {took(point, scene.frames)}, "
        f"{point.work} {scene.counted}, error {told_beside(tolerance, point.error, 2)}"
    )
