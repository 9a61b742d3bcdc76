"""The reference is released, whole or in part, beside the solutions of students that passed."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from autograder.release.reference import chosen, released_module
from autograder.release.run import release
from autograder.reports.results import write_result
from autograder.scores import Result
from autograder.submissions.stage import stage
from graded import SHOUT, exercise_of, report_of
from small import RIGHT, hand_in
from typed import typed

CH02 = load_chapters()[0]
MINE = f'''
def helper(x):
    return x * 2  # {SHOUT}


def double(x):
    """Return twice x."""

    # Not a line.
    return helper(x)


def quadruple(x):
    return 3 * x
'''


def graded(folder: Path, grades: Path, student: str, root: Path, *passed: str) -> None:
    """Store a report on what a student has handed in, in which these exercises passed."""
    box = grades.parent / f"box of {student}"
    digest = stage(folder / student, load_chapters(root), box, root).digest
    results = [
        Result(exercise_of(name, "", "build", 2), "passed" if name in passed else "failed", 1.0, [])
        for name in ("B90.1", "90.1")
    ]
    write_result(grades, report_of(student, results=results, submission=digest))


def test_a_student_sees_what_passed_beside_the_reference(
    root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, grades, out = tmp_path / "class", tmp_path / "grades", tmp_path / "out"
    for student, code in (("ann", MINE), ("bob", RIGHT), ("cem", RIGHT), ("dan", RIGHT)):
        hand_in(folder, student, code)
        if student != "dan":
            graded(folder, grades, student, root, *(["B90.1"] if student == "ann" else []))
    (folder / "cem/ch90_small/small.py").write_text(MINE, encoding="utf-8")
    (folder / "eve.pdf").write_bytes(b"%PDF")
    write_result(grades, report_of("eve", submission="'eve.pdf' cannot be graded"))
    for _ in range(2):  # again into the folder of an earlier release
        assert release(load_chapters(root), [], folder, grades, out, root) == 0
    screen = " ".join(capsys.readouterr().out.split())
    assert "bob has no page: no released exercise passed" in screen
    assert "cem has no page: the work has changed since it was graded" in screen
    assert "dan has no page: the work was not graded" in screen
    assert "eve has no page: 'eve.pdf' cannot be graded: it is neither a folder nor" in screen
    assert "1 of 5 students have a page" in screen
    assert (out / "reference/ch90_small/small.py").read_text(encoding="utf-8") == RIGHT
    (page,) = (out / "students").iterdir()
    text = page.read_text(encoding="utf-8")
    assert re.findall("<h[23].*?>(.*?)</h[23]>", text) == [
        "B90.1 Double",
        *("double, yours", "double, reference"),
        "Other functions in small.py",
        *("helper, yours", "helper, reference"),
    ]
    assert "<pre>return helper(x)</pre>" in text
    assert "<pre>return x + x</pre>" in text
    assert "not every check of your own solution passes: 90.1." in text
    assert "3 * x" not in text
    assert "4 * x" not in text
    assert "<script>" not in text
    assert "&lt;script&gt;" in text


def test_a_class_with_a_roster_is_compared_under_its_names(
    root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, grades, out = tmp_path / "class", tmp_path / "grades", tmp_path / "out"
    hand_in(folder, "77", RIGHT)
    graded(folder, grades, "77", root, "B90.1")
    result = grades / "results/77.json"
    text = result.read_text(encoding="utf-8").replace('"student": "77"', '"student": "Ann Lee"')
    result.write_text(text, encoding="utf-8")
    roster = tmp_path / "roster.csv"
    roster.write_text("id,name,email,login\n77,Ann Lee,,\n", encoding="utf-8")
    assert release(load_chapters(root), [], folder, grades, out, root, roster=roster) == 0
    assert [page.name for page in (out / "students").iterdir()] == ["Ann Lee.html"]
    assert "1 of 1 students have a page" in capsys.readouterr().out
    pages = [*(out / "students").iterdir()]
    for submissions, results in ((folder, grades), (None, None)):
        with pytest.raises(ValueError, match="has the pages of 1 students who are not in"):
            release(load_chapters(root), [], submissions, results, out, root)
        assert [*(out / "students").iterdir()] == pages
    assert release(load_chapters(root), [], folder, grades, tmp_path / "other", root) == 0
    assert "77 has no page" in capsys.readouterr().out


def test_exercises_alone_are_released_without_the_others() -> None:
    picked = chosen(load_chapters()[:2], ["2.5", "b2.3"])
    assert [exercise.id for chapter in picked for exercise in chapter.exercises] == ["B2.3", "2.5"]
    text = released_module(picked[0], CH02, "exercises.py")
    assert "math.acos(" in text
    assert 'NotImplementedError("Exercise 2.6' in text
    with pytest.raises(ValueError, match=r"there is no exercise '2\.99' in chapter 2"):
        chosen([CH02], ["2.99"])


def test_model_answers_come_without_their_rubrics(tmp_path: Path) -> None:
    release([CH02], ["2.2b"], None, None, tmp_path / "out")
    (file,) = (tmp_path / "out/reference/ch02_vectors").iterdir()
    text = file.read_text(encoding="utf-8")
    assert "A length is never negative." in text
    assert "squared_magnitude" not in text, "2.3 is not released"
    assert "0.5 points" not in text


def test_a_folder_that_would_lose_or_leak_something_is_refused(root: Path, tmp_path: Path) -> None:
    (tmp_path / "full").mkdir()
    (tmp_path / "full/reference").write_text("mine", encoding="utf-8")
    hand_in(tmp_path / "class", "ann", RIGHT)
    chapters = load_chapters(root)
    for out, complaint in (
        (tmp_path / "full", "--out must be a new folder or an earlier release"),
        (root / "lab/scenes", "so that no handout contains it"),
        (tmp_path / "class/out", "--out must be outside of the folder of the class"),
    ):
        with pytest.raises(ValueError, match=complaint):
            release(chapters, [], tmp_path / "class", tmp_path / "grades", out, root)
    assert (tmp_path / "full/reference").read_text(encoding="utf-8") == "mine"
    assert not os.path.lexists(tmp_path / "class/out")
    with pytest.raises(ValueError, match="--submissions needs the --grades"):
        release(chapters, [], tmp_path / "class", None, tmp_path / "out", root)
    with pytest.raises(ValueError, match="has no results"):
        release(chapters, [], tmp_path / "class", tmp_path / "grades", tmp_path / "out", root)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--assignment", "lab2"], "lab2 is due 2999-01-01 12:00 UTC, counting extensions"),
        (["--assignment", "lab1", "--exercises", "B2.1,2.3"], "2.3 must wait"),
        (["2"], "lab2 is due"),  # without an assignment, the course file still counts
        (["2", "--exercises", "b2.3"], "lab3 is due"),
        (["--assignment", "lab1"], ""),
        (["2", "--exercises", "B2.1,B2.2"], ""),
    ],
)
def test_an_exercise_waits_for_every_assignment_that_contains_it(
    arguments: list[str], words: str, tmp_path: Path
) -> None:
    past, coming = "2020-01-01T12:00:00+00:00", "2999-01-01T12:00:00+00:00"
    labs = (
        ("lab1", ["B2.1"], past),
        ("lab2", ["2.3"], f"{past}\nextensions = {{ ann = {coming} }}"),
        ("lab0", ["B2.3"], past),
        ("lab3", ["B2.3"], coming),
    )
    course = [f'[[assignment]]\nname = "{n}"\nexercises = {i}\ndue = {due}\n' for n, i, due in labs]
    (tmp_path / "course.toml").write_text("\n".join(course), encoding="utf-8")
    command = ("autograder", "release", *arguments, "--out", "out")
    done = typed(*command, cwd=tmp_path, PYTHONPATH=str(ROOT))
    assert words in done.stderr
    assert (done.returncode, (tmp_path / "out").exists()) == ((2, False) if words else (0, True))
    if not words:
        module = (tmp_path / "out/reference/ch02_vectors/vector.py").read_text(encoding="utf-8")
        assert "return Vector3(self.x, self.y, self.z)" in module
        stub = "Exercise B2.2: Length" in module
        assert stub == ("lab1" in arguments), "what is not assigned stays a stub"
