"""A graded exercise builds on one of an earlier assignment, which is not graded again."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from autograder.course.model import Work
from autograder.course.reading import read_course
from autograder.manifest import ROOT
from autograder.reports.gradescope import gradescope_results
from copies import copy_tree
from small import RIGHT, hand_in
from small_class import SmallClass, on_gradescope

COURSE = """
[[assignment]]
name = "lab1"
exercises = ["B90.1"]

[[assignment]]
name = "lab3"
exercises = ["90.1"]
"""
VECTORS = """
[[assignment]]
name = "lab1"
exercises = ["B2.1", "B2.2", "B2.3", "B2.4", "B2.9"]

[[assignment]]
name = "lab3"
exercises = ["B2.10"]
"""
ADVICE = "B90.1 of lab1 fails. Fix it first, because 90.1 builds on it."
WRONG = RIGHT.replace("x + x", "x - x")
USED = WRONG.replace("4 * x", "double(double(x))")


@pytest.fixture
def lab3(root: Path, tmp_path: Path) -> Work:
    (tmp_path / "course.toml").write_text(COURSE, encoding="utf-8")
    return read_course(tmp_path / "course.toml", root).assignments[1]


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a class: right, wrong in both exercises, and wrong only in that of lab1."""
    hand_in(tmp_path / "class", "ann", RIGHT)
    hand_in(tmp_path / "class", "bob", USED)
    hand_in(tmp_path / "class", "cem", WRONG)
    return tmp_path / "class"


def test_the_exercise_that_blocks_others_is_named_first_and_earns_nothing(
    small: SmallClass, lab3: Work
) -> None:
    assert small.grade(work=lab3) == 0
    assert small.scores() == {"ann": 2.0, "bob": 1.0, "cem": 2.0}
    causes = {student: report.get("causes") for student, report in small.results().items()}
    assert causes["ann"] is None
    assert causes["cem"] is None, "90.1 passes, so it does not matter"
    assert causes["bob"] is not None
    page = small.text("feedback/bob.html")
    assert f'">B90.1 of lab1</a> {ADVICE.partition("lab1 ")[2]}' in page
    assert "double must double" in page
    said = json.loads(small.text("gradescope/bob/results.json"))
    assert ADVICE in said["output"]
    assert said["score"] == 1
    screen = small.printed()
    assert "B90.1 of lab1: double must double" in screen
    assert "B90.1" not in small.text("gradebook.csv")
    assert '<span class="id">B90.1</span> Double' in small.text("index.html")


def test_whole_chapters_have_no_earlier_assignments(small: SmallClass) -> None:
    small.grade()
    assert not any("causes" in report for report in small.results().values())
    assert "earlier assignment" not in small.everything()
    assert "Fix <a" in small.text("feedback/bob.html")


def test_gradescope_names_the_earlier_assignment_too(tmp_path: Path) -> None:
    (tmp_path / "course.toml").write_text(VECTORS, encoding="utf-8")
    lab3 = read_course(tmp_path / "course.toml").assignments[1]
    copy_tree(ROOT / "sample_class/ada/ch02_vectors", tmp_path / "ada/ch02_vectors")
    vector = tmp_path / "ada/ch02_vectors/vector.py"
    right = vector.read_text(encoding="utf-8")
    wrong = right.replace("a[i - 2] * b[i - 1] - ", "a[i - 2] * b[i - 1] + ")
    assert wrong != right
    vector.write_text(wrong, encoding="utf-8")
    results = gradescope_results(on_gradescope(lab3, tmp_path, tmp_path / "ada"))
    assert "B2.9 of lab1 fails. Fix it first, because B2.10 builds on it." in results["output"]
    most = {test["number"]: test["max_score"] for test in results["tests"]}
    assert most == {"B2.10": 4, "B2.9": 0}
