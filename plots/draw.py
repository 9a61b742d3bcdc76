"""Draw the plots of a chapter with a student's engine, as PNG and CSV files in build/plots/.

The plots of each chapter are functions in a module of plots/, which lists them as PLOTS. If a
plot takes longer than TIME_LIMIT, the program ends, and says where the engine was then.
"""

from __future__ import annotations

import argparse
import csv
import importlib
import importlib.util
from collections.abc import Callable
from pathlib import Path

from matplotlib import pyplot

from autograder.files import from_here
from autograder.manifest import ROOT, Chapter, select_chapters, split_given
from plots.drawing import Picture
from scenes.engine import add_engine_options, use_engine
from scenes.reason import reason, time_limit

TIME_LIMIT = 120.0  # s for one plot, which takes a few seconds, or longer with a slow resolver


def main(arguments: list[str]) -> int:
    """Draw the plots of the given chapters, and return 1 if a plot could not be drawn."""
    parser = argparse.ArgumentParser(prog="python -m plots draw", description=__doc__)
    parser.add_argument("--chapter", default="", help="chapters such as 2 or 2-4 (default: all)")
    add_engine_options(parser)
    parser.add_argument(
        "--out", type=Path, default=ROOT / "build" / "plots", help="the folder for the plots"
    )
    options = parser.parse_args(arguments)
    use_engine(parser, options.engine, options.given)
    try:
        _, chapters = split_given(select_chapters(options.chapter), options.given)
    except ValueError as error:
        parser.error(str(error))
    drawn = [draw_chapter(chapter, options.out / chapter.name) for chapter in chapters]
    if pyplot.get_backend().lower() != "agg":  # matplotlib has found a display
        pyplot.show()
    return 0 if all(drawn) else 1


def draw_chapter(chapter: Chapter, folder: Path) -> bool:
    """Draw all plots of a chapter, and return True if none of them failed."""
    if importlib.util.find_spec(f"plots.{chapter.name}") is None:
        print(f"chapter {chapter.number} has no plots")
        return True
    try:
        with time_limit(TIME_LIMIT):
            plots = plots_of(chapter.name)
    except (Exception, SystemExit) as error:
        print(f"chapter {chapter.number} cannot be drawn: {reason(error)}")
        return False
    folder.mkdir(parents=True, exist_ok=True)
    drawn = [draw(plot, folder) for plot in plots.values()]
    return all(drawn)


def plots_of(chapter: str, listed: str = "PLOTS") -> dict[str, Callable[[], Picture]]:
    """Import the plots that a chapter's module lists under a name, and return them by name."""
    found = getattr(importlib.import_module(f"plots.{chapter}"), listed, ())
    return {plot.__name__: plot for plot in found}


def draw(plot: Callable[[], Picture], folder: Path, limit: float = TIME_LIMIT) -> bool:
    """Draw a plot within ``limit`` s, save it as PNG and CSV, and return False if it fails."""
    name = plot.__name__
    png, table = folder / f"{name}.png", folder / f"{name}.csv"
    for older in (png, table):  # so that nobody mistakes them for the new plot
        older.unlink(missing_ok=True)
    print(f"{name}: ", end="", flush=True)  # printed first, so that a plot that never ends is named
    try:
        with time_limit(limit):
            picture = plot()
            picture.figure.savefig(png, dpi=110)
    except (Exception, SystemExit) as error:
        png.unlink(missing_ok=True)
        print(f"not drawn, {reason(error)}")
        return False
    with table.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([picture.columns, *picture.rows])
    print(f"{from_here(png)} and {from_here(table)}")
    return True
