"""Chapter 7's exercises compared with the engine, and the format of drops."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.drops import find_drops, read_drops
from ch07_constraints.exercises import (
    force_for_frame,
    restitution_of_drop,
    table_of_drops,
    top_ball_speed,
)

UP = Vector3(0.0, 1.0, 0.0)
HEADING = "material,initial_height,bounce_height\n"


@given(st.floats(0.01, 100.0), st.floats(0.0, 1.0))
def test_a_bounce_of_that_restitution_rises_as_high_as_it_was_measured(
    height: float, share: float
) -> None:
    """The engine's own contact and the energy, m g b = m v^2 / 2, give the measured height."""
    c = restitution_of_drop(height, share * height)
    ball = Particle(velocity=UP * -math.sqrt(20.0 * height))
    Contact(ball, None, UP, c).resolve_velocity()
    # Two roots and a square: a few roundings of the height.
    assert ball.velocity.y**2 / 20.0 == pytest.approx(share * height, abs=1e-15 * height)


@given(st.floats(0.0, 50.0), st.floats(0.01, 20.0), st.floats(0.01, 20.0), st.floats(0.0, 1.0),
       st.floats(0.0, 1.0), st.floats(0.0, 30.0))  # fmt: skip
def test_the_top_ball_leaves_as_the_engine_s_contacts_have_it(
    height: float, low: float, top: float, c_ground: float, c_pair: float, g: float
) -> None:
    fall = UP * -math.sqrt(2.0 * g * height)
    lower, upper = Particle(velocity=fall, mass=low), Particle(velocity=fall, mass=top)
    Contact(lower, None, UP, c_ground).resolve_velocity()
    Contact(upper, lower, UP, c_pair).resolve_velocity()
    got = top_ball_speed(height, low, top, c_ground, c_pair, g)
    # Some roundings of at most four times the speed of the fall.
    assert got == pytest.approx(upper.velocity.y, abs=1e-15 * 20.0 * fall.magnitude())


@pytest.mark.parametrize(
    ("call", "error", "match"),
    [
        (lambda: restitution_of_drop(0.0, 0.0), ValueError, "initial_height"),
        (lambda: restitution_of_drop(1.0, -0.1), ValueError, "bounce_height"),
        (lambda: restitution_of_drop(1.0, 1.1), ValueError, "bounce_height must be"),
        (lambda: restitution_of_drop(math.nan, 0.1), ValueError, "initial_height"),
        (lambda: table_of_drops([("a", 1.0, 2.0)]), ValueError, "bounce_height"),
        (lambda: top_ball_speed(-1.0, 1.0, 1.0, 0.5, 0.5), ValueError, "height"),
        (lambda: top_ball_speed(1.0, 0.0, 1.0, 0.5, 0.5), ValueError, "lower_mass"),
        (lambda: top_ball_speed(1.0, 1.0, math.inf, 0.5, 0.5), ValueError, "upper_mass"),
        (lambda: top_ball_speed(1.0, 1.0, 1.0, 1.5, 0.5), ValueError, "restitution"),
        (lambda: top_ball_speed(1.0, 1.0, 1.0, 0.5, -0.5), ValueError, "restitution"),
        (lambda: force_for_frame(UP, 0.2, 0.1), ValueError, "contact_time must be at most frame"),
        (lambda: force_for_frame(UP, -0.1, 0.1), ValueError, "contact_time"),
        (lambda: force_for_frame(UP, 0.0, 0.0), ValueError, "frame"),
        (lambda: force_for_frame((0, 1, 0), 0.0, 0.1), TypeError, "force"),
    ],
)
def test_what_the_exercises_refuse_is_named(call: Any, error: type[Exception], match: str) -> None:
    with pytest.raises(error, match=match):
        call()


# The file of drops


def test_drops_are_read_in_their_order(tmp_path: Path) -> None:
    path = tmp_path / "drops.csv"
    text = HEADING + "rubber ball,1.5,0.9\r\n\n,,\n" + '"a, b",2,1e-1\n'
    path.write_text("\ufeff" + text, encoding="utf-8")  # spreadsheets write this mark first
    assert read_drops(path) == [("rubber ball", 1.5, 0.9), ("a, b", 2.0, 0.1)]


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("", "line 1 must be material,initial_height,bounce_height, got ''"),
        ("material,height\n", "line 1 must be"),
        (HEADING + "steel,1.0\n", "line 2 must be a material and two heights"),
        (HEADING + "steel,1.0,0.5,0.4\n", "line 2 must be"),
        (HEADING + "steel,1.0,0.5\n,1.0,0.5\n", "line 3 must be"),
        (HEADING + "steel,1.0,high\n", "line 2 must have two heights in m"),
        (HEADING + "\nsteel,,0.5\n", "line 3 must have two heights in m"),
        (HEADING + "steel,1;5,0.5\n", "line 2 must have"),
    ],
)
def test_what_is_no_file_of_drops_is_named_with_its_line(
    tmp_path: Path, text: str, match: str
) -> None:
    path = tmp_path / "mine.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=match) as caught:
        read_drops(path)
    assert "mine.csv" in str(caught.value)


def test_the_chapter_s_own_files_are_found_and_give_restitutions() -> None:
    for name in ("drops.csv", "drops_sample.csv"):
        rows = table_of_drops(read_drops(find_drops(name)))
        assert all(0.0 <= mean <= 1.0 for _, _, mean, _ in rows)
    assert len(rows) >= 2
    with pytest.raises(FileNotFoundError, match=r"no none\.csv"):
        find_drops("none.csv")
