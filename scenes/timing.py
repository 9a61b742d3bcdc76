"""Measure how long two pieces of code take, one after the other, and report the ratio.

A ratio is almost the same on every machine. Mixed rounds spread a slow minute over all benchmarks.
"""

from __future__ import annotations

import importlib.util
import random
import statistics
import sys
import time
import timeit
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from autograder.make_venv import shown_python

Timer = Callable[[], float]  # returns seconds
Figure = Callable[[], float]  # returns the figure of one round, such as a ratio of two times
Statements = dict[str, dict[str, str]]  # for each library, its "setup" and its operations
ROUNDS = 15
TIMES = 20_000  # runs of a single statement per round
LEAST = 5e-3  # s; a shorter time is measured several times per round


@dataclass(frozen=True)
class Target:
    """A bound that the result of a benchmark should meet, such as "at least 4"."""

    side: Literal["at least", "at most"]
    bound: float

    def __str__(self) -> str:
        return f"{self.side} {self.bound:,g}"

    def is_met(self, figure: float) -> bool:
        """Return True if a benchmark's result is at least as good as the bound."""
        return figure >= self.bound if self.side == "at least" else figure <= self.bound


@dataclass(frozen=True)
class Measurement:
    """A benchmark that runs in several rounds, such as a comparison of pymunk's time with ours."""

    what: str  # in the report
    once: Figure
    rounds: int
    target: Target | None = None


@dataclass(frozen=True)
class Line:
    """The result of a benchmark for the report: the median and the quartiles of all rounds."""

    what: str
    median: float
    low: float
    high: float
    target: Target | None

    @property
    def verdict(self) -> str:
        """Whether the median meets the target: "met", "missed", or "" if there is no target."""
        if self.target is None:
            return ""
        return "met" if self.target.is_met(self.median) else "missed"


def timer(run: Callable[[], object], times: int = 1) -> Timer:
    """Return a function that calls ``run`` several times and returns how long that took, in s."""
    return lambda: timeit.timeit(run, number=times)


def statement_timer(code: str, setup: str) -> Timer:
    """Return a function that runs a Python statement TIMES times and returns the time in s."""
    prepared = timeit.Timer(code, setup)
    return lambda: prepared.timeit(TIMES)


def both(first: Timer, second: Timer) -> tuple[float, float]:
    """Measure two times, one after the other in random order, which favors neither."""
    if random.random() < 0.5:
        return warm(first), warm(second)
    b = warm(second)
    return warm(first), b


def warm(timed: Timer) -> float:
    """Measure a time in s. One below LEAST is averaged over several runs, but not the first."""
    taken = timed()
    if taken >= LEAST:
        return taken
    times: list[float] = []
    end = time.perf_counter() + LEAST
    while not times or time.perf_counter() < end:
        times.append(timed())
    return statistics.fmean(times)


def fastest(timed: Timer, least: float) -> float:
    """Measure a piece of code for at least ``least`` s, and return the time of its fastest run."""
    times: list[float] = []
    while sum(times) < least:
        times.append(timed())
    return min(times)


def versus(first: Timer, second: Timer) -> Figure:
    """Return a function that times two pieces of code and returns the ratio first / second."""

    def once() -> float:
        a, b = both(first, second)
        return a / b

    return once


def measure(measurements: Sequence[Measurement]) -> list[Line]:
    """Run all rounds of all benchmarks in mixed order. Draw no progress during a round."""
    figures: list[list[float]] = [[] for _ in measurements]
    order = mixed([measurement.rounds for measurement in measurements])
    with Progress(
        TextColumn("{task.description:40.40}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        transient=True,
        auto_refresh=False,
        speed_estimate_period=3600.0,
        disable=not sys.stdout.isatty(),
    ) as progress:
        task = progress.add_task("", total=len(order))
        for i in order:
            progress.update(task, description=measurements[i].what, refresh=True)
            figures[i].append(measurements[i].once())
            progress.advance(task)
    return [
        Line(one.what, statistics.median(found), *quartiles(found), one.target)
        for one, found in zip(measurements, figures, strict=True)
    ]


def mixed(rounds: Sequence[int]) -> list[int]:
    """Return a benchmark's index for each round, in random order but evenly spread."""
    at = [((k + random.random()) / many, i) for i, many in enumerate(rounds) for k in range(many)]
    return [i for _, i in sorted(at)]


def significant(figure: float, digits: int = 3) -> float:
    """Round a figure to its significant digits, because further ones vary from run to run."""
    return float(f"{figure:.{digits}g}")


def quartiles(values: Sequence[float]) -> tuple[float, float]:
    """Return the lower and upper quartiles, without interpolating between the values."""
    ordered = sorted(values)
    return ordered[len(ordered) // 4], ordered[(3 * len(ordered)) // 4]


def against_peers(
    console: Console,
    name: str,
    statements: Statements,
    peers: Iterable[tuple[str, str, Target | None]],
) -> list[Measurement]:
    """Divide the times of other libraries by ours, as the geometric mean of the operations.

    A peer is a module, a name and a target. If it is missing, ``console`` shows how to install it.
    """
    ours = statements["ours"]
    found = []
    for peer, title, target in peers:
        if importlib.util.find_spec(peer) is None:
            console.print(
                f"{peer} is not installed. To install it:\n"
                f"  {shown_python()} -m pip install -r studies/peers.txt"
            )
            continue
        theirs = statements[peer]
        each = [
            versus(
                statement_timer(theirs[operation], theirs["setup"]),
                statement_timer(ours[operation], ours["setup"]),
            )
            for operation in ours
            if operation in theirs and operation != "setup"
        ]
        what = f"{title} / {name}, geometric mean of {len(each)} operations"
        found.append(Measurement(what, geometric_mean(each), ROUNDS, target))
    return found


def geometric_mean(figures: Sequence[Figure]) -> Figure:
    """Return a function that measures several ratios and returns their geometric mean."""
    return lambda: statistics.geometric_mean([once() for once in figures])
