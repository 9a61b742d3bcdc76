"""What clarity costs is measured as the page and the lesson say."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from autograder.commands import TUNED, find_engine
from autograder.text.marked import between
from studies.clarity import BEGIN, CLEAR, END, FIGURES, PAGE, Engine, draw, lines_of, table
from studies.clarity.steps import SCENES

ROWS = json.loads(FIGURES.read_text(encoding="utf-8"))["rows"]


def test_the_page_has_the_table_of_the_figures() -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert between(page, BEGIN, END) == table(ROWS)
    assert [row["scene"] for row in ROWS] == [*SCENES]


def test_the_lines_are_those_of_the_engines() -> None:
    for row in ROWS:
        parts = SCENES[row["scene"]].parts
        assert row["clear"] == sum(lines_of(find_engine(CLEAR), *part) for part in parts)
        assert row["tuned"] == sum(lines_of(find_engine(TUNED), *part) for part in parts)


def test_lines_of_code_have_no_docstring_comment_or_empty_line(tmp_path: Path) -> None:
    text = '''
class Ball:
    """A ball.

    It is round.
    """

    def roll(self):  # it counts
        """Roll."""
        # how far

        return (
            1
        )
'''
    (tmp_path / "ball.py").write_text(text, encoding="utf-8")
    assert lines_of([tmp_path], "ball.py", "Ball.roll") == 4
    assert lines_of([tmp_path], "ball.py", "Ball") == 5


def test_the_lesson_says_what_was_measured_of_runge_kutta() -> None:
    """A seventeenth of the time, almost four times as many lines. Times vary between runs."""
    (row,) = [row for row in ROWS if "Runge-Kutta" in row["scene"]]
    assert 17 / 1.5 < row["ratio"] < 17 * 1.5
    assert row["tuned"] / row["clear"] == pytest.approx(3.8, abs=0.3)


def test_both_engines_make_the_steps_of_each_scene(tmp_path: Path) -> None:
    for name in (CLEAR, TUNED):
        engine = Engine(name)
        try:
            assert all(engine.timer(scene)() > 0.0 for scene in SCENES)
        finally:
            engine.stop()
    draw(ROWS, tmp_path / "clarity.png")
    assert (tmp_path / "clarity.png").stat().st_size > 10_000
