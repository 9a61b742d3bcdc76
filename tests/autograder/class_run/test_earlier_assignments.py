"""A graded exercise builds on one of an earlier assignment, which is not graded again."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from autograder.course.model import Work
from autograder.course.reading import read_course
from autograder.grader.cohort import ClassOptions
from autograder.grader.cohort import grade as grade_class
from autograder.isolation.probe import best_level
from autograder.manifest import ROOT
from autograder.platforms.grade_one import grade_one
from autograder.platforms.gradescope import make_gradescope
from autograder.reports.gradescope import gradescope_results
from copies import copy_tree
from small import RIGHT, hand_in
from small_class import everything_in, results, scores
from small_class import grade as grade_chapters

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
    submissions: Path,
    root: Path,
    tmp_path: Path,
    lab3: Work,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out = tmp_path / "out"
    options = ClassOptions(seed="1", root=root, unsafe=True, earlier=lab3.earlier)
    assert grade_class(submissions, out, lab3.chapters, options) == 0
    assert scores(out) == {"ann": 2.0, "bob": 1.0, "cem": 2.0}
    causes = {student: report.get("causes") for student, report in results(out).items()}
    assert causes["ann"] is None
    assert causes["cem"] is None, "90.1 passes, so it does not matter"
    assert causes["bob"] is not None
    page = (out / "feedback/bob.html").read_text(encoding="utf-8")
    assert f'">B90.1 of lab1</a> {ADVICE.partition("lab1 ")[2]}' in page
    assert "double must double" in page
    said = json.loads((out / "gradescope/bob/results.json").read_text(encoding="utf-8"))
    assert ADVICE in said["output"]
    assert said["score"] == 1
    screen = " ".join(capsys.readouterr().out.split())
    assert "B90.1 of lab1: double must double" in screen
    assert "B90.1" not in (out / "gradebook.csv").read_text(encoding="utf-8")
    assert '<span class="id">B90.1</span> Double' in (out / "index.html").read_text(
        encoding="utf-8"
    )


def test_whole_chapters_have_no_earlier_assignments(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    grade_chapters(submissions, tmp_path / "out", root)
    assert not any("causes" in report for report in results(tmp_path / "out").values())
    assert "earlier assignment" not in everything_in(tmp_path / "out")
    assert "Fix <a" in (tmp_path / "out/feedback/bob.html").read_text(encoding="utf-8")


def test_gradescope_names_the_earlier_assignment_too(tmp_path: Path) -> None:
    (tmp_path / "course.toml").write_text(VECTORS, encoding="utf-8")
    lab3 = read_course(tmp_path / "course.toml").assignments[1]
    make_gradescope(lab3, tmp_path / "a.zip", unsafe=not best_level().is_sandbox)
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        file.extractall(tmp_path / "source")
    copy_tree(ROOT / "sample_class/ada/ch02_vectors", tmp_path / "submission/ch02_vectors")
    vector = tmp_path / "submission/ch02_vectors/vector.py"
    right = vector.read_text(encoding="utf-8")
    wrong = right.replace("a[i - 2] * b[i - 1] - ", "a[i - 2] * b[i - 1] + ")
    assert wrong != right
    vector.write_text(wrong, encoding="utf-8")
    results = gradescope_results(grade_one(tmp_path, tmp_path / "source"))
    assert "B2.9 of lab1 fails. Fix it first, because B2.10 builds on it." in results["output"]
    most = {test["number"]: test["max_score"] for test in results["tests"]}
    assert most == {"B2.10": 4, "B2.9": 0}
