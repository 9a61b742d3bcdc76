"""Compare how fast the contact solvers of chapter 7 are on stacks of spheres and on ropes.

A heavy body that rests on a light one, or hangs from it, is hard to simulate, so each scene is run
with several mass ratios. The command prints how much time per frame each solver needs to keep the
error small. A complete run also stores its measurements, from which `make figures` draws the
picture in the lesson. If you start an interrupted run again, it resumes where it stopped.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from pathlib import Path

from matplotlib import pyplot
from rich.box import SIMPLE_HEAD
from rich.table import Table

from autograder.commands import TUNED, find_engine
from autograder.files import from_here
from autograder.manifest import ROOT
from autograder.text.wrapping import plain_console

QUICK, FULL = (1, 0.02), (3, 1.0)  # rounds, and the time in s for the slowest run of a solver


def main(arguments: list[str]) -> int:
    """Measure all contact solvers, print a table, draw the picture, and save the measurements."""
    parser = argparse.ArgumentParser(prog="python -m studies contacts", description=__doc__)
    quick = "take a minute at most: fewer steps, one round, not stored"
    parser.add_argument("--quick", action="store_true", help=quick)
    out = ROOT / "build" / "contacts"
    parser.add_argument("--out", type=Path, default=out, help="the folder for the results")
    options = parser.parse_args(arguments)
    if options.out.exists() and not options.out.is_dir():
        parser.error(f"--out must be a folder, got the file {options.out}")
    sys.path[:0] = map(str, find_engine(TUNED))
    # These modules import chapters.
    from plots.ch07_constraints.stacks import contact_solvers
    from studies.accuracy.measure import measured_in
    from studies.contacts import scenes

    pyplot.switch_backend("agg")
    console = plain_console()
    rounds, slowest = QUICK if options.quick else FULL
    options.out.mkdir(parents=True, exist_ok=True)
    file = options.out / "measured.json"
    measured = measured_in(console, scenes.scenes(), rounds, slowest, slowest, file)
    png, numbers = options.out / "contact_solvers.png", options.out / "points.json"
    scenes.keep(measured.points, numbers)
    picture = contact_solvers(numbers)
    picture.figure.savefig(png, dpi=110)
    table = Table(box=SIMPLE_HEAD, pad_edge=False, padding=(0, 1, 0, 0))
    for heading in picture.columns:
        longest = max(map(len, heading.split()))
        table.add_column(heading, no_wrap=heading == "scene", min_width=longest)
    for row in picture.rows:
        table.add_row(*map(str, row))
    console.print("Time in ms per frame that a solver needs to stay within an error for 1 s:")
    console.print(table)
    console.print("-: the longest run is not accurate enough, or the solver does not apply.")
    told = f"picture: {from_here(png)}\nall points: {from_here(numbers)}"
    if not options.quick:
        shutil.copy(numbers, scenes.FILE)
        told += f"\nWritten to {from_here(scenes.FILE)}."
        told += " Run make figures to redraw the lesson's picture."
    console.print(told, soft_wrap=True)
    return 0
