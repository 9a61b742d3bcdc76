"""Find the spring stiffness and the drag at which each integrator becomes unstable.

The limits are found by bisection and compared with theory. For a spring just beyond a limit, the
command computes how many time steps an oscillation takes to grow by a factor of a million. For a
spring well below the limits, it measures how the energy changes over ten thousand oscillations.

It also draws two pictures. One maps the growth of oscillations around the limits, and the other
shows how soon a simulation diverges beyond them.
"""

from __future__ import annotations

import argparse
import csv
import math
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from matplotlib import pyplot
from rich.box import SIMPLE_HEAD
from rich.table import Table

from autograder.commands import find_engine
from autograder.files import from_here
from autograder.manifest import ROOT
from autograder.text.wrapping import plain_console

if TYPE_CHECKING:
    from studies.limits.search import Bound

SWINGS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000]
WORST = 0.05  # largest relative error allowed for a limit


def main(arguments: list[str]) -> int:
    """Print the stability limits, and save them as a CSV file and two pictures.

    Return 1 if a limit differs by more than 5 % from theory, and 0 otherwise.
    """
    parser = argparse.ArgumentParser(prog="python -m studies limits", description=__doc__)
    told = "the file for the numbers; the pictures are written next to it"
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "limits.csv", help=told)
    out: Path = parser.parse_args(arguments).out
    sys.path[:0] = map(str, find_engine("solutions"))
    # These modules import chapters.
    from studies.limits import maps, search

    pyplot.switch_backend("agg")
    console = plain_console()
    with console.status("finding the limits of springs"):
        springs = search.spring_limits()
    with console.status("finding the limits of drag"):
        drags = search.drag_limits()
    with console.status(f"simulating {SWINGS[-1]} oscillations"):
        drifts = search.energy_drifts(SWINGS)
    with console.status("simulating unstable springs"):
        losses = maps.divergence()
    rows: list[Sequence[object]] = []
    for bounds, what in ((springs, "k h^2 / m"), (drags, "k1 h / m")):
        console.print(_table(bounds, what))
        rows += [("method", "case", f"limit of {what}", "theory", "steps to x 1e6"), *bounds]
    table = Table("method", f"energy after {SWINGS[-1]} oscillations", box=SIMPLE_HEAD)
    for name, ratios in drifts.items():
        table.add_row(name, f"{ratios[-1]:.6g}")
    console.print(table)
    rows.append(("method", *(f"energy after {count} oscillations" for count in SWINGS)))
    rows += [(name, *ratios) for name, ratios in drifts.items()]
    out.parent.mkdir(parents=True, exist_ok=True)
    with out.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([*rows, maps.LOSS_COLUMNS, *losses])
    picture, curves = out.with_suffix(".png"), out.with_name(f"{out.stem}_divergence.png")
    with console.status("drawing maps"):
        maps.draw_maps(picture)
    maps.draw_divergence(losses, drifts, SWINGS, curves)
    console.print(
        f"The column 'steps' shows how many steps an oscillation at {search.OUTSIDE} times the\n"
        "limit takes to grow by a factor of 1e6. A limit of 0 means that oscillations\n"
        f"grow even at {search.LEAST:g}.\n"
        f"Energies are relative to the initial energy, at k h^2 / m = {search.KAPPA:.3g},\n"
        "where explicit Euler is unstable.\n"
        f"\nMaps: {from_here(picture)}\nTime to divergence, energies: {from_here(curves)}\n"
        f"All numbers: {from_here(out)}",
        soft_wrap=True,
    )
    every = (*springs, *drags)
    off = [one for one in every if not math.isclose(one.found, one.theory, rel_tol=WORST)]
    for one in off:
        console.print(f"differs from theory by more than 5 %: {one.method}, {one.at}")
    return 1 if off else 0


def _table(bounds: list[Bound], what: str) -> Table:
    headings = ("method", "case", "limit", "theory", "error, %", "steps")
    table = Table(*headings, title=f"Limits of {what}", box=SIMPLE_HEAD, pad_edge=False)
    for name, at, found, true, steps in bounds:
        off = f"{100.0 * (found / true - 1.0):.1g}" if 0.0 < true < math.inf else ""
        reached = "over 1e6" if found == math.inf else f"{found:.6g}"
        wanted = "none" if true == math.inf else f"{true:.6g}"
        table.add_row(name, at, reached, wanted, off, "" if math.isnan(steps) else f"{steps:.0f}")
    return table
