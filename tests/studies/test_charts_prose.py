"""What the pages say about speed and accuracy is what `make charts` and `make bench` measured."""

from __future__ import annotations

import json
from statistics import median

import pytest

from autograder.manifest import ROOT
from autograder.text.marked import between
from studies.accuracy.catalog import scenes_with
from studies.accuracy.results import TOLERANCES
from studies.benchmarks.kept import kept
from studies.charts.kept import (
    BEGIN,
    END,
    FIGURES,
    TIE,
    is_smooth,
    misses,
    rounded,
    table,
)

ROWS = json.loads((ROOT / FIGURES).read_text(encoding="utf-8"))["rows"]
PAGE = " ".join((ROOT / "studies/README.md").read_text(encoding="utf-8").split())
# Words with a ratio of our steps, and their scene: at an error of 1e-2, and at 1e-6.
QUOTED = [
    ("it needs 1/{} of our time for a stack of ten spheres", "stack of ten spheres, mass ratio 1"),
    ("1/{} for a pile of 45 spheres", "pile of 45 spheres"),
    ("1/{} for a net that catches a ball", "net of 6 by 6 cables"),
]
LARGE = [
    ("For an elastic pendulum, it takes {} times as long", "elastic pendulum"),
    ("for an orbit of eccentricity 0.5, {} times as long", "orbit of eccentricity 0.5"),
]


def ratio(scene: str, tolerance: float, *, is_formula: bool = False) -> float:
    (found,) = (
        row
        for row in ROWS
        if (row["scene"], row["tolerance"], row["is_formula"]) == (scene, tolerance, is_formula)
    )
    return float(found["ratio"] or found["low"])


def test_the_bounds_in_the_text_are_those_of_the_benchmarks() -> None:
    found = [figure for what, figure in kept().items() if "the bare arithmetic" in what]
    double, five, ten, shot = map(rounded, found)
    assert (
        f"this ratio is {double} for the double pendulum, {five} for the five rods, {ten} for the "
        f"spring of 10 N/m and {shot} for the projectile"
    ) in PAGE


def test_the_ratio_of_particles_in_the_text_is_that_of_the_benchmarks() -> None:
    (found,) = (
        figure
        for what, figure in kept().items()
        if what.startswith("pymunk / Particle, 1000 bodies, step and read all in one call")
    )
    assert f"positions read, takes 1/{rounded(1.0 / found)} of the time of our particles" in PAGE
    lists = ratio("a thousand bodies in free fall", 1e-2)
    assert 1.0 / TIE < lists < TIE, "plain lists are no longer about as fast as pymunk"


def test_the_table_is_that_of_the_figures_and_has_all_scenes() -> None:
    page = (ROOT / "studies/README.md").read_text(encoding="utf-8")
    assert between(page, BEGIN, END) == table(ROWS)
    assert {row["scene"] for row in ROWS} == {scene.name for scene in scenes_with("")}


@pytest.mark.parametrize(("words", "scene"), QUOTED)
def test_a_ratio_below_one_in_the_text_is_that_of_the_figures(words: str, scene: str) -> None:
    assert words.format(rounded(1.0 / ratio(scene, 1e-2))) in PAGE


@pytest.mark.parametrize(("words", "scene"), LARGE)
def test_a_ratio_in_the_text_is_that_of_the_figures(words: str, scene: str) -> None:
    assert words.format(rounded(ratio(scene, 1e-6))) in PAGE


def test_the_typical_ratios_of_smooth_scenes_are_those_of_the_figures() -> None:
    smooth = [row for row in ROWS if is_smooth(row) and not row["is_formula"]]
    large, middle, small = (
        rounded(median(row["ratio"] or row["low"] for row in smooth if row["tolerance"] == each))
        for each in TOLERANCES
    )
    assert (
        f"pymunk takes at least {large} times as long as our steps at an error of 1e-2, {middle} "
        f"times as long at 1e-4, and {small} times as long at 1e-6"
    ) in PAGE


def test_the_goals_that_are_missed_are_counted() -> None:
    smooth = [row for row in ROWS if is_smooth(row)]
    steps, models = (
        (sum(map(misses, own)), len(own))
        for own in (
            [row for row in smooth if row["is_formula"] == is_formula]
            for is_formula in (False, True)
        )
    )
    assert (
        f"In the {len({row['scene'] for row in smooth})} smooth scenes, our steps miss {steps[0]} "
        f"of {steps[1]} goals, and our better models {models[0]} of {models[1]}."
    ) in PAGE
