"""An assignment of a course, graded and handed out: its exercises count, in its points."""

from __future__ import annotations

import argparse
import csv
import json
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from autograder.checks.verdict import Verdict
from autograder.course.choose import work_of
from autograder.course.handout import about, for_students
from autograder.course.model import Work
from autograder.course.reading import read_course
from autograder.grader.cohort import ClassOptions
from autograder.grader.cohort import grade as grade_class
from autograder.handouts.stubs import messages_of, without_bodies
from autograder.instructor import run_handout
from autograder.isolation.probe import best_level
from autograder.manifest import ROOT, load_chapter, load_chapters
from autograder.platforms.classroom import in_whole_points, rounded_points, workflow
from autograder.platforms.grade_one import grade_one
from autograder.platforms.gradescope import make_gradescope
from autograder.reports.gradescope import gradescope_results
from autograder.scores import results_of
from autograder.student.chapter_results import ChapterResults
from autograder.student.points import points_of
from autograder.student.screen import first_open
from copies import copy_tree
from small import RIGHT, WRITTEN, hand_in, make_root
from small_class import HALF, results, scores
from typed import typed

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


def course(folder: Path, text: str, root: Path = ROOT) -> dict[str, Work]:
    folder.mkdir(exist_ok=True)
    path = folder / "course.toml"
    path.write_text(text, encoding="utf-8")
    return {work.name: work for work in read_course(path, root).assignments}


@pytest.fixture
def root(tmp_path: Path) -> Path:
    made = make_root(tmp_path / "root")
    manifest = made / "chapters/ch90_small/chapter.toml"
    manifest.write_text(manifest.read_text(encoding="utf-8") + WRITTEN, encoding="utf-8")
    return made


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a class: right, half right, and wrong only in what lab2 does not grade."""
    folder = tmp_path / "class"
    hand_in(folder, "ann", RIGHT)
    hand_in(folder, "bob", HALF)
    hand_in(folder, "cem", RIGHT.replace("x + x", "x"))
    return folder


def grade(submissions: Path, out: Path, root: Path, work: Work) -> list[dict[str, str]]:
    """Grade a class and return the rows of the gradebook."""
    options = ClassOptions(seed="1", root=root, unsafe=True, deadline=work.deadline)
    assert grade_class(submissions, out, work.chapters, options) == 0
    with (out / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_only_the_assigned_exercises_count_and_lateness_has_columns_of_its_own(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two and three points become 4 and 6. Bob is two days late, and Cem's time is unknown."""
    times = "student,submitted\nann,2026-10-23 20:00\nbob,2026-10-25T20:00:00Z\n"
    (submissions / "times.csv").write_text(times, encoding="utf-8")
    marks = "student,exercise,points,comment\nann,90.2,1.5,half\nbob,90.2,3,all\n"
    (submissions / "marks.csv").write_text(marks, encoding="utf-8")
    out = tmp_path / "out"
    work = course(submissions, SMALL, root)["lab2"]
    rows = grade(submissions, out, root, work)
    columns = ["score", "by hand", "waiting", "points", "late days", "penalty", "total"]
    columns += ["90.1", "90.2"]
    assert {row["student"]: [row[column] for column in columns] for row in rows} == {
        "points possible": ["4", "6", "", "10", "", "", "10", "4", "6"],
        "ann": ["4", "3", "0", "7", "0", "0", "7", "4", "3"],
        "bob": ["2", "6", "0", "8", "2", "3", "5", "2", "6"],
        "cem": ["4", "", "6", "4", "", "0", "4", "4", ""],
    }
    assert [e["id"] for e in results(out)["cem"]["exercises"]] == ["90.1", "90.2"]
    page = (out / "feedback/bob.html").read_text(encoding="utf-8")
    for words in ("Points earned: 8.", "Late penalty: 3.", "2026-10-23 23:59", "costs 1.5 points"):
        assert words in page
    assert "B90.1" not in page
    said = json.loads((out / "gradescope/bob/results.json").read_text(encoding="utf-8"))
    assert said["score"] == 5
    assert "late penalty: 3 points. It was due" in said["output"]
    assert "total: 8 - 3 = 5 points" in said["output"]
    screen = " ".join(capsys.readouterr().out.split())
    assert "therefore get no penalty: cem." in screen
    assert "The points in this table are from checks alone. The totals, which include" in screen
    (submissions / "times.csv").unlink()
    (submissions / "cem_LATE_1_2_x").mkdir()
    again = {row["student"]: row for row in grade(submissions, out, root, work)}
    assert "3 of 4 reports" in capsys.readouterr().out
    assert [again["bob"][column] for column in ("points", "late days", "total")] == ["8", "", "8"]


def test_extra_credit_counts_above_the_total(submissions: Path, root: Path, tmp_path: Path) -> None:
    """Four points are possible, and two more can be earned. The gradebook has no late columns."""
    out = tmp_path / "out"
    rows = grade(submissions, out, root, course(submissions, SMALL, root)["lab1"])
    assert scores(out) == {"ann": 6, "bob": 5, "cem": 3}  # a zero doubles rightly, too
    assert rows[0]["score"] == rows[0]["total"] == "4"
    assert "penalty" not in rows[0]
    assert results(out)["ann"]["points"] == 4
    assert "extra credit" in (out / "feedback/ann.html").read_text(encoding="utf-8")
    said = json.loads((out / "gradescope/ann/results.json").read_text(encoding="utf-8"))
    assert [(t["number"], t["score"], t["max_score"]) for t in said["tests"]] == [
        ("B90.1", 4, 4),
        ("90.1", 2, 0),
    ]
    other_points = course(submissions, SMALL.replace('"B90.1"]', '"B90.1"]\nout_of = 8'), root)
    grade(submissions, out, root, other_points["lab1"])
    assert scores(out)["ann"] == 12, "and no report of the other points is kept"


def half_done(out: Path, assigned: set[str]) -> None:
    """Write the assigned bodies of chapter 2 into a handout, and no others."""
    source = (ROOT / "solutions/ch02_vectors/vector.py").read_bytes()
    titles = {f"Exercise {e.id}: {e.title}" for e in CH02.exercises if e.id in assigned}
    left = {n: m for n, m in messages_of(CH02, "vector.py").items() if m not in titles}
    (out / "chapters/ch02_vectors/vector.py").write_bytes(without_bodies(source, left))


def check(out: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-P", "-m", "autograder", "check", *arguments],
        cwd=out,
        env={"PYTHONPATH": ".", "PYTHONUTF8": "1"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


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
    before = check(out)
    assert before.returncode == 1, before.stderr
    assert row(before.stdout, "B2.4").endswith("0/10")
    assert row(before.stdout, "B2.6").endswith("optional")
    assert "0 of 20 points" in before.stdout
    assert "Fix this first: B2.1" in before.stdout
    half_done(out, {"B2.1", "B2.2", "B2.4", "B2.5"})
    after = check(out)
    assert after.returncode == 0, after.stdout
    assert "26 of 20 points" in after.stdout
    assert "All checks of the assigned exercises pass." in after.stdout
    assert check(out, "--exercise", "B2.6").returncode == 1, "it can be checked all the same"


def test_a_hand_out_names_what_earlier_assignments_must_have_left(tmp_path: Path) -> None:
    work = course(tmp_path, VECTORS)["lab2"]
    assert "builds on exercises of earlier ones: B2.1, B2.2, B2.4.\n" in about(work)
    handed = for_students(CH02, work.chapters[0])
    points = {r.exercise.id: points_of(handed, r) for r in results_of(handed, [])}
    assert [name for name, words in points.items() if words == "needed"] == ["B2.1", "B2.2", "B2.4"]
    assert [name for name, words in points.items() if "/" in words] == ["2.1", "2.4"]
    verdicts = [
        Verdict("test", e.id, 1, "failed" if e.id in ("B2.3", "B2.4", "2.1") else "passed")
        for e in handed.exercises
    ]
    first = first_open([ChapterResults(handed, results_of(handed, verdicts), [], [])], None)
    assert first is not None
    assert first[1].exercise.id == "B2.4", "B2.3 is optional, and 2.1 needs B2.4"


def test_the_workflow_for_github_classroom_has_whole_points(tmp_path: Path) -> None:
    text = VECTORS.replace("out_of = 20", "out_of = 20.5")
    chapters = in_whole_points(course(tmp_path, text)["lab1"].chapters)
    steps = workflow(chapters)["jobs"]["autograding"]["steps"]
    points = [step["with"]["max-score"] for step in steps if "test-name" in step.get("with", {})]
    # Of 2, 3, 5 and 3: 4.1, 6.15, 10.25 and, as extra credit, 6.15.
    assert points == [4, 6, 10, 6]
    assert {type(value) for value in points} == {int}


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
    assert "GitHub Classroom shows whole points only, so its points are rounded." in page
    whole = course(tmp_path, VECTORS)["lab1"]
    assert rounded_points(whole.chapters) == {}, "then there is one number for both"
    assert "on GitHub" not in about(whole)


def test_the_zip_for_gradescope_grades_the_assignment(tmp_path: Path) -> None:
    """Ann has an extension of a day, so her work is one day late and costs 10 percent of 20."""
    walls = best_level().is_sandbox
    work = course(tmp_path, VECTORS)["lab1"]
    make_gradescope(work, tmp_path / "a.zip", unsafe=not walls)
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        file.extractall(tmp_path / "source")
    copy_tree(ROOT / "sample_class/ada/ch02_vectors", tmp_path / "submission/ch02_vectors")
    metadata = {
        "created_at": "2026-10-25T08:00:00.000000+01:00",
        "users": [{"name": "Ann", "email": "ann@example.org"}],
    }
    (tmp_path / "submission_metadata.json").write_text(json.dumps(metadata), encoding="utf-8")
    report = grade_one(tmp_path, tmp_path / "source")
    assert [e.id for e in report.exercises] == ["B2.1", "B2.2", "B2.4", "B2.5"]
    assert (report.score, report.points, report.penalty, report.total) == (26, 20, 2, 24)
    assert gradescope_results(report).score == 24


def test_a_run_on_gradescope_ignores_the_seed_of_the_course_file(tmp_path: Path) -> None:
    """Otherwise students could copy the numbers from the results of an earlier run."""
    text = '[[assignment]]\nname = "lab1"\nexercises = ["B2.1"]\nseed = "lab1"'
    work = course(tmp_path, text)["lab1"]
    assert work.seed == "lab1"
    make_gradescope(work, tmp_path / "a.zip", unsafe=not best_level().is_sandbox)
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        file.extractall(tmp_path / "source")
    (tmp_path / "submission").mkdir()
    seeds = [grade_one(tmp_path, tmp_path / "source").seed for _ in range(2)]
    assert len({*seeds, "lab1"}) == 3


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
    with pytest.raises(ValueError, match=r"no assignment 'lab3'. Did you mean lab2 or lab1\?"):
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


def test_the_command_grades_an_assignment_and_lists_the_mistakes_of_its_file(
    tmp_path: Path,
) -> None:
    course(tmp_path, VECTORS)
    copy_tree(ROOT / "sample_class/dina", tmp_path / "class/dina")
    command = ["autograder", "grade", tmp_path / "class", "--out", tmp_path / "out"]
    command += ["--course", tmp_path / "course.toml", "--assignment", "lab1", "--unsafe-no-sandbox"]
    done = typed(*command)
    assert done.returncode == 0, done.stderr
    assert "0/20" in done.stdout
    wrong = VECTORS.replace("B2.5", "B2.55").replace("out_of = 20", "out_of = -20")
    (tmp_path / "course.toml").write_text(wrong, encoding="utf-8")
    shutil.rmtree(tmp_path / "out")
    done = typed(*command)
    assert done.returncode == 2
    assert done.stderr.startswith(f"grade: {tmp_path / 'course.toml'} has ")
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()
