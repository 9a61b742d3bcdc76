"""Compare the speed and accuracy of our models and pymunk in every scene of the study.

The results are written to build/charts/. They consist of a page with all charts, a file with all
points, a picture of all ratios, and a table of them. A full run also updates the page and the
picture in the repository. If you start an interrupted run again, it resumes where it stopped.
"""

from __future__ import annotations

import argparse
import csv
import platform
import sys
from importlib import metadata
from itertools import repeat
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib import pyplot
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.commands import TUNED, find_engine
from autograder.files import from_here
from autograder.manifest import ROOT
from autograder.text.wrapping import plain_console

if TYPE_CHECKING:
    from studies.accuracy.measure import Measured

# The number of rounds, and the time in s for the slowest run of our models and of pymunk's. Pymunk
# gets more time, because it needs many steps to become as accurate as our models.
QUICK = (3, 0.05, 0.05)
FULL = (3, 0.3, 1.0)
COLUMNS = ("scene", "tolerance", "better model", "ours", "pymunk", "pymunk / ours")


def main(arguments: list[str]) -> int:
    """Measure how accurate and how fast every model of every scene is, and draw the charts."""
    parser = argparse.ArgumentParser(prog="python -m studies charts", description=__doc__)
    quick, out = "take four minutes: fewer points, fewer rounds", ROOT / "build" / "charts"
    parser.add_argument("--quick", action="store_true", help=quick)
    parser.add_argument("--scene", default="", help="only scenes with this text in their name")
    parser.add_argument("--out", type=Path, default=out, help="the folder for the charts")
    options = parser.parse_args(arguments)
    sys.path[:0] = map(str, find_engine(TUNED))
    # These modules import chapters.
    from studies.accuracy import results
    from studies.accuracy.catalog import scenes_with
    from studies.accuracy.measure import measured_in
    from studies.charts import page
    from studies.charts.overview import draw_overview
    from studies.charts.ratios import figures_of, precise, told, told_ratio

    pyplot.switch_backend("agg")
    try:
        scenes = scenes_with(options.scene)
    except ValueError as error:
        parser.error(str(error))
    rounds, slowest, theirs = QUICK if options.quick else FULL
    console = plain_console()
    options.out.mkdir(parents=True, exist_ok=True)
    kept = options.out / "measured.json"
    measured = measured_in(console, scenes, rounds, slowest, theirs, kept)
    for scene in scenes:
        if scene.differs:
            console.print(
                f"{scene.name}: its exact solution and our own finest run differ by "
                f"{scene.differs():.1g} of the scale"
            )
    rows = results.table(measured.points)
    draw_overview(rows, options.out / "overview.png")
    table = [
        (row.scene, row.tolerance, row.is_formula, *map(told, (row.ours, row.pymunk)), ratio)
        for row, ratio in zip(rows, map(told_ratio, figures_of(rows), repeat(precise)), strict=True)
    ]
    _print(table, console)
    if any(row.is_extrapolated for row in rows):
        console.print("~: pymunk's time is extrapolated from its measured order of convergence.")
    with (options.out / "table.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([COLUMNS, *table])
    page.write(scenes, measured.points, _how(measured, options.quick), options.out)
    said = (
        f"overview of all scenes: {from_here(options.out / 'overview.png')}\n"
        f"{rounds} rounds; all numbers: {from_here(options.out / 'table.csv')}\n"
        f"all charts on one page: {from_here(options.out / 'index.html')}"
    )
    if not options.quick and not options.scene:
        page.keep(rows, measured.day, options.out)
        files = ", ".join((page.PICTURE, page.PAGE, *page.READMES))
        said += f"\nupdated in the repository: {files}"
    console.print(said, soft_wrap=True)
    return 0


def _how(measured: Measured, is_quick: bool) -> str:
    quick = " in a quick run, with fewer steps for all models" if is_quick else ""
    versions = f"Python {platform.python_version()} and pymunk {metadata.version('pymunk')}"
    return (
        f"Measured on {measured.day}{quick}, with {versions}. Each time is the median of "
        f"{measured.rounds} rounds."
    )


def _print(rows: list[tuple[Any, ...]], console: Console) -> None:
    table = Table("scene", "error", "compared", box=SIMPLE_HEAD, pad_edge=False)
    for heading in COLUMNS[-3:]:
        table.add_column(heading, justify="right")
    for scene, tolerance, is_formula, *words in rows:
        table.add_row(scene, f"{tolerance:g}", "better model" if is_formula else "steps", *words)
    console.print(table)
