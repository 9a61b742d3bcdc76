"""Speed as ratios: what benchmarks/ describes, measured in one run, as a table."""

from __future__ import annotations

import argparse
import platform
import sys
import time
from importlib import metadata
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.manifest import ROOT
from studies.benchmarks.kept import FILE, keep
from studies.reason import shown
from studies.timing import Measurement, measure


def main(arguments: list[str]) -> int:
    """Measure every line, print the table and keep it; return 0, whatever misses its target."""
    parser = argparse.ArgumentParser(prog="python -m studies bench", description=__doc__)
    parser.add_argument("--out", type=Path, default=FILE, help="where the figures are kept")
    options = parser.parse_args(arguments)
    sys.path[:0] = [str(ROOT / "solutions"), str(ROOT / "chapters")]
    console = Console(highlight=False)
    start = time.monotonic()
    with console.status("making the scenes, and looking for the steps that they need"):
        measurements = every(console)
    console.print(f"{len(measurements)} lines in one run: about seven minutes")
    lines = measure(measurements)
    table = Table("what", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("ratio", "spread", "target", ""):
        table.add_column(heading, justify="right", no_wrap=True)
    for line in lines:
        spread = f"{number(line.low)}-{number(line.high)}"
        target = str(line.target or "")
        table.add_row(line.what, number(line.median), spread, target, line.verdict)
    console.print(table)
    keep(lines, _versions(), options.out)
    verdicts = [line.verdict for line in lines]
    met, missed = verdicts.count("met"), verdicts.count("missed")
    minutes = (time.monotonic() - start) / 60.0
    console.print(f"{met} targets met, {missed} missed, in {minutes:.1f} minutes")
    console.print(
        f"kept in {shown(options.out)}; make table quotes them in the READMEs", soft_wrap=True
    )
    console.print(f"Python {platform.python_version()}, {_versions()}; {platform.platform()}")
    return 0


def every(console: Console) -> list[Measurement]:
    """Return all lines, in the order of the table; say what is not installed."""
    # These import chapters.
    from studies.benchmarks import (
        accuracy,
        check,
        constraints,
        forces,
        grading,
        integrators,
        particles,
        rotations,
        sparks,
        springs,
        vectors,
        worlds,
    )

    found = [*check.lines(), *vectors.lines(console), *particles.lines(), *sparks.lines()]
    found += [*forces.lines(), *springs.lines(), *integrators.lines(), *constraints.lines()]
    found += worlds.lines()
    return [*found, *rotations.lines(console), *accuracy.lines(), *grading.lines()]


def number(figure: float) -> str:
    """Return a figure as the table shows it."""
    return f"{figure:.2f}" if figure < 100.0 else f"{figure:,.0f}"


def _versions() -> str:
    there = []
    for name in ("pytest", "pyglet", "numpy", "pymunk"):
        try:
            there.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            there.append(f"no {name}")
    return ", ".join(there)
