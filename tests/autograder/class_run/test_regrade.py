"""One student of a graded class is graded again: with its seed, into all pages, and logged."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from autograder.grader.regrade import Regrade, earlier_choice
from small import CHECKS, RIGHT, hand_in
from small_class import everything_in, grade, results, scores


@pytest.fixture
def out(submissions: Path, root: Path, tmp_path: Path) -> Path:
    assert grade(submissions, tmp_path / "out", root, seed=None) == 0
    return tmp_path / "out"


def logged(out: Path) -> list[dict[str, str]]:
    with (out / "regrades.csv").open(encoding="utf-8", newline="") as file:
        return [*csv.DictReader(file)]


def test_one_student_is_graded_again_and_all_pages_follow(
    submissions: Path, root: Path, out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = results(out)
    assert earlier_choice(out) == ("90", ""), "the command then takes the same chapters"
    assert scores(out) == {"ann": 6.0, "bob": 5.0, "cem": 6.0}
    for student in ("ann", "bob"):
        (submissions / student / "ch90_small/small.py").write_text(RIGHT, encoding="utf-8")
    assert grade(submissions, out, root, seed=None, student="bob", why="=late") == 0
    after = results(out)
    assert scores(out) == {"ann": 6.0, "bob": 6.0, "cem": 6.0}
    assert after["bob"]["seed"] == before["ann"]["seed"], "not a new seed"
    assert (after["ann"], after["cem"]) == (before["ann"], before["cem"])
    (row,) = logged(out)
    assert row.pop("time")[:2] == "20"
    assert row == {
        "student": "bob",
        "points before": "5",
        "points after": "6",
        "changed exercises": "90.1: 1 to 2",
        "why": "'=late",
    }
    with (out / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        assert {r["student"]: r["score"] for r in csv.DictReader(file)}["bob"] == "6"
    assert "everybody passes every exercise" in (out / "index.html").read_text(encoding="utf-8")
    page = (out / "feedback/bob.html").read_text(encoding="utf-8").partition("<main>")[2]
    assert "failed" not in page
    screen = " ".join(capsys.readouterr().out.split())
    assert "bob: 5 points before, 6 now. Changed: 90.1: 1 to 2. Logged in" in screen
    assert grade(submissions, out, root, seed=None, student="bob") == 0
    assert [row["changed exercises"] for row in logged(out)] == ["90.1: 1 to 2", ""]
    assert "kept from an earlier run" not in capsys.readouterr().out, "it was graded, not reused"


def test_a_run_that_is_killed_before_it_wrote_the_log_is_logged_by_the_next_one(
    submissions: Path, root: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    (submissions / "bob/ch90_small/small.py").write_text(RIGHT, encoding="utf-8")
    with monkeypatch.context() as context:
        context.setattr(Regrade, "finish", killed)
        with pytest.raises(KeyboardInterrupt):
            grade(submissions, out, root, seed=None, student="bob")
    assert scores(out)["bob"] == 6.0
    assert grade(submissions, out, root, seed=None, student="bob") == 0
    assert [row["changed exercises"] for row in logged(out)] == ["90.1: 1 to 2"]
    assert [*out.glob(".before*")] == []


def test_a_changed_check_is_logged_and_other_conditions_are_refused(
    submissions: Path, root: Path, out: Path
) -> None:
    before = everything_in(out)
    for options, complaint in (
        ({"student": "dan"}, "there is no student 'dan'"),
        ({"student": "bob", "seed": "5"}, "--seed must be that of the class, '"),
        ({"student": "bob", "hidden": root / "tests"}, "without hidden checks: leave out --checks"),
    ):
        with pytest.raises(ValueError, match=complaint):
            grade(submissions, out, root, **{"seed": None, **options})
    with pytest.raises(ValueError, match=r"has no results\. It must be a folder of make grade"):
        grade(submissions, root / "other", root, student="bob")
    assert everything_in(out) == before, "a refusal changes nothing"
    checks = root / "tests/ch90_small/test_small.py"
    checks.write_text(CHECKS.replace("quadruple(3) == 12", "quadruple(3) == 9"), encoding="utf-8")
    assert grade(submissions, out, root, seed=None, student="bob", why="the check was wrong") == 0
    assert scores(out)["bob"] == 6.0
    why = "the check was wrong Changed since the class was graded: the checks or the reference."
    assert logged(out)[0]["why"] == why


def test_a_class_that_has_changed_is_graded_again_first(
    submissions: Path, root: Path, out: Path, tmp_path: Path
) -> None:
    seed = results(out)["ann"]["seed"]
    (submissions / "cem.zip").rename(tmp_path / "cem.zip")
    for late in ("dan", "eve"):  # otherwise, eve would be missing in the gradebook
        hand_in(submissions, late, RIGHT)
    before = everything_in(out)
    words = rf"not graded yet: eve, and not there: cem\). Grade all of it again with --seed {seed}"
    with pytest.raises(ValueError, match=words):
        grade(submissions, out, root, seed=None, student="dan")
    assert everything_in(out) == before
    assert grade(submissions, out, root, seed=seed) == 0
    assert sorted(results(out)) == ["ann", "bob", "dan", "eve"]
    hand_in(submissions, "flo", RIGHT)
    assert grade(submissions, out, root, seed=None, student="flo") == 0, "a single new one"
    assert sorted(results(out)) == ["ann", "bob", "dan", "eve", "flo"]


def test_a_class_with_a_roster_keeps_it_in_a_regrade(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text("id,name,email,login\nbob,Bob Ray,,\n", encoding="utf-8")
    named, unnamed = tmp_path / "named", tmp_path / "unnamed"
    assert grade(submissions, named, root, seed=None, roster=roster) == 0
    assert grade(submissions, unnamed, root, seed=None) == 0
    before = everything_in(named), everything_in(unnamed)
    with pytest.raises(ValueError, match=r"with a roster: add --roster \(make: ROSTER=\)"):
        grade(submissions, named, root, seed=None, student="bob")
    with pytest.raises(ValueError, match="without a roster: leave out --roster"):
        grade(submissions, unnamed, root, seed=None, student="bob", roster=roster)
    assert (everything_in(named), everything_in(unnamed)) == before, "a refusal changes nothing"
    assert grade(submissions, named, root, seed=None, student="bob", roster=roster) == 0
    assert sorted(results(named)) == ["Bob Ray", "ann", "cem"]


def test_other_points_than_those_of_the_class_are_refused_without_a_list(
    submissions: Path, root: Path, out: Path
) -> None:
    manifest = root / "chapters/ch90_small/chapter.toml"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(text.replace("points = 2", "points = 7"), encoding="utf-8")
    assert manifest.read_text(encoding="utf-8") != text
    with pytest.raises(ValueError, match=r"must be the same as for the class\. Use the same --ass"):
        grade(submissions, out, root, seed=None, student="bob")
