"""Marks given by hand: how they are read and refused, change reports, and are saved one by one."""

from __future__ import annotations

import multiprocessing
import re
from pathlib import Path

import pytest

from autograder.marking.marks_file import ChangedError, change_mark
from autograder.reports.marks import Mark, Marks, apply_marks, read_marks
from autograder.submissions.class_list import ClassList
from graded import CHAPTERS, NASTY, class_of, failed_run, report_of

PEOPLE = class_of("ada", "=1+1", "Zoe\u0301")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    file = tmp_path / "marks.csv"
    assert read_marks(file, CHAPTERS, PEOPLE)[0] == {}, "without a file there are no marks"
    return file


@pytest.mark.parametrize(
    ("written", "student", "people"),
    [
        ("'=1+1", "=1+1", PEOPLE),
        ("Zo\u00e9", "Zoe\u0301", PEOPLE),
        ("'=x", "'=x", class_of("=x", "'=x")),  # the one who is called so
    ],
)
def test_a_name_may_be_copied_from_the_gradebook_or_typed(
    file: Path, written: str, student: str, people: ClassList
) -> None:
    file.write_text(f"student,exercise,points,comment\n{written},2.3,0,\n", encoding="utf-8")
    assert read_marks(file, CHAPTERS, people)[0] == {(student, "2.3"): Mark(0.0, "")}


@pytest.mark.parametrize(
    ("row", "line", "words"),
    [
        ("bob,2.3,1,", 2, "there is no student 'bob'"),
        ("ada,2.9,1,", 2, "the exercise must be one of 2.3, got '2.9'"),
        ("ada,2.3,two,", 2, "the points for 2.3 must be a number from 0 to 3, got 'two'"),
        ("ada,2.3,nan,", 2, "got 'nan'"),
        ("ada,2.3,3.01,", 2, "got '3.01'"),
        ('ada,2.3,"2,5",', 2, "got '2,5'"),
        ("ada,2.3,1,a\n\nada,2.3,2,b", 4, "a second mark for 'ada' in 2.3, as in line 2."),
        ('ada,2.3,1,"two\nlines"\nbob,2.3,1,', 4, "no student 'bob'"),
    ],
)
def test_a_row_that_is_wrong_is_refused_with_its_place(
    file: Path, row: str, line: int, words: str
) -> None:
    file.write_text(f"student,exercise,points,comment\n{row}\n", encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(words)) as caught:
        read_marks(file, CHAPTERS, PEOPLE)
    assert f"{file}, line {line}: " in str(caught.value)


def test_another_header_is_refused(file: Path) -> None:
    file.write_text("student,points,exercise,comment\nada,2.3,1,\n", encoding="utf-8")
    with pytest.raises(ValueError, match="line 1: the header must be student,exercise,points,com"):
        read_marks(file, CHAPTERS, PEOPLE)


def test_a_mark_counts_as_points_by_hand_and_waits_no_longer() -> None:
    report = report_of()
    marked = apply_marks(report, {("ada", "2.3"): Mark(2.5, "Clear."), ("bob", "2.3"): Mark(1, "")})
    assert report == report_of(), "the report that is given stays as it is"
    why = marked.results[2]
    assert (why.status, why.score, why.comment) == ("marked", 2.5, "Clear.")
    assert (marked.by_hand, marked.waiting) == (2.5, 0)
    assert (marked.score, marked.points, marked.seed) == (3.0, 11, "7")
    assert [e.status for e in marked.results] == ["passed", "failed", "marked", "inherited"]

    assert apply_marks(marked, {}) == report_of(), "other marks start afresh"
    zero = apply_marks(marked, {("ada", "2.3"): Mark(0, "Empty.")})
    assert (zero.by_hand, zero.waiting) == (0, 0), "a zero by hand is a mark"
    failed = apply_marks(failed_run("ada"), {("ada", "2.3"): Mark(3, "")})
    assert (failed.status, failed.score, failed.by_hand) == ("error, retry", None, 3)


STUDENTS = ["ada", "bob", "=1+1", "Zoe\u0301", " cem ", NASTY]
HEADER = "student,exercise,points,comment\n"


def change(file: Path, student: str, mark: Mark | None, seen: Mark | None = None) -> None:
    change_mark(file, CHAPTERS, class_of(*STUDENTS), (student, "2.3"), mark, seen)


def read(file: Path) -> Marks:
    return read_marks(file, CHAPTERS, class_of(*STUDENTS))[0]


@pytest.mark.parametrize(
    ("text", "mark", "start"),
    [
        (
            f'{HEADER}bob,2.3,1,"by ""hand"""\nada,2.3,2,',
            Mark(1.0, 'by "hand"'),
            f'{HEADER}bob,2.3,1,"by ""hand"""\nada',
        ),
        (
            f"\ufeff{HEADER}bob,2.3,1,by hand\nada,2.3,2,\n".replace("\n", "\r\n"),
            Mark(1.0, "by hand"),
            f"\ufeff{HEADER}bob,2.3,1,by hand\nada".replace("\n", "\r\n"),
        ),
        (
            "\ufeffstudent;exercise;points;comment\nbob;2.3;1,50;by hand;;\n;;;\nada;2.3;2;\n",
            Mark(1.5, "by hand"),
            "\ufeffstudent;exercise;points;comment\nbob;2.3;1,5;by hand\nada",
        ),
        (
            'Student, Exercise ,Points,Comment,,\n\n bob ,2.3,0.125,"two\n\nlines",,\n\nada,2.3,2,',
            Mark(0.125, "two\n\nlines"),
            f'{HEADER}bob,2.3,0.125,"two\n\nlines"\nada',
        ),
    ],
    ids=["plain", "excel", "european", "untidy"],
)
def test_rows_as_spreadsheets_write_them_are_read_and_keep_what_they_say(
    file: Path, text: str, mark: Mark, start: str
) -> None:
    file.write_bytes(text.encode())
    others = {("bob", "2.3"): mark}
    assert read(file) == others | {("ada", "2.3"): Mark(2.0, "")}
    change(file, "ada", Mark(0.5, "a, b; c\nd"), Mark(2.0, ""))
    change(file, "=1+1", Mark(3.0, "Good."))
    now = file.read_bytes().decode()
    assert now.startswith(start)
    assert now.endswith("\r\n" if "\r\n" in text else "\n")
    changed = {("ada", "2.3"): Mark(0.5, "a, b; c\nd"), ("=1+1", "2.3"): Mark(3.0, "Good.")}
    assert read(file) == others | changed


@pytest.mark.parametrize("student", STUDENTS)
@pytest.mark.parametrize(
    "comment", ["", "- forgot g", "'= x", "a;=b", "x,\n y", "\uff1d1", "\x1b[31m"]
)
def test_what_is_written_is_read_again_and_is_no_formula(
    file: Path, student: str, comment: str
) -> None:
    change(file, student, Mark(1.0, comment))
    assert read(file) == {(student, "2.3"): Mark(1.0, comment.replace("\x1b", "\\x1b"))}
    row = file.read_bytes().decode().removeprefix(HEADER)
    assert not row.startswith(("=", "-", "+", "@"))
    assert not row.split(",1,")[1].lstrip('"').startswith(("=", "-", "+", "@", "\uff1d"))


def test_a_mark_that_somebody_else_has_changed_is_not_overwritten(file: Path) -> None:
    file.write_text(f"{HEADER}ada,2.3,1,Why?\n", encoding="utf-8")
    for new in (Mark(3.0, ""), None):
        with pytest.raises(ChangedError, match=r"It gives 1 points\. Why\?"):
            change(file, "ada", new, Mark(2.0, ""))
    with pytest.raises(ChangedError, match="It is gone"):
        change(file, "bob", Mark(3.0, ""), Mark(2.0, ""))
    assert read(file) == {("ada", "2.3"): Mark(1.0, "Why?")}


def test_a_file_with_a_mistake_stays_as_it_is(file: Path) -> None:
    text = f"{HEADER}ada,2.3,9,\n"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"line 2: .* '9'"):
        change(file, "bob", Mark(1.0, ""))
    assert file.read_bytes().decode() == text


def test_a_link_to_the_file_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "class").mkdir()
    (tmp_path / "class/marks.csv").symlink_to(tmp_path / "kept.csv")
    change(tmp_path / "class/marks.csv", "ada", Mark(1.0, ""))
    assert (tmp_path / "class/marks.csv").is_symlink()
    assert (tmp_path / "kept.csv").read_text(encoding="utf-8") == f"{HEADER}ada,2.3,1,\n"


def give(path: Path, students: list[str], mine: list[str]) -> None:
    for student in mine:
        who = (student, "2.3")
        change_mark(path, CHAPTERS, class_of(*students), who, Mark(1.0, student), None)


def test_two_programs_lose_no_mark_of_each_other(file: Path) -> None:
    students = [f"s{i:02}" for i in range(30)]
    context = multiprocessing.get_context("fork")
    arguments = [(file, students, students[i::3]) for i in range(3)]
    processes = [context.Process(target=give, args=mine) for mine in arguments]
    for process in processes:
        process.start()
    for process in processes:
        process.join()
        assert process.exitcode == 0
    marks = read_marks(file, CHAPTERS, class_of(*students))[0]
    assert marks == {(s, "2.3"): Mark(1.0, s) for s in students}
