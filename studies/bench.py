"""Speed as ratios: what benchmarks/ measures, as one table."""

from __future__ import annotations

import argparse
import platform
import sys
from importlib import metadata

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.manifest import ROOT


def main(arguments: list[str]) -> int:
    """Measure every line and print the table; return 0."""
    parser = argparse.ArgumentParser(prog="python -m studies bench", description=__doc__)
    parser.parse_args(arguments)
    sys.path[:0] = [str(ROOT / "solutions"), str(ROOT / "chapters")]
    console = Console(highlight=False)
    # These import chapters.
    from studies.benchmarks import (
        check,
        constraints,
        forces,
        grading,
        particles,
        rotations,
        sparks,
        springs,
        vectors,
        worlds,
    )

    lines = [*check.lines(), *vectors.lines(console), *particles.lines(), *sparks.lines()]
    lines += [*forces.lines(), *springs.lines(), *constraints.lines(), *worlds.lines()]
    lines += rotations.lines(console)
    lines += grading.lines(console)
    table = Table("what", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("ratio", "spread", "target"):
        table.add_column(heading, justify="right", no_wrap=True)
    for line in lines:
        spread = f"{line.low:.2f}-{line.high:.2f}"
        table.add_row(line.what, f"{line.ratio:.2f}", spread, line.target)
    console.print(table)
    console.print(f"Python {platform.python_version()}, {_versions()}; {platform.platform()}")
    return 0


def _versions() -> str:
    there = []
    for name in ("pytest", "pyglet", "numpy", "pymunk"):
        try:
            there.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            there.append(f"no {name}")
    return ", ".join(there)
