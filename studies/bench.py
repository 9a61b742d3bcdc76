"""Speed as ratios: two things timed in turn, shuffled, in one run on one machine.

A ratio of two medians holds on any machine; seconds do not. The spread is that of the ratios
between the quartiles of the rounds.
"""

from __future__ import annotations

import argparse
import importlib.util
import platform
import random
import statistics
import subprocess
import sys
import timeit
from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import track
from rich.table import Table

from autograder.manifest import ROOT

Timer = Callable[[], float]


@dataclass(frozen=True)
class Line:
    """A line of the report: how much faster, or slower, one thing is than another."""

    what: str
    ratio: float
    low: float
    high: float
    target: str


def main(arguments: list[str]) -> int:
    """Measure every line and print the table; return 0."""
    parser = argparse.ArgumentParser(prog="python -m studies bench", description=__doc__)
    parser.parse_args(arguments)
    sys.path[:0] = [str(ROOT / "solutions"), str(ROOT / "chapters")]
    console = Console(highlight=False)
    lines = [check_against_import(), *vectors_against_peers(console)]
    table = Table("what", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("ratio", "spread", "target"):
        table.add_column(heading, justify="right", no_wrap=True)
    for line in lines:
        spread = f"{line.low:.2f}-{line.high:.2f}"
        table.add_row(line.what, f"{line.ratio:.2f}", spread, line.target)
    console.print(table)
    console.print(f"Python {platform.python_version()}, {_versions()}; {platform.platform()}")
    return 0


def ratio(first: Timer, second: Timer, rounds: int, title: str) -> tuple[float, float, float]:
    """Time two things in turn, in shuffled order, and return first / second and its quartiles."""
    pairs = []
    for _ in track(range(rounds), title, transient=True, disable=not sys.stdout.isatty()):
        order = [0, 1]
        random.shuffle(order)
        times = [0.0, 0.0]
        for which in order:
            times[which] = (first, second)[which]()
        pairs.append(times)
    ratios = sorted(a / b for a, b in pairs)
    middle = statistics.median(a for a, _ in pairs) / statistics.median(b for _, b in pairs)
    return middle, ratios[len(ratios) // 4], ratios[(3 * len(ratios)) // 4]


def check_against_import() -> Line:
    """How long make check takes for one chapter, in units of Python importing pytest."""

    def run(*command: str) -> float:
        call = [sys.executable, *command]
        return timeit.timeit(
            lambda: subprocess.run(call, cwd=ROOT, stdout=subprocess.DEVNULL, check=False), number=1
        )

    check = ["-m", "autograder", "check", "--chapter", "2"]
    for _ in range(2):  # the first run compiles
        run(*check)
    measured = ratio(lambda: run(*check), lambda: run("-c", "import pytest"), 15, "make check")
    return Line("make check CH=2 / python -c 'import pytest'", *measured, "at most 3")


def vectors_against_peers(console: Console) -> list[Line]:
    """How much faster Vector3 is than each peer: the geometric mean over what both can do."""
    ours = STATEMENTS["ours"]
    lines = []
    for peer, title, target in (
        ("pyglet", "pyglet Vec3", "at least 2.4"),
        ("numpy", "NumPy array", "at least 4.5"),
        ("pymunk", "pymunk Vec2d (two components)", ""),
    ):
        if importlib.util.find_spec(peer) is None:
            console.print(f"{peer} is not installed: pip install -r studies/peers.txt")
            continue
        theirs = STATEMENTS[peer]
        each = [
            ratio(_timer(theirs, name), _timer(ours, name), 15, f"{peer}: {name}")
            for name in OPERATIONS
            if name in theirs
        ]
        middle, low, high = map(statistics.geometric_mean, zip(*each, strict=True))
        what = f"{title} / Vector3, geometric mean of {len(each)} operations"
        lines.append(Line(what, middle, low, high, target))
    return lines


def _timer(statements: dict[str, str], name: str) -> Timer:
    timer = timeit.Timer(statements[name], statements["setup"])
    return lambda: timer.timeit(20_000)


def _versions() -> str:
    there = []
    for name in ("pytest", "pyglet", "numpy", "pymunk"):
        try:
            there.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            there.append(f"no {name}")
    return ", ".join(there)


OPERATIONS = ("create", "add", "scale", "dot", "cross", "magnitude", "normalize", "add_scaled")
STATEMENTS = {
    "ours": {
        "setup": "from ch02_vectors.vector import Vector3 as V\n"
        "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)",
        "create": "V(1.5, 2.5, 3.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "a.cross(b)",
        "magnitude": "a.magnitude()",
        "normalize": "a.normalized()",
        "add_scaled": "c.add_scaled(b, 0.001)",
    },
    "pyglet": {
        "setup": "from pyglet.math import Vec3 as V\n"
        "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)",
        "create": "V(1.5, 2.5, 3.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "a.cross(b)",
        "magnitude": "a.length()",
        "normalize": "a.normalize()",
        "add_scaled": "c = c + b * 0.001",
    },
    "numpy": {
        "setup": "import numpy as n\n"
        "a, b, c = n.array([1.5, 2.5, 3.5]), n.array([0.5, -1.5, 2.0]), n.array([1.0, 1.0, 1.0])",
        "create": "n.array([1.5, 2.5, 3.5])",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "n.cross(a, b)",
        "magnitude": "n.linalg.norm(a)",
        "normalize": "a / n.linalg.norm(a)",
        "add_scaled": "c += b * 0.001",
    },
    "pymunk": {
        "setup": "from pymunk import Vec2d as V\na, b, c = V(1.5, 2.5), V(0.5, -1.5), V(1.0, 1.0)",
        "create": "V(1.5, 2.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "magnitude": "a.length",
        "normalize": "a.normalized()",
        "add_scaled": "c = c + b * 0.001",
    },
}
