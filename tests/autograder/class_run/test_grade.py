"""A class is graded: the sample class, its gradebook and its results."""

from __future__ import annotations

import csv
import json
import re
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from autograder.checks.runner import GraderError, run_checks
from autograder.checks.verdict import Verdict
from autograder.grader.conditions import Conditions
from autograder.grader.grading import grade_submission
from autograder.isolation import probe
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.records import to_json
from autograder.submissions.find import Submission
from copies import copy_tree
from graded import message_of, points_of
from small_class import grade, results
from typed import typed

CHAPTERS = load_chapters()[:2]
CHAPTER = CHAPTERS[0]
EXERCISES = [exercise for chapter in CHAPTERS for exercise in chapter.exercises]
POSSIBLE = points_of(*CHAPTERS)
FAILS = "autograder.grader.conditions.run_checks"


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """Where the sample class was graded to, and what was printed."""
    out = tmp_path_factory.mktemp("grades")
    options = ("--seed", "1", "--chapters", "2-3")
    done = typed("autograder", "grade", "sample_class", "--out", out, *options, COLUMNS="1000")
    assert done.returncode == 0, done.stderr
    return out, done.stdout


def result(out: Path, student: str) -> dict[str, Any]:
    return dict(json.loads((out / "results" / f"{student}.json").read_text(encoding="utf-8")))


def messages(report: dict[str, Any]) -> str:
    return "\n".join(message_of(c) for r in report["results"] for c in r["checks"])


@pytest.mark.parametrize(
    ("student", "low", "high", "words"),
    [
        ("ada", POSSIBLE, POSSIBLE, ""),
        ("ben", 15, 30, "Exercise B2.8"),
        ("cleo", 40, 60, "(E-14)"),
        ("dina", 0, 0, "'(' was never closed"),
        ("finn", 5, 20, "within 3 seconds"),
        ("gwen", 3, 15, "SystemExit: clear is not done yet"),
        ("hana", 0, POSSIBLE, ""),
    ],
)
def test_each_student_gets_what_the_work_is_worth_in_the_promised_form(
    graded: tuple[Path, str], student: str, low: float, high: float, words: str
) -> None:
    report = result(graded[0], student)
    assert low <= report["score"] <= high
    assert words in messages(report)
    assert (report["student"], report["status"], report["seed"]) == (student, "graded", "1")
    assert report["isolation"] == str(probe.best_level())
    assert report["points"] == POSSIBLE
    assert [r["exercise"]["id"] for r in report["results"]] == [e.id for e in EXERCISES]
    earned = sum(one["score"] or 0.0 for one in report["results"])
    assert report["score"] == pytest.approx(earned, abs=0.01)
    for one in report["results"]:
        for check in one["checks"]:
            assert (message_of(check) == "") == (check["status"] == "passed")
    waiting = [r for r in report["results"] if r["status"] == "waiting"]
    written = [exercise.id for exercise in EXERCISES if exercise.kind == "written"]
    assert [(r["exercise"]["id"], r["score"], r["checks"]) for r in waiting] == [
        (name, None, []) for name in written
    ]


def test_the_gradebook_has_a_row_a_student_below_the_points_possible(
    graded: tuple[Path, str],
) -> None:
    with (graded[0] / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        header, possible, *rows = csv.reader(file)
    ids = [exercise.id for exercise in EXERCISES]
    scores = ["score", "score on given chapters", "by hand", "waiting", "total"]
    assert header == ["student", "status", *scores, *ids]
    assert possible[0] == "points possible"
    assert possible[2] == str(POSSIBLE)
    students = [path.name for path in (ROOT / "sample_class").iterdir() if path.is_dir()]
    assert [row[0] for row in rows] == sorted(students)
    for row in rows:
        assert row[header.index("2.3")] == ""
        if row[0] == "eli":
            assert row[1].startswith("handed in, nothing to grade: no folder of a chapter")
            assert {*row[2:]} == {"", "0"}, "nothing waits, and there are no points"
        else:
            assert float(row[2]) == result(graded[0], row[0])["score"]


def test_the_screen_shows_the_class_and_how_it_was_isolated(graded: tuple[Path, str]) -> None:
    screen = graded[1]
    assert re.search(rf"ada +{POSSIBLE}/{POSSIBLE} +{POSSIBLE} +(\d+)/\1 +graded *\n", screen)
    assert re.search("graded +B2.5: Your method creates a new vector", screen), "physics first"
    for words in ("cleo", "You follow the book's listing", "gradebook.csv"):
        assert words in screen
    assert f"Seed 1. Isolation: {probe.best_level()}" in screen


def grade_one(
    path: Path,
    chapters: list[Chapter],
    given: Sequence[Chapter] = (),
    root: Path = ROOT,
    found: dict[Any, Any] | None = None,
) -> dict[str, Any]:
    """Return the report of one submission, graded without a wall."""
    conditions = Conditions(chapters, "1", Level(), given, root=root, found=found or {})
    return dict(to_json(grade_submission(conditions, Submission(path.name, path))))


def states(report: dict[str, Any], key: str = "status") -> set[Any]:
    return {one[key] for one in report["results"]}


def test_a_fault_of_the_grader_is_an_error_to_retry_and_the_class_goes_on(
    submissions: Path, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object, **__: object) -> None:
        raise GraderError("the disk is full")

    monkeypatch.setattr(FAILS, fails)
    assert grade(submissions, tmp_path / "out", root) == 1
    report = results(tmp_path / "out")["bob"]
    assert report["status"] == "error, retry"
    assert states(report, "score") == {None}
    assert "the disk is full" in messages(report)
    rows = (tmp_path / "out/gradebook.csv").read_text(encoding="utf-8").splitlines()
    assert rows[2].startswith('ann,"error, retry",,')


def test_a_chapter_of_which_nothing_was_handed_in_is_worked_out_once_for_a_class(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runs: list[int] = []
    found: dict[Any, Any] = {"": []}

    def counted(chapter: Chapter, *arguments: Any, **more: Any) -> list[Verdict]:
        runs.append(chapter.number)
        return run_checks(chapter, *arguments, **more)

    monkeypatch.setattr(FAILS, counted)
    for student in ("ann", "bob"):
        copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / student / "ch02_vectors")
        report = grade_one(tmp_path / student, CHAPTERS, found=found)
        assert report["score"] == report["score_on_given"] == points_of(CHAPTER)
        later = [one for one in report["results"] if one["chapter"] == 3]
        assert {one["status"] for one in later} == {"failed", "blocked"}
        assert "ch03_laws_of_motion/particle.py is missing" in messages(report)
    assert runs == [2, 3, 2]
    # What became of the first student's files is no other's.
    found = {"": []}
    (tmp_path / "ann/ch02_vectors/vector.py").write_bytes(b"\xff")
    report = grade_one(tmp_path / "ann", CHAPTERS, found=found)
    assert "ch02_vectors/vector.py was rejected" in messages(report)
    report = grade_one(tmp_path / "bob", CHAPTERS, found=found)
    assert "was rejected" not in messages(report)
    runs.clear()
    refused = tmp_path / "bob/ch03_laws_of_motion/particle.py"
    refused.parent.mkdir()
    refused.write_bytes(b"\xff")
    report = grade_one(tmp_path / "bob", CHAPTERS, found=found)
    assert "ch03_laws_of_motion/particle.py was rejected" in messages(report)
    assert runs[:2] == [2, 3]


def test_nothing_falls_back_on_the_work_in_this_repository(tmp_path: Path) -> None:
    """An instructor who has solved chapters/ in place must not give away the points."""
    root = tmp_path / "root"
    for folder in ("chapters", "tests"):
        copy_tree(ROOT / folder, root / folder)
    shutil.copyfile(ROOT / "pyproject.toml", root / "pyproject.toml")
    copy_tree(ROOT / "solutions/ch02_vectors", root / "chapters/ch02_vectors")
    own = tmp_path / "eli/ch02_vectors"
    own.mkdir(parents=True)
    (own / "exercises.py").touch()  # and no vector.py
    report = grade_one(tmp_path / "eli", [CHAPTER], root=root)
    assert states(report, "score") == {0.0, None}
    assert states(report) == {"failed", "blocked", "waiting"}


@pytest.mark.parametrize("unusable", ["", "vector.py", "ch02_vectors/vector.py"])
def test_a_class_that_was_given_a_chapter_hands_in_the_next_alone(
    tmp_path: Path, unusable: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file that cannot be used does not matter where ours replaces it."""
    engines: dict[Path, list[Path]] = {}

    def noted(chapter: Chapter, engine: list[Path], **more: Any) -> list[Verdict]:
        if compiled := more["sandbox"].compiled:
            assert engines.setdefault(compiled, engine) == engine
        return run_checks(chapter, engine, **more)

    monkeypatch.setattr(FAILS, noted)
    copy_tree(ROOT / "solutions/ch03_laws_of_motion", tmp_path / "max/ch03_laws_of_motion")
    if unusable:
        (tmp_path / "max" / unusable).parent.mkdir(exist_ok=True)
        (tmp_path / "max" / unusable).write_bytes(b"\xff")
    given, graded = CHAPTERS
    assert states(grade_one(tmp_path / "max", [graded], [given])) == {"passed"}
    if unusable:
        report = grade_one(tmp_path / "max", [graded])
        assert "inherited" in states(report)
        assert report["score_on_given"] == points_of(graded)
        words = {"vector.py": "was found at the top of"}.get(unusable, "was rejected")
        assert f"{unusable} {words}" in messages(report)
