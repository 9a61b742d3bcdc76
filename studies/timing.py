"""Two things timed in turn, shuffled, in one run on one machine, as a ratio.

A ratio holds on any machine; seconds do not. It is the median of the rounds' ratios, and the spread
is between their quartiles.
"""

from __future__ import annotations

import importlib.util
import random
import statistics
import sys
import timeit
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from rich.console import Console
from rich.progress import track

Timer = Callable[[], float]
Statements = dict[str, dict[str, str]]  # of a library, by operation; its "setup" comes first
ROUNDS = 15
TIMES = 20_000  # a round, of a single statement


@dataclass(frozen=True)
class Line:
    """A line of the report: how much faster, or slower, one thing is than another."""

    what: str
    ratio: float
    low: float
    high: float
    target: str


def timer(run: Callable[[], object], times: int = 1) -> Timer:
    """Return what times so many runs, in seconds."""
    return lambda: timeit.timeit(run, number=times)


def statement_timer(code: str, setup: str) -> Timer:
    """Return what times many runs of a statement, in seconds."""
    prepared = timeit.Timer(code, setup)
    return lambda: prepared.timeit(TIMES)


def ratio(first: Timer, second: Timer, rounds: int, title: str) -> tuple[float, float, float]:
    """Return the median of first / second and its quartiles, timed in turn in shuffled order."""
    pairs = []
    for _ in track(range(rounds), title, transient=True, disable=not sys.stdout.isatty()):
        order = [0, 1]
        random.shuffle(order)
        times = [0.0, 0.0]
        for which in order:
            times[which] = (first, second)[which]()
        pairs.append(times)
    ratios = [a / b for a, b in pairs]
    return statistics.median(ratios), *quartiles(ratios)


def quartiles(values: Sequence[float]) -> tuple[float, float]:
    """Return the lower and the upper quartile, each one of the values."""
    ordered = sorted(values)
    return ordered[len(ordered) // 4], ordered[(3 * len(ordered)) // 4]


def against_peers(
    console: Console, name: str, statements: Statements, peers: Iterable[tuple[str, str, str]]
) -> list[Line]:
    """How much faster ours is than each peer: the geometric mean over what both can do.

    ``name`` is what ours is called. A peer is the module that it needs, what of it is measured, and
    the target; one that is not installed is said and left out.
    """
    ours = statements["ours"]
    measured = []
    for peer, title, target in peers:
        if importlib.util.find_spec(peer) is None:
            console.print(
                f"{peer} is not installed: .venv/bin/python -m pip install -r studies/peers.txt"
            )
            continue
        theirs = statements[peer]
        each = [
            ratio(
                statement_timer(theirs[operation], theirs["setup"]),
                statement_timer(ours[operation], ours["setup"]),
                ROUNDS,
                f"{peer}: {operation}",
            )
            for operation in ours
            if operation in theirs and operation != "setup"
        ]
        middle, low, high = map(statistics.geometric_mean, zip(*each, strict=True))
        what = f"{title} / {name}, geometric mean of {len(each)} operations"
        measured.append(Line(what, middle, low, high, target))
    return measured
