"""No command replaces grades or files that it did not make, and no student stops the others."""

from __future__ import annotations

import multiprocessing
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.course.model import Work
from autograder.grader import class_run
from autograder.manifest import ROOT, load_chapters, select_chapters
from autograder.marking.marked_answers import MarkedAnswers
from autograder.platforms.gradescope import make_gradescope
from autograder.reports.marks import Mark
from autograder.reports.report import StudentReport
from autograder.similarity.run import similarity
from autograder.submissions.unpack import class_folder
from small import MANIFEST, WRITTEN, hand_in, make_root
from small_class import SmallClass, everything_in, grade, make_class, results, table
from typed import typed

MARKS = "student,exercise,points,comment\n"


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


def answer(folder: Path, text: str) -> None:
    heading = "## 90.2 Why\n\n> Why?\n\n"
    (folder / "ch90_small/answers.md").write_text(f"{heading}{text}\n", encoding="utf-8")


def test_the_grades_of_another_class_or_assignment_are_never_replaced(small: SmallClass) -> None:
    other = small.place / "other"
    small.grade(name="lab1")
    before = small.everything()
    hand_in(other, "ann", "x = 1\n")
    for folder, assignment, words in (
        (other, "lab1", f"the grades of the class in {small.folder}, and not in {other}"),
        (ROOT / "sample_class", "lab1", "sample_class"),
        (small.folder, "lab2", "the grades of lab1, and not of lab2"),
        (small.folder, "", "the grades of lab1, and not of chapters 90"),
    ):
        with pytest.raises(ValueError, match="add another --out") as caught:
            grade(folder, small.out, small.root, name=assignment)
        assert words in str(caught.value)
        assert small.everything() == before


def test_the_grades_of_other_chapters_are_never_replaced(small: SmallClass) -> None:
    small.grade()
    before = small.everything()
    newer = make_class(small.place / "class (1)")  # which has no marks.csv
    with pytest.raises(ValueError, match=r"newer download .* of the older one, class, so"):
        grade(newer, small.out, small.root)
    for work, words in (
        ({"given": select_chapters("2")}, "chapters 90 on given chapters 2. To keep"),
        ({"chapters": select_chapters("2")}, "chapters 2. To keep them"),
    ):
        with pytest.raises(ValueError, match=f"the grades of chapters 90, and not of {words}"):
            small.grade(**work)
    assert small.everything() == before


@pytest.mark.parametrize(
    ("place", "complaint"),
    [
        (".", "must not be the folder of the class"),
        ("ann/grades", "must not be inside the submission"),
        ("../website", r"has other files, such as index.html. Name another one"),
    ],
)
def test_reports_do_not_go_among_submissions_or_other_files(
    small: SmallClass, place: str, complaint: str
) -> None:
    website = small.folder / "../website"
    website.mkdir()
    (website / "index.html").write_text("mine", encoding="utf-8")
    with pytest.raises(ValueError, match=complaint):
        grade(small.folder, small.folder / place, small.root)
    with pytest.raises(ValueError, match=r"it has other files. Name another one"):
        similarity(small.folder, website, load_chapters(small.root), root=small.root)
    assert everything_in(website) == "mine"


def test_the_zip_for_gradescope_replaces_only_an_earlier_one(tmp_path: Path) -> None:
    work, out = Work("", select_chapters("2")), tmp_path / "lab1.zip"
    for content in ("text", "zip"):
        out.write_text(content, encoding="utf-8")
        if content == "zip":
            with zipfile.ZipFile(out, "w") as file:
                file.writestr("ann/work.py", "x = 1")
        before = out.read_bytes()
        with pytest.raises(ValueError, match=r"lab1.zip is another file, such as a download of su"):
            make_gradescope(work, out)
        assert out.read_bytes() == before
    for _ in range(2):
        make_gradescope(work, tmp_path / "autograder.zip")


def test_the_command_grades_the_same_class_again_and_never_guesses_one(tmp_path: Path) -> None:
    """It takes the same chapters, and never an older zip."""
    out, zipped = tmp_path / "out", tmp_path / "lab1.zip"

    def download(*students: str) -> None:
        with zipfile.ZipFile(zipped, "w") as file:
            for student in students:
                file.writestr(f"{student}/ch02_vectors/vector.py", "x = 1\n")

    command, course = ("autograder", "grade", "--out", out), tmp_path / "course.toml"
    course.write_text('[[assignment]]\nname = "lab1"\nexercises = ["B2.1"]\n', encoding="utf-8")
    done = typed(*command, "--assignment", "lab1", "--course", course)
    assert (done.returncode, out.exists()) == (2, False)
    assert "name the folder or the zip of the submissions (make: SUBMISSIONS=" in done.stderr
    download("ann")
    first = typed(*command, zipped, "--chapters", "2")
    assert first.returncode == 0, first.stderr
    download("ann", "bob")
    newer = typed(*command)
    assert (newer.returncode, "lab1.zip has changed since it was unp" in newer.stderr) == (2, True)
    assert typed(*command, zipped, "--chapters", "2").returncode == 0
    again = typed(*command, "--student", "Ann", "--note", 'it\'s "$5"')
    assert again.returncode == 0, again.stderr
    assert f"grading the class in {tmp_path / 'lab1'} again" in again.stdout
    assert table(out / "regrades.csv")[0]["why"] == 'it\'s "$5"'
    _, *rows = table(out / "gradebook.csv")
    assert [row["student"] for row in rows] == ["ann", "bob"]
    assert not any(name.startswith("B3.") for name in rows[0]), "only chapter 2"


def test_a_mark_stays_when_its_submission_goes(small: SmallClass) -> None:
    small.write("marks.csv", f"{MARKS}ann,90.2,2,\nbob,90.2,1,\n")
    small.grade()
    (small.folder / "bob").rename(small.place / "bob")
    small.printed()
    for _ in range(2):  # bob's report is in earlier/ the second time
        assert small.grade() == 0
        assert "bob handed in nothing, so the marks are not used" in small.printed()
    assert (small.out / "earlier/results/bob.json").exists()
    assert small.results()["ann"]["by_hand"] == 2


def test_a_mark_for_an_exercise_that_is_not_graded_here_is_reported(small: SmallClass) -> None:
    small.write("marks.csv", f"{MARKS}ann,90.2,2,\n")
    (chapter,) = load_chapters(small.root)
    part = replace(chapter, exercises=[e for e in chapter.exercises if e.id != "90.2"])
    assert small.grade(chapters=[part]) == 0
    assert "Marks for exercises that are not graded here: 1 (90.2)." in small.printed()


def test_a_report_that_cannot_be_written_stops_nobody_else(
    small: SmallClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = class_run.write_student

    def fails_for_bob(out: Path, report: StudentReport) -> None:
        if report.student == "bob":
            raise OSError("no space")
        write(out, report)

    monkeypatch.setattr(class_run, "write_student", fails_for_bob)
    assert small.grade() == 1
    assert set(small.scores()) == {"ann", "cem"}
    book = (small.place / "out/gradebook.csv").read_text(encoding="utf-8")
    assert 'bob,"error, retry"' in book
    monkeypatch.undo()
    assert small.grade(seed=None) == 0
    assert set(small.scores()) == {"ann", "bob", "cem"}


def test_an_answer_that_changes_after_it_was_marked_is_reported(small: SmallClass) -> None:
    answer(small.folder / "ann", "Because it is small.")
    answer(small.folder / "bob", "Because I say so.")
    marks = small.folder / "marks.csv"
    text = f"{MARKS}ann,90.2,2,\nbob,90.2,1,Why?\n"
    marks.write_text(text, encoding="utf-8")

    def states() -> dict[str, tuple[str, float]]:
        small.printed()
        small.grade()
        reports = small.results()
        return {
            student: (written["status"], written["score"])
            for student in ("ann", "bob")
            for written in reports[student]["results"]
            if written["exercise"]["id"] == "90.2"
        }

    assert states() == {"ann": ("marked", 2.0), "bob": ("marked", 1.0)}
    answer(small.folder / "bob", "Because of the definition.")
    assert states() == {"ann": ("marked", 2.0), "bob": ("changed", 1.0)}
    said = "Answers that have changed since they were marked: 1 (bob 90.2)."
    assert said in small.printed()
    for file, words in (
        ("gradebook.csv", "bob,graded; changed since marked: 90.2,"),
        ("feedback/bob.html", "has changed since a person marked it"),
    ):
        assert words in small.text(file)
    marks.write_text(text.replace("bob,90.2,1,Why?", "bob,90.2,3,"), encoding="utf-8")
    assert states()["bob"] == ("marked", 3.0), "a new mark is for the new answer"


def test_reports_inside_the_folder_of_the_class_are_no_student(small: SmallClass) -> None:
    for _ in range(2):
        assert grade(small.folder, small.folder / "grades", small.root) == 0
    small.printed()
    grade(small.folder, small.place / "other", small.root)
    for out in (small.folder / "grades", small.place / "other"):
        assert set(results(out)) == {"ann", "bob", "cem"}
    assert "grades was left out: it has the reports of a graded class" in small.printed()


def test_a_report_that_is_kept_names_what_was_not_graded_today(small: SmallClass) -> None:
    (small.folder / "dan.pdf").touch()
    small.grade()
    (small.folder / "ann.pdf").touch()
    (small.folder / "dan.pdf").rename(small.folder / "dan.rar")
    small.grade()
    assert small.results()["ann"]["notes"] == [
        "'ann' was graded, and 'ann.pdf' was not: it is neither a folder nor a .zip file"
    ]
    assert "'dan.rar' cannot be graded" in small.results()["dan"]["nothing"]
    (small.folder / "ann.pdf").unlink()
    small.grade()
    assert small.results()["ann"].get("notes", []) == []


def test_the_marking_page_and_the_grader_keep_each_others_records(tmp_path: Path) -> None:
    mark = Mark(1.0, "")
    page, grader = MarkedAnswers(tmp_path), MarkedAnswers(tmp_path)
    page.mark_now("ann", "90.2", mark, "old")
    assert not grader.is_changed("bob", "90.2", mark, "old")
    grader.save()
    page.mark_now("cem", "90.2", mark, "old")
    now = MarkedAnswers(tmp_path)
    assert all(now.is_changed(student, "90.2", mark, "new") for student in ("ann", "bob", "cem"))


def test_no_run_drops_the_roster_in_silence(small: SmallClass) -> None:
    roster, small.out = small.place / "roster.csv", small.out
    roster.write_text("id,name,email,login\nbob,Bob Ray,,\n9,Zed,,\n", encoding="utf-8")
    small.grade()
    small.grade(roster=roster)  # which may come later
    before = small.everything()
    for student in (None, "bob"):
        with pytest.raises(
            ValueError, match=r"with a roster: add --roster .* without, add another"
        ):
            small.grade(student=student)
    assert small.everything() == before, "as if canvas.csv had today's grades"


def unpacked_into(zipped: Path, found: Path) -> None:
    folder = class_folder(zipped)
    found.write_text(str(len([*folder.glob("*/work.py")])), encoding="utf-8")


def test_two_commands_that_unpack_one_zip_both_find_everything(tmp_path: Path) -> None:
    zipped = tmp_path / "lab1.zip"
    with zipfile.ZipFile(zipped, "w") as file:
        for number in range(300):
            file.writestr(f"student {number}/work.py", "x = 1\n")
    context = multiprocessing.get_context("fork")
    found = [tmp_path / f"found{i}" for i in range(4)]
    runs = [context.Process(target=unpacked_into, args=(zipped, path)) for path in found]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
        assert run.exitcode == 0
    assert {path.read_text(encoding="utf-8") for path in found} == {"300"}
