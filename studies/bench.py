"""Measure how fast the physics engine is, and report which of its speed targets it meets.

Most results are ratios of two times, such as pymunk's time for a step divided by ours. Such a ratio
is almost the same on every machine.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
import time
from importlib import metadata
from pathlib import Path

from rich.console import Console

from autograder.commands import TUNED, find_engine
from autograder.files import from_here
from autograder.manifest import ROOT
from autograder.text.wrapping import plain_console
from scenes.timing import Line, Measurement, measure, significant
from studies.stored import store

FILE = ROOT / "studies/benchmarks/figures.json"


def main(arguments: list[str]) -> int:
    """Run all benchmarks, print the results, and save them. Return 0 even if targets are missed."""
    parser = argparse.ArgumentParser(prog="python -m studies bench", description=__doc__)
    parser.add_argument("--out", type=Path, default=FILE, help="file for the figures")
    options = parser.parse_args(arguments)
    sys.path[:0] = map(str, find_engine(TUNED))
    console = plain_console()
    start = time.monotonic()
    with console.status("preparing the scenes and finding how many steps each one needs"):
        measurements = every(console)
    console.print(f"Taking all {len(measurements)} measurements takes about five minutes.")
    lines = measure(measurements)
    console.print("Each figure is a ratio of two times, first / second, unless stated otherwise.")
    console.print("It is the median of several rounds, with the quartiles in parentheses.\n")
    for line in lines:
        console.print(line.what)
        console.print(f"    {told(line)}", style="bold")
    found = {
        line.what: {
            "ratio": significant(line.median),
            "quartiles": [significant(line.low), significant(line.high)],
            "target": str(line.target or ""),
            "verdict": line.verdict,
        }
        for line in lines
    }
    machine = f"{platform.system()} {platform.machine()}"
    store(options.out, machine=machine, libraries=_versions(), lines=found)
    verdicts = [line.verdict for line in lines]
    met, missed = verdicts.count("met"), verdicts.count("missed")
    minutes = (time.monotonic() - start) / 60.0
    console.print(f"\n{met} targets met, {missed} missed, in {minutes:.1f} minutes")
    console.print(
        f"Written to {from_here(options.out)}. Run make update to update the READMEs.",
        soft_wrap=True,
    )
    console.print(f"Python {platform.python_version()}, {_versions()}; {platform.platform()}")
    return 0


def every(console: Console) -> list[Measurement]:
    """Set up all benchmarks in the order of the report, without those of missing libraries."""
    # These modules import chapters.
    from studies.benchmarks import (
        accuracy,
        algebra,
        constraints,
        grading,
        particles,
        springs,
        worlds,
    )

    found = [grading.line_of_check(), *algebra.lines_of_vectors(console), *particles.lines()]
    found += [*particles.lines_of_sparks(), *springs.lines(), *constraints.lines(), *worlds.lines()]
    return [*found, *algebra.lines_of_rotations(console), *accuracy.lines(), *grading.lines()]


def kept(file: Path = FILE) -> dict[str, float]:
    """Load the medians by what they measure, or an empty dict if no results are stored yet."""
    if not file.exists():
        return {}
    lines = json.loads(file.read_text(encoding="utf-8"))["lines"]
    return {what: line["ratio"] for what, line in lines.items()}


def told(line: Line) -> str:
    """Format a result, as in "1.32 (1.30 to 1.35), target at most 1.6: met"."""
    spread = f"{number(line.median)} ({number(line.low)} to {number(line.high)})"
    return f"{spread}, target {line.target}: {line.verdict}" if line.target else spread


def number(figure: float) -> str:
    """Format a benchmark's result with two decimals, or as a whole number if it is 100 or more."""
    return f"{figure:.2f}" if figure < 100.0 else f"{figure:,.0f}"


def _versions() -> str:
    there = []
    for name in ("pytest", "pyglet", "numpy", "pymunk"):
        try:
            there.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            there.append(f"no {name}")
    return ", ".join(there)
