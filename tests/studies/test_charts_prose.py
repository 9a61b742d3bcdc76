"""What the pages say about speed and accuracy is what was measured."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from statistics import median

import pytest

from autograder.manifest import ROOT
from autograder.text.marked import between
from studies.accuracy.catalog import scenes_with
from studies.accuracy.results import TOLERANCES
from studies.bench import kept
from studies.charts.page import BEGIN, END, FIGURES
from studies.charts.ratios import is_smooth, misses, rounded, table

ROWS = json.loads((ROOT / FIGURES).read_text(encoding="utf-8"))["rows"]
PAGE = (ROOT / "studies/README.md").read_text(encoding="utf-8")
SMOOTH = [row for row in ROWS if is_smooth(row)]
STEPS = [row for row in SMOOTH if not row["is_formula"]]
HIGH_ORDER = ("multistep", "order 8")  # the beginnings of the names of these methods
STACK = "stack of ten spheres, mass ratio 1"


def ratio(scene: str, tolerance: float, *, is_formula: bool = False) -> float:
    key = (scene, tolerance, is_formula)
    rows = (row for row in ROWS if (row["scene"], row["tolerance"], row["is_formula"]) == key)
    (found,) = rows
    return float(found["ratio"] or found["low"])


def told(scene: str, tolerance: float = 1e-6, *, is_formula: bool = False) -> str:
    return rounded(ratio(scene, tolerance, is_formula=is_formula))


def part(scene: str, tolerance: float = 1e-2) -> str:
    return f"1/{rounded(1.0 / ratio(scene, tolerance))}"


def at_each(count: Callable[[list[dict[str, object]]], object]) -> list[object]:
    """Count something in the smooth scenes, at each tolerance, for models that make steps."""
    return [count([row for row in STEPS if row["tolerance"] == each]) for each in TOLERANCES]


def sentences() -> Iterator[str]:
    """Yield what the page must say, with the numbers that were measured."""
    lines = kept()
    double, five, ten, shot = (
        rounded(figure) for what, figure in lines.items() if "the bare arithmetic" in what
    )
    yield f"this ratio is {double} for the double pendulum, {five} for the five rods, {ten} for the"
    yield f"spring of 10 N/m and {shot} for the projectile"
    bodies = "pymunk / Particle, 1000 bodies, step and read "
    ((at_once,), (in_turn,)) = (
        [figure for what, figure in lines.items() if what.startswith(bodies + how)]
        for how in ("all in one call", "every position")
    )
    yield f"positions read, takes 1/{rounded(1.0 / at_once)} of the time of our particles"
    yield f"but {rounded(in_turn)} times as long if you read one body after the other"
    yield f"it needs {part(STACK)} of our time for a stack of ten spheres"
    yield f"{part('pile of 45 spheres')} for a pile of 45 spheres"
    yield f"{part('net of 6 by 6 cables')} for a net that catches a ball"
    yield f"At 1e-4, it needs {part(STACK, 1e-4)} of our time for the stack"
    yield f"by a factor of 1,000, it needs {part(STACK + '000')} of our time at 1e-2"
    lists = rounded(1.0 / ratio("a thousand bodies in free fall", 1e-2))
    yield f"take {lists} times as long as pymunk, counting"
    yield f"For an elastic pendulum, it takes {told('elastic pendulum')} times as long"
    orbit = told("orbit of eccentricity 0.5")
    yield f"for an orbit of eccentricity 0.5, {orbit} times as long"
    large, middle, small = at_each(
        lambda rows: rounded(median(float(row["ratio"] or row["low"]) for row in rows))
    )
    yield (
        f"pymunk takes at least {large} times as long as our steps at an error of 1e-2, {middle} "
        f"times as long at 1e-4, and {small} times as long at 1e-6"
    )
    large, middle, small = at_each(
        lambda rows: sum(str(row["ours"]).startswith(HIGH_ORDER) for row in rows)
    )
    yield (
        f"in {large} of {len(STEPS) // 3} scenes at an error of 1e-2, in {middle} at 1e-4 and in "
        f"{small} at 1e-6."
    )
    exact = [row["ratio"] for row in ROWS if row["ours"] == "exact steps"]
    yield f"Pymunk then takes at least {rounded(min(exact))} times as long"
    yield f"stiffest spring {rounded(max(exact))} times as long at 1e-6."
    ball = told("bouncing ball, restitution 0.8", 1e-4, is_formula=True)
    yield f"it takes {ball} times as long at 1e-4 with a restitution of 0.8"
    better = [row for row in SMOOTH if row["is_formula"]]
    yield (
        f"In the {len({row['scene'] for row in SMOOTH})} smooth scenes, our steps miss "
        f"{sum(map(misses, STEPS))} of {len(STEPS)} goals, and our better models "
        f"{sum(map(misses, better))} of {len(better)}."
    )


@pytest.mark.parametrize("words", [*sentences()])
def test_a_number_in_the_text_is_the_measured_one(words: str) -> None:
    assert words in " ".join(PAGE.split())


def test_the_table_is_that_of_the_figures_and_has_all_scenes() -> None:
    assert between(PAGE, BEGIN, END) == table(ROWS)
    assert {row["scene"] for row in ROWS} == {scene.name for scene in scenes_with("")}


def test_what_the_text_says_without_a_number_is_still_so() -> None:
    assert not any(row["is_extrapolated"] or "never" in table([row]) for row in ROWS), "Neither"
