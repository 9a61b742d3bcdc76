"""An assignment of a course, graded and handed out: its exercises count, in its points."""

from __future__ import annotations

import argparse
import json
import zipfile
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import yaml

from autograder.course.choose import work_of
from autograder.course.handout import about
from autograder.course.model import Work
from autograder.course.reading import read_course
from autograder.instructor import run_handout
from autograder.manifest import ROOT, load_chapter, load_chapters
from autograder.platforms.classroom import WORKFLOW, rounded_points
from autograder.platforms.grade_one import grade_one
from autograder.platforms.gradescope import make_gradescope
from autograder.reports.gradescope import gradescope_results
from small import MANIFEST, RIGHT, WRITTEN, hand_in, make_root
from small_class import HALF, SmallClass, on_gradescope
from typed import typed
from wrong import write_all

CH02 = load_chapters()[0]
SMALL = """
[[assignment]]
name = "lab1"
exercises = ["B90.1"]
extra_credit = ["90.1"]

[[assignment]]
name = "lab2"
exercises = ["90.1", "90.2"]
out_of = 10
due = 2026-10-23T23:59:00+02:00
late = { points_per_day = 1.5 }
"""
VECTORS = """
time_zone = "Europe/Berlin"

[[assignment]]
name = "lab1"
title = "Vectors"
exercises = ["B2.1", "B2.4", "B2.2"]
extra_credit = ["B2.5"]
points = { "B2.4" = 5 }
out_of = 20
due = 2026-10-23 23:59:00
late = { percent_per_day = 10, cap = 25 }
extensions = { "ann@example.org" = 2026-10-24 23:59:00 }

[[assignment]]
name = "lab2"
exercises = ["2.1", "2.4"]
"""
EARLIER = """
[[assignment]]
name = "lab1"
exercises = ["{}"]

[[assignment]]
name = "lab3"
exercises = ["{}"]
"""
ADVICE = "B90.1 of lab1 fails. Fix it first, because 90.1 builds on it."
BOTH_WRONG = RIGHT.replace("x + x", "x - x").replace("4 * x", "double(double(x))")


def course(folder: Path, text: str, root: Path = ROOT) -> dict[str, Work]:
    folder.mkdir(exist_ok=True)
    path = folder / "course.toml"
    path.write_text(text, encoding="utf-8")
    return {work.name: work for work in read_course(path, root).assignments}


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a class: right, half right, and wrong only in what lab2 does not grade."""
    folder = tmp_path / "class"
    hand_in(folder, "ann", RIGHT)
    hand_in(folder, "bob", HALF)
    hand_in(folder, "cem", RIGHT.replace("x + x", "x"))
    return folder


def test_only_the_assigned_exercises_count_and_lateness_has_columns_of_its_own(
    small: SmallClass,
) -> None:
    """Two and three points become 4 and 6. Bob is two days late, and Cem's time is unknown."""
    times = "student,submitted\nann,2026-10-23 20:00\nbob,2026-10-25T20:00:00Z\n"
    small.write("times.csv", times)
    marks = "student,exercise,points,comment\nann,90.2,1.5,half\nbob,90.2,3,all\n"
    small.write("marks.csv", marks)
    work = course(small.folder, SMALL, small.root)["lab2"]
    assert small.grade(work=work) == 0
    rows = small.table("gradebook.csv")
    columns = ["score", "by hand", "waiting", "points", "late days", "penalty", "total"]
    columns += ["90.1", "90.2"]
    assert {row["student"]: [row[column] for column in columns] for row in rows} == {
        "points possible": ["4", "6", "", "10", "", "", "10", "4", "6"],
        "ann": ["4", "3", "0", "7", "0", "0", "7", "4", "3"],
        "bob": ["2", "6", "0", "8", "2", "3", "5", "2", "6"],
        "cem": ["4", "", "6", "4", "", "0", "4", "4", ""],
    }
    assert [r["exercise"]["id"] for r in small.results()["cem"]["results"]] == ["90.1", "90.2"]
    page = small.text("feedback/bob.html")
    for words in ("Points earned: 8.", "Late penalty: 3.", "2026-10-23 23:59", "costs 1.5 points"):
        assert words in page
    assert "B90.1" not in page
    said = json.loads(small.text("gradescope/bob/results.json"))
    assert said["score"] == 5
    assert "late penalty: 3 points. It was due" in said["output"]
    assert "total: 8 - 3 = 5 points" in said["output"]
    screen = small.printed()
    assert "therefore get no penalty: cem." in screen
    assert "student score on given" in screen
    assert "The scores in this table are from checks alone. The totals, which include" in screen
    (small.folder / "times.csv").unlink()
    (small.folder / "cem_LATE_1_2_x").mkdir()
    assert small.grade(work=work) == 0
    assert "3 of 4 reports" in small.printed()
    again = {row["student"]: row for row in small.table("gradebook.csv")}
    assert [again["bob"][column] for column in ("points", "late days", "total")] == ["8", "", "8"]


def test_extra_credit_counts_above_the_total(small: SmallClass) -> None:
    """Four points are possible, and two more can be earned. The gradebook has no late columns."""
    assert small.grade(work=course(small.folder, SMALL, small.root)["lab1"]) == 0
    rows = small.table("gradebook.csv")
    assert small.scores() == {"ann": 6, "bob": 5, "cem": 3}  # a zero doubles rightly, too
    assert rows[0]["score"] == rows[0]["total"] == "4"
    assert "penalty" not in rows[0]
    assert small.results()["ann"]["points"] == 4
    assert "extra credit" in small.text("feedback/ann.html")
    said = json.loads(small.text("gradescope/ann/results.json"))
    assert [(t["number"], t["score"], t["max_score"]) for t in said["tests"]] == [
        ("B90.1", 4, 4),
        ("90.1", 2, 0),
    ]
    text = SMALL.replace('"B90.1"]', '"B90.1"]\nout_of = 8')
    assert small.grade(work=course(small.folder, text, small.root)["lab1"]) == 0
    assert small.scores()["ann"] == 12, "and no report of the other points is kept"


def row(screen: str, exercise: str) -> str:
    return next(line for line in screen.splitlines() if line.split()[:1] == [exercise])


def test_a_hand_out_marks_what_is_optional_and_is_done_without_it(tmp_path: Path) -> None:
    course(tmp_path, VECTORS)
    out = tmp_path / "out"
    assert run_handout(options(tmp_path, assignment="lab1", out=out)) == 0
    readme = (out / "README.md").read_text(encoding="utf-8")
    assert "## lab1: Vectors\n\nDue 2026-10-23 23:59 CEST.\nEach day or part of a day" in readme
    assert "| B2.4 | Normalize | 10 |" in readme
    assert "| B2.5 | Add and subtract | 6 (extra credit) |\n| | total | 20 |" in readme
    assert "ann@example.org" not in readme, "extensions are nobody else's business"
    table = (out / "chapters/ch02_vectors/reference.md").read_text(encoding="utf-8")
    assert "| B2.6 | Add a scaled vector | build | \\* | optional |" in table
    handed = load_chapter(out / "chapters/ch02_vectors")
    assert {e.id for e in handed.exercises if not e.optional} == {"B2.1", "B2.2", "B2.4", "B2.5"}
    check = partial(typed, "autograder", "check", cwd=out)
    before = check()
    assert before.returncode == 1, before.stderr
    assert row(before.stdout, "B2.4").endswith("0/10")
    assert row(before.stdout, "B2.6").endswith("optional")
    assert "0 of 20 points" in before.stdout
    assert "Fix this first: B2.1" in before.stdout
    assigned = ["B2.1", "B2.2", "B2.4", "B2.5"]
    write_all(CH02, "raise NotImplementedError", out / "chapters", but=assigned)
    after = check()
    assert after.returncode == 0, after.stdout
    assert "26 of 20 points" in after.stdout
    assert "All checks of the assigned exercises pass." in after.stdout
    assert check("--exercise", "B2.6").returncode == 1, "it can be checked all the same"


def test_the_handout_for_github_classroom_names_the_points_of_both(tmp_path: Path) -> None:
    """Of 2, 3, 5 and 3 points: 4.1, 6.15, 10.25 and, as extra credit, 6.15."""
    course(tmp_path, VECTORS.replace("out_of = 20", "out_of = 20.5"))
    lab1 = ["--assignment", "lab1", "--course", tmp_path / "course.toml"]
    done = typed("autograder", "classroom", *lab1, "--out", tmp_path / "out")
    assert "4 exercises, 26 points, 6 of them as extra credit" in done.stdout, done.stderr
    page = (tmp_path / "out/README.md").read_text(encoding="utf-8")
    rows = [line.split(" | ") for line in page.splitlines() if line.startswith("| ")]
    assert [row[0].strip("| ") for row in rows[2:6]] == ["B2.1", "B2.2", "B2.4", "B2.5"]
    assert [row[2] for row in rows[2:7]] == ["4.1", "6.15", "10.25", "6.15 (extra credit)", "20.5"]
    assert [int(row[3].strip(" |")) for row in rows[2:7]] == [4, 6, 10, 6, 26]
    steps = yaml.safe_load((tmp_path / "out" / WORKFLOW).read_text(encoding="utf-8"))
    steps = steps["jobs"]["autograding"]["steps"]
    points = [step["with"]["max-score"] for step in steps if "test-name" in step.get("with", {})]
    assert points == [4, 6, 10, 6]
    assert {type(value) for value in points} == {int}
    assert "GitHub Classroom shows whole points only, so its points are rounded." in page
    whole = course(tmp_path, VECTORS)["lab1"]
    assert rounded_points(whole.chapters) == {}, "then there is one number for both"
    assert "on GitHub" not in about(whole)


def test_the_zip_for_gradescope_grades_the_assignment_with_new_numbers(tmp_path: Path) -> None:
    """Ann is one day late, even with her extension, which costs 10 percent of 20 points.

    With the course file's seed, students could copy numbers from an earlier run.
    """
    work = course(tmp_path, VECTORS.replace("out_of = 20", 'out_of = 20\nseed = "lab1"'))["lab1"]
    metadata = {
        "created_at": "2026-10-25T08:00:00.000000+01:00",
        "users": [{"name": "Ann", "email": "ann@example.org"}],
    }
    (tmp_path / "submission_metadata.json").write_text(json.dumps(metadata), encoding="utf-8")
    report = on_gradescope(work, tmp_path, ROOT / "sample_class/ada")
    assert [r.exercise.id for r in report.results] == ["B2.1", "B2.2", "B2.4", "B2.5"]
    assert (report.score, report.points, report.penalty, report.total) == (26, 20, 2, 24)
    assert gradescope_results(report)["score"] == 24
    again = grade_one(tmp_path, tmp_path / "source")
    assert len({work.seed, report.seed, again.seed}) == 3


def test_hidden_checks_go_into_the_zip_where_a_sandbox_protects_them(tmp_path: Path) -> None:
    hidden = tmp_path / "hidden/ch02_vectors"
    hidden.mkdir(parents=True)
    (hidden / "test_secret.py").write_text("", encoding="utf-8")
    work = Work("lab1", [CH02], hidden=tmp_path / "hidden")
    make_gradescope(work, tmp_path / "a.zip")
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        assert "hidden/ch02_vectors/test_secret.py" in file.namelist()
    with pytest.raises(ValueError, match="could read the hidden checks"):
        make_gradescope(work, tmp_path / "b.zip", unsafe=True)


def options(folder: Path, **changed: Any) -> argparse.Namespace:
    usual = {"assignment": None, "course": folder / "course.toml", "chapters": "", "given": ""}
    return argparse.Namespace(**{**usual, **changed})


def test_the_options_name_an_assignment_or_chapters(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    course(tmp_path, VECTORS)
    assert work_of(options(tmp_path, assignment="lab2")).chapters[0].number == 2
    with pytest.raises(ValueError, match=r"no assignment 'lab3'. It has lab1, lab2"):
        work_of(options(tmp_path, assignment="lab3"))
    with pytest.raises(ValueError, match="names the chapters: leave out 2"):
        work_of(options(tmp_path, assignment="lab1", chapters="2"))
    with pytest.raises(ValueError, match="--course needs an assignment too"):
        work_of(options(tmp_path))
    usual = options(tmp_path, course=Path("course.toml"), chapters="2-3", given="2")
    assert [chapter.number for chapter in work_of(usual).chapters] == [3]
    assert capsys.readouterr().err == ""
    monkeypatch.chdir(tmp_path)
    work_of(usual)
    assert capsys.readouterr().err.startswith("course.toml is not used, because no assignment is")
    nothing = options(tmp_path, course=Path("course.toml"))
    with pytest.raises(ValueError, match="name the chapters"):
        work_of(nothing, handed_out=True)


def test_the_exercise_of_an_earlier_assignment_is_named_first_and_earns_nothing(
    small: SmallClass,
) -> None:
    """Bob is wrong in both exercises, and Cem only in that of lab1, so that it does not matter."""
    small.write("bob/ch90_small/small.py", BOTH_WRONG)
    lab3 = course(small.folder, EARLIER.format("B90.1", "90.1"), small.root)["lab3"]
    assert small.grade(work=lab3) == 0
    assert small.scores() == {"ann": 2.0, "bob": 1.0, "cem": 2.0}
    reports = small.results()
    assert [student for student in reports if reports[student].get("causes")] == ["bob"]
    page = small.text("feedback/bob.html")
    assert f'">B90.1 of lab1</a> {ADVICE.partition("lab1 ")[2]}' in page
    assert "double must double" in page
    said = json.loads(small.text("gradescope/bob/results.json"))
    assert ADVICE in said["output"]
    assert said["score"] == 1
    assert "B90.1 of lab1: double must double" in small.printed()
    assert "B90.1" not in small.text("gradebook.csv")
    assert '<span class="id">B90.1</span> Double' in small.text("index.html")
    small.out = small.place / "whole"
    small.grade()
    assert not any("causes" in report for report in small.results().values())
    assert "earlier assignment" not in small.everything(), "whole chapters have none"
    assert "Fix <a" in small.text("feedback/bob.html")
