"""No command replaces grades that it did not make, and no student stops the others."""

from __future__ import annotations

import csv
import multiprocessing
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.grader import class_run, cohort
from autograder.grader.cohort import ClassOptions
from autograder.manifest import ROOT, load_chapters
from autograder.marking.marked_answers import MarkedAnswers
from autograder.reports.marks import Mark
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import read_class
from autograder.submissions.codes import with_codes
from small import MANIFEST, RIGHT, WRITTEN, hand_in, make_root
from small_class import everything_in, grade, make_class, results, scores
from typed import typed


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


def answer(folder: Path, text: str) -> None:
    heading = "## 90.2 Why\n\n> Why?\n\n"
    (folder / "ch90_small/answers.md").write_text(f"{heading}{text}\n", encoding="utf-8")


def test_the_grades_of_another_class_or_assignment_are_never_replaced(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    out, other = tmp_path / "out", tmp_path / "other"
    grade(submissions, out, root, assignment="lab1")
    before = everything_in(out)
    hand_in(other, "ann", "x = 1\n")
    for folder, assignment, words in (
        (other, "lab1", f"the grades of the class in {submissions}, and not in {other}"),
        (ROOT / "sample_class", "lab1", "sample_class"),
        (submissions, "lab2", "the grades of lab1, and not of lab2"),
        (submissions, "", "the grades of lab1, and not of chapters 90"),
    ):
        with pytest.raises(ValueError, match="add another --out") as caught:
            grade(folder, out, root, assignment=assignment)
        assert words in str(caught.value)
        assert everything_in(out) == before
    submissions.rename(tmp_path / "moved")
    with pytest.raises(ValueError, match="the grades of lab1, and not of lab2"):
        grade(tmp_path / "moved", out, root, assignment="lab2")
    assert grade(tmp_path / "moved", out, root, assignment="lab1") == 0, "the same class"


def test_a_newer_download_under_another_name_is_told_to_take_the_old_one(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    grade(submissions, tmp_path / "out", root)
    newer = make_class(tmp_path / "class (1)")  # which has no marks.csv
    with pytest.raises(ValueError, match=r"newer download .* of the older one, class, so"):
        grade(newer, tmp_path / "out", root)


def test_a_folder_that_was_moved_does_not_let_another_class_in(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    out, other = tmp_path / "out", tmp_path / "other"
    grade(submissions, out, root)
    submissions.rename(tmp_path / "moved")
    for student in ("ann", "zoe", "yan"):  # only one of the three who were graded
        hand_in(other, student, RIGHT)
    with pytest.raises(ValueError, match="the grades of the class in"):
        grade(other, out, root)


def test_the_command_grades_the_same_class_again_and_never_guesses_one(tmp_path: Path) -> None:
    course, out = tmp_path / "course.toml", tmp_path / "out"
    course.write_text('[[assignment]]\nname = "lab1"\nexercises = ["B2.1"]\n', encoding="utf-8")
    command = ("autograder", "grade", "--out", out, "--assignment", "lab1", "--course", course)
    done = typed(*command)
    assert (done.returncode, out.exists()) == (2, False)
    assert "name the folder or the zip of the submissions (make: SUBMISSIONS=" in done.stderr
    submission = tmp_path / "class/ann/ch02_vectors"
    submission.mkdir(parents=True)
    (submission / "vector.py").write_text("x = 1\n", encoding="utf-8")
    (command_with_class := [*command]).insert(2, tmp_path / "class")
    assert typed(*command_with_class).returncode == 0
    again = typed(*command, "--student", "Ann", "--note", 'it\'s "$5"')
    assert again.returncode == 0, again.stderr
    assert f"grading the class in {tmp_path / 'class'} again" in again.stdout
    assert (
        list(csv.reader((out / "regrades.csv").read_text(encoding="utf-8").splitlines()))[1][5]
        == 'it\'s "$5"'
    )


def test_a_mark_stays_when_its_submission_goes(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    marks = "student,exercise,points,comment\nann,90.2,2,\nbob,90.2,1,\n"
    (submissions / "marks.csv").write_text(marks, encoding="utf-8")
    grade(submissions, out, root)
    (submissions / "bob").rename(tmp_path / "bob")
    capsys.readouterr()
    for _ in range(2):  # bob's report is in earlier/ the second time
        assert grade(submissions, out, root) == 0
        assert "bob handed in nothing, so the marks are not used" in capsys.readouterr().out
    assert (out / "earlier/results/bob.json").exists()
    assert results(out)["ann"]["by_hand"] == 2


def test_a_report_that_cannot_be_written_stops_nobody_else(
    submissions: Path, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = class_run.write_student

    def fails_for_bob(out: Path, report: StudentReport) -> None:
        if report.student == "bob":
            raise OSError("no space")
        write(out, report)

    monkeypatch.setattr(class_run, "write_student", fails_for_bob)
    assert grade(submissions, tmp_path / "out", root) == 1
    assert set(scores(tmp_path / "out")) == {"ann", "cem"}
    book = (tmp_path / "out/gradebook.csv").read_text(encoding="utf-8")
    assert 'bob,"error, retry"' in book
    monkeypatch.undo()
    assert grade(submissions, tmp_path / "out", root, seed=None) == 0
    assert set(scores(tmp_path / "out")) == {"ann", "bob", "cem"}


def test_an_answer_that_changes_after_it_was_marked_is_reported(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    answer(submissions / "ann", "Because it is small.")
    answer(submissions / "bob", "Because I say so.")
    marks = submissions / "marks.csv"
    text = "student,exercise,points,comment\nann,90.2,2,\nbob,90.2,1,Why?\n"
    marks.write_text(text, encoding="utf-8")

    def states() -> dict[str, tuple[str, float]]:
        capsys.readouterr()
        grade(submissions, out, root, roster=None)
        reports = results(out)
        found = {}
        for student in ("ann", "bob"):
            (written,) = [
                one for one in reports[student]["results"] if one["exercise"]["id"] == "90.2"
            ]
            found[student] = (written["status"], written["score"])
        return found

    assert states() == {"ann": ("marked", 2.0), "bob": ("marked", 1.0)}
    answer(submissions / "bob", "Because of the definition.")
    assert states() == {"ann": ("marked", 2.0), "bob": ("changed", 1.0)}
    assert "Answers that have changed since they were marked: 1 (bob 90.2)." in (
        capsys.readouterr().out
    )
    assert "bob,graded; changed since marked: 90.2," in (out / "gradebook.csv").read_text(
        encoding="utf-8"
    )
    assert "has changed since a person marked it" in (out / "feedback/bob.html").read_text(
        encoding="utf-8"
    )
    marks.write_text(text.replace("bob,90.2,1,Why?", "bob,90.2,3,"), encoding="utf-8")
    assert states()["bob"] == ("marked", 3.0), "a new mark is for the new answer"


def test_a_mark_for_an_exercise_that_is_not_graded_here_is_reported(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (submissions / "marks.csv").write_text(
        "student,exercise,points,comment\nann,90.2,2,\n", encoding="utf-8"
    )
    (chapter,) = load_chapters(root)
    part = replace(chapter, exercises=[e for e in chapter.exercises if e.id != "90.2"])
    options = ClassOptions(seed="1", root=root, unsafe=True)
    assert cohort.grade(submissions, tmp_path / "out", [part], options) == 0
    assert "Marks for exercises that are not graded here: 1 (90.2)." in capsys.readouterr().out


def code_of(folder: Path, key: Path, found: str) -> None:
    people = with_codes(read_class(folder), key)
    Path(found).write_text(people.submissions[0].student, encoding="utf-8")


def test_two_first_runs_with_codes_use_one_secret(submissions: Path, tmp_path: Path) -> None:
    context = multiprocessing.get_context("fork")
    key = tmp_path / "roster-key.csv"
    found = [str(tmp_path / f"found{i}") for i in range(6)]
    runs = [context.Process(target=code_of, args=(submissions, key, path)) for path in found]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
        assert run.exitcode == 0
    assert len({Path(path).read_text(encoding="utf-8") for path in found}) == 1


def test_reports_inside_the_folder_of_the_class_are_no_student(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    grade(submissions, submissions / "grades", root)
    capsys.readouterr()
    grade(submissions, tmp_path / "other", root)
    assert set(scores(tmp_path / "other")) == {"ann", "bob", "cem"}
    assert "grades was left out: it has the reports of a graded class" in capsys.readouterr().out


def test_a_report_that_is_kept_names_what_was_not_graded_today(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    (submissions / "dan.pdf").touch()
    grade(submissions, out, root)
    (submissions / "ann.pdf").touch()
    (submissions / "dan.pdf").rename(submissions / "dan.rar")
    grade(submissions, out, root)
    assert results(out)["ann"]["notes"] == [
        "'ann' was graded, and 'ann.pdf' was not: it is neither a folder nor a .zip file"
    ]
    assert "'dan.rar' cannot be graded" in results(out)["dan"]["nothing"]
    (submissions / "ann.pdf").unlink()
    grade(submissions, out, root)
    assert results(out)["ann"].get("notes", []) == []


def test_the_marking_page_and_the_grader_keep_each_others_records(tmp_path: Path) -> None:
    mark = Mark(1.0, "")
    page, grader = MarkedAnswers(tmp_path), MarkedAnswers(tmp_path)
    page.mark_now("ann", "90.2", mark, "old")
    assert not grader.is_changed("bob", "90.2", mark, "old")
    grader.save()
    page.mark_now("cem", "90.2", mark, "old")
    now = MarkedAnswers(tmp_path)
    assert all(now.is_changed(student, "90.2", mark, "new") for student in ("ann", "bob", "cem"))


def test_names_do_not_go_among_codes(submissions: Path, root: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    grade(submissions, out, root, anonymous=True)
    before = everything_in(out)
    with pytest.raises(
        ValueError, match="chapters 90 with codes for names, and not of chapters 90"
    ):
        grade(submissions, out, root)
    assert everything_in(out) == before


def test_no_run_drops_the_roster_in_silence(submissions: Path, root: Path, tmp_path: Path) -> None:
    roster, out = tmp_path / "roster.csv", tmp_path / "out"
    roster.write_text("id,name,email,login\nbob,Bob Ray,,\n9,Zed,,\n", encoding="utf-8")
    grade(submissions, out, root)
    grade(submissions, out, root, roster=roster)  # which may come later
    before = everything_in(out)
    with pytest.raises(
        ValueError, match=r"with a roster: add --roster .* without one, add another"
    ):
        grade(submissions, out, root)
    assert everything_in(out) == before, "as if canvas.csv had today's grades"
