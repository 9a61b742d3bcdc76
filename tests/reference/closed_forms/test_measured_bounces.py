"""Chapter 7's exercises compared with the engine, and the format of drops."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.drops import find_drops, read_drops
from ch07_constraints.exercises import (
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


# The file of drops


def test_drops_are_read_in_their_order(tmp_path: Path) -> None:
    path = tmp_path / "drops.csv"
    text = HEADING + "rubber ball,1.5,0.9\r\n\n,,\n" + '"a, b",2,1e-1\n'
    path.write_text("\ufeff" + text, encoding="utf-8")  # spreadsheets write this mark first
    assert read_drops(path) == [("rubber ball", 1.5, 0.9), ("a, b", 2.0, 0.1)]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", 1),
        ("material,height\n", 1),
        (HEADING + "steel,1.0\n", 2),
        (HEADING + "steel,1.0,0.5,0.4\n", 2),
        (HEADING + "steel,1.0,0.5\n,1.0,0.5\n", 3),
        (HEADING + "steel,1.0,high\n", 2),
        (HEADING + "\nsteel,,0.5\n", 3),
        (HEADING + "steel,1;5,0.5\n", 2),
    ],
)
def test_what_is_no_file_of_drops_is_named_with_its_line(
    tmp_path: Path, text: str, line: int
) -> None:
    path = tmp_path / "mine.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"mine\.csv\b.* line {line} "):
        read_drops(path)


def test_the_chapter_s_own_files_are_found_and_give_restitutions() -> None:
    for name in ("drops.csv", "drops_sample.csv"):
        rows = table_of_drops(read_drops(find_drops(name)))
        assert all(0.0 <= mean <= 1.0 for _, _, mean, _ in rows)
    assert len(rows) >= 2
    with pytest.raises(FileNotFoundError, match=r"no none\.csv"):
        find_drops("none.csv")
