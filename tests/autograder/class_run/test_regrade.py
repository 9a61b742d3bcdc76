"""One student of a graded class is graded again: with its seed, into all pages, and logged."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.grader import class_run
from autograder.grader.class_folder import earlier_choice
from small import CHECKS, RIGHT, hand_in
from small_class import everything_in, grade, results, scores, table


@pytest.fixture
def out(submissions: Path, root: Path, tmp_path: Path) -> Path:
    assert grade(submissions, tmp_path / "out", root, seed=None) == 0
    return tmp_path / "out"


def test_one_student_is_graded_again_and_all_pages_follow(
    submissions: Path, root: Path, out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = results(out)
    assert earlier_choice(out) == ("90", ""), "the command then takes the same chapters"
    for student in ("ann", "bob"):
        (submissions / student / "ch90_small/small.py").write_text(RIGHT, encoding="utf-8")
    assert grade(submissions, out, root, seed=None, student="bob", why="=late") == 0
    after = results(out)
    assert scores(out) == {"ann": 6.0, "bob": 6.0, "cem": 6.0}
    assert after["bob"]["seed"] == before["ann"]["seed"], "not a new seed"
    assert (after["ann"], after["cem"]) == (before["ann"], before["cem"])
    (row,) = table(out / "regrades.csv")
    assert row.pop("time")[:2] == "20"
    assert row == {
        "student": "bob",
        "points before": "5",
        "points after": "6",
        "changed exercises": "90.1: 1 to 2",
        "why": "'=late",
    }
    assert {r["student"]: r["score"] for r in table(out / "gradebook.csv")}["bob"] == "6"
    assert "everybody passes every exercise" in (out / "index.html").read_text(encoding="utf-8")
    page = (out / "feedback/bob.html").read_text(encoding="utf-8").partition("<main>")[2]
    assert "failed" not in page
    screen = " ".join(capsys.readouterr().out.split())
    assert "bob: 5 points before, 6 now. Changed: 90.1: 1 to 2. Logged in" in screen
    assert grade(submissions, out, root, seed=None, student="bob") == 0
    assert [r["changed exercises"] for r in table(out / "regrades.csv")] == ["90.1: 1 to 2", ""]
    assert "kept from an earlier run" not in capsys.readouterr().out, "it was graded, not reused"


def test_a_run_that_is_killed_before_the_new_report_has_logged_the_change(
    submissions: Path, root: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    (submissions / "bob/ch90_small/small.py").write_text(RIGHT, encoding="utf-8")
    with monkeypatch.context() as context:
        context.setattr(class_run, "write_student", killed)
        with pytest.raises(KeyboardInterrupt):
            grade(submissions, out, root, seed=None, student="bob")
    assert scores(out)["bob"] == 5.0
    assert grade(submissions, out, root, seed=None, student="bob") == 0
    changes = [row["changed exercises"] for row in table(out / "regrades.csv")]
    assert changes == ["90.1: 1 to 2", "90.1: 1 to 2"]


def test_other_conditions_are_refused_and_a_changed_check_is_logged(
    submissions: Path, root: Path, out: Path
) -> None:
    before = everything_in(out)
    roster = root / "roster.csv"
    roster.write_text("id,name,email,login\nbob,Bob Ray,,\n", encoding="utf-8")
    for options, complaint in (
        ({"student": "dan"}, "there is no student 'dan'"),
        ({"seed": "5"}, "--seed must be that of the class, '"),
        ({"hidden": root / "tests"}, "without hidden checks: leave out --checks"),
        ({"roster": roster}, "without a roster: leave out --roster"),
    ):
        with pytest.raises(ValueError, match=complaint):
            grade(submissions, out, root, **{"seed": None, "student": "bob", **options})
    manifest = root / "chapters/ch90_small/chapter.toml"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(text.replace("points = 2", "points = 7"), encoding="utf-8")
    with pytest.raises(ValueError, match=r"must be the same as for the class\. Use the same --ass"):
        grade(submissions, out, root, seed=None, student="bob")
    manifest.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"has no results\. It must be a folder of make grade"):
        grade(submissions, root / "other", root, student="bob")
    assert everything_in(out) == before, "a refusal changes nothing"
    checks = root / "tests/ch90_small/test_small.py"
    checks.write_text(CHECKS.replace("quadruple(3) == 12", "quadruple(3) == 9"), encoding="utf-8")
    assert grade(submissions, out, root, seed=None, student="bob", why="the check was wrong") == 0
    assert scores(out)["bob"] == 6.0
    why = "the check was wrong Changed since the class was graded: the checks or the reference."
    assert table(out / "regrades.csv")[0]["why"] == why


def test_a_class_that_has_changed_is_graded_again_first(
    submissions: Path, root: Path, out: Path, tmp_path: Path
) -> None:
    (submissions / "cem.zip").rename(tmp_path / "cem.zip")
    for late in ("dan", "eve"):  # otherwise, eve would be missing in the gradebook
        hand_in(submissions, late, RIGHT)
    before = everything_in(out)
    words = r"not graded yet: eve, and not there: cem\). Grade all of it again without --student"
    with pytest.raises(ValueError, match=words):
        grade(submissions, out, root, seed=None, student="dan")
    assert everything_in(out) == before
    assert grade(submissions, out, root, seed=None) == 0
    assert sorted(results(out)) == ["ann", "bob", "dan", "eve"]
    hand_in(submissions, "flo", RIGHT)
    assert grade(submissions, out, root, seed=None, student="flo") == 0, "a single new one"
    assert sorted(results(out)) == ["ann", "bob", "dan", "eve", "flo"]
