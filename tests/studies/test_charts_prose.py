"""What the pages say about speed and accuracy is what was measured."""

from __future__ import annotations

import json
from statistics import median

import pytest

from autograder.manifest import ROOT
from autograder.text.marked import between
from studies.accuracy.catalog import scenes_with
from studies.accuracy.results import TOLERANCES
from studies.bench import kept
from studies.charts.page import BEGIN, END, FIGURES
from studies.charts.ratios import TIE, is_smooth, misses, rounded, table

ROWS = json.loads((ROOT / FIGURES).read_text(encoding="utf-8"))["rows"]
PAGE = " ".join((ROOT / "studies/README.md").read_text(encoding="utf-8").split())
HIGH_ORDER = ("multistep", "order 8")  # the beginnings of the names of these methods
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
    (in_turn,) = (
        figure
        for what, figure in kept().items()
        if what.startswith("pymunk / Particle, 1000 bodies, step and read every position")
    )
    assert f"but {rounded(in_turn)} times as long if you read one body after the other" in PAGE
    lists = ratio("a thousand bodies in free fall", 1e-2)
    assert 1.0 / TIE < lists < TIE, "plain lists are no longer about as fast as pymunk"


def test_the_table_is_that_of_the_figures_and_has_all_scenes() -> None:
    page = (ROOT / "studies/README.md").read_text(encoding="utf-8")
    assert between(page, BEGIN, END) == table(ROWS)
    assert {row["scene"] for row in ROWS} == {scene.name for scene in scenes_with("")}


@pytest.mark.parametrize(("words", "scene"), QUOTED)
def test_a_ratio_below_one_in_the_text_is_that_of_the_figures(words: str, scene: str) -> None:
    assert words.format(rounded(1.0 / ratio(scene, 1e-2))) in PAGE


def test_what_the_text_says_of_smaller_errors_in_contacts_is_that_of_the_figures() -> None:
    stack = rounded(1.0 / ratio("stack of ten spheres, mass ratio 1", 1e-4))
    assert f"At 1e-4, it needs 1/{stack} of our time for the stack" in PAGE
    assert not any(row["is_extrapolated"] or "never" in table([row]) for row in ROWS), "Neither"


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


def test_the_scenes_in_which_a_method_of_high_order_is_our_fastest_are_counted() -> None:
    smooth = [row for row in ROWS if is_smooth(row) and not row["is_formula"]]
    large, middle, small = (
        sum(row["tolerance"] == each and row["ours"].startswith(HIGH_ORDER) for row in smooth)
        for each in TOLERANCES
    )
    assert (
        f"in {large} of {len(smooth) // 3} scenes at an error of 1e-2, in {middle} at 1e-4 and in "
        f"{small} at 1e-6."
    ) in PAGE


def test_what_exact_steps_and_impacts_gain_is_that_of_the_figures() -> None:
    exact = [row["ratio"] for row in ROWS if row["ours"] == "exact steps"]
    assert f"Pymunk then takes at least {rounded(min(exact))} times as long" in PAGE
    assert f"stiffest spring {rounded(max(exact))} times as long at 1e-6." in PAGE
    ball = ratio("bouncing ball, restitution 0.8", 1e-4, is_formula=True)
    assert f"it takes {rounded(ball)} times as long at 1e-4 with a restitution of 0.8" in PAGE


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
