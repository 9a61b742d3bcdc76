"""One student of a graded class is graded again: with its seed, into all pages, and logged."""

from __future__ import annotations

import pytest

from autograder.grader import class_run
from autograder.grader.reports_folder import earlier_choice
from small import CHECKS, RIGHT
from small_class import SmallClass, grade


@pytest.fixture(autouse=True)
def _graded(small: SmallClass) -> None:
    assert small.grade(seed=None) == 0


def test_one_student_is_graded_again_and_all_pages_follow(small: SmallClass) -> None:
    before = small.results()
    assert earlier_choice(small.out) == ("90", ""), "the command then takes the same chapters"
    for student in ("ann", "bob"):
        (small.folder / student / "ch90_small/small.py").write_text(RIGHT, encoding="utf-8")
    assert small.grade(seed=None, student="bob", why="=late") == 0
    after = small.results()
    assert small.scores() == {"ann": 6.0, "bob": 6.0, "cem": 6.0}
    assert after["bob"]["seed"] == before["ann"]["seed"], "not a new seed"
    assert (after["ann"], after["cem"]) == (before["ann"], before["cem"])
    (row,) = small.table("regrades.csv")
    assert row.pop("time")[:2] == "20"
    assert row == {
        "student": "bob",
        "points before": "5",
        "points after": "6",
        "changed exercises": "90.1: 1 to 2",
        "why": "'=late",
    }
    assert {r["student"]: r["score"] for r in small.table("gradebook.csv")}["bob"] == "6"
    assert "everybody passes every exercise" in small.text("index.html")
    page = small.text("feedback/bob.html").partition("<main>")[2]
    assert "failed" not in page
    screen = small.printed()
    assert "bob: 5 points before, 6 now. Changed: 90.1: 1 to 2. Logged in" in screen
    assert small.grade(seed=None, student="bob") == 0
    assert [r["changed exercises"] for r in small.table("regrades.csv")] == ["90.1: 1 to 2", ""]
    assert "kept from an earlier run" not in small.printed(), "it was graded, not reused"


def test_a_run_that_is_killed_before_the_new_report_has_logged_the_change(
    small: SmallClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    small.write("bob/ch90_small/small.py", RIGHT)
    with monkeypatch.context() as context:
        context.setattr(class_run, "write_student", killed)
        with pytest.raises(KeyboardInterrupt):
            small.grade(seed=None, student="bob")
    assert small.scores()["bob"] == 5.0
    assert small.grade(seed=None, student="bob") == 0
    changes = [row["changed exercises"] for row in small.table("regrades.csv")]
    assert changes == ["90.1: 1 to 2", "90.1: 1 to 2"]


def test_other_conditions_are_refused_and_a_changed_check_is_logged(small: SmallClass) -> None:
    before = small.everything()
    roster = small.root / "roster.csv"
    roster.write_text("id,name,email,login\nbob,Bob Ray,,\n", encoding="utf-8")
    for options, complaint in (
        ({"student": "dan"}, "there is no student 'dan'"),
        ({"seed": "5"}, "--seed must be that of the class, '"),
        ({"hidden": small.root / "tests"}, "without hidden checks: leave out --checks"),
        ({"roster": roster}, "without a roster: leave out --roster"),
    ):
        with pytest.raises(ValueError, match=complaint):
            small.grade(**{"seed": None, "student": "bob", **options})
    manifest = small.root / "chapters/ch90_small/chapter.toml"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(text.replace("points = 2", "points = 7"), encoding="utf-8")
    with pytest.raises(ValueError, match=r"must be the same as for the class\. Use the same --ass"):
        small.grade(seed=None, student="bob")
    manifest.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"has no results\. It must be a folder of make grade"):
        grade(small.folder, small.root / "other", small.root, student="bob")
    assert small.everything() == before, "a refusal changes nothing"
    checks = small.root / "tests/ch90_small/test_small.py"
    checks.write_text(CHECKS.replace("quadruple(3) == 12", "quadruple(3) == 9"), encoding="utf-8")
    assert small.grade(seed=None, student="bob", why="the check was wrong") == 0
    assert small.scores()["bob"] == 6.0
    why = "the check was wrong The checks, the grader or the machine have changed since then."
    assert small.table("regrades.csv")[0]["why"] == why


def test_a_class_that_has_changed_is_graded_again_first(small: SmallClass) -> None:
    small.hand_in("flo", RIGHT)
    assert small.grade(seed=None, student="flo") == 0, "a single new one"
    assert sorted(small.results()) == ["ann", "bob", "cem", "flo"]
    (small.folder / "cem.zip").rename(small.place / "cem.zip")
    for late in ("dan", "eve"):  # otherwise, eve would be missing in the gradebook
        small.hand_in(late, RIGHT)
    before = small.everything()
    seed = small.results()["ann"]["seed"]
    words = rf"new or gone: cem; eve\). Grade all of it again with --seed {seed} "
    with pytest.raises(ValueError, match=words):
        small.grade(seed=None, student="dan")
    assert small.everything() == before
