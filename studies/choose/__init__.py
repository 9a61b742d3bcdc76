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
from pathlib import Path

from autograder.commands import TUNED, find_engine
from autograder.text.wrapping import plain_console


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
    from studies.choose import report  # it imports chapters
    from studies.choose.scene import SceneError

    console, file = plain_console(), Path(options.scene)
    if options.scene.endswith(".py"):
        try:
            return report.choose(file, options.tolerance, console)
        except SceneError as error:
            parser.error(f"{file}: {error}")
    from studies.accuracy.catalog import scenes_with

    try:
        scenes = scenes_with(options.scene)
    except ValueError as error:
        parser.error(str(error))
    return report.choose_built_in(scenes, options.tolerance, console)
