"""marks.csv is changed mark by mark, and nothing that somebody wrote there is lost."""

from __future__ import annotations

import multiprocessing
from pathlib import Path

import pytest

from autograder.marking.marks_file import ChangedError, change_mark
from autograder.reports.marks import Mark, Marks, read_marks
from graded import CHAPTERS, NASTY, class_of

STUDENTS = ["ada", "bob", "=1+1", "-x", "Zoe\u0301", " cem ", NASTY]
HEADER = "student,exercise,points,comment\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "marks.csv"


def change(file: Path, student: str, mark: Mark | None, seen: Mark | None = None) -> None:
    change_mark(file, CHAPTERS, class_of(*STUDENTS), (student, "2.3"), mark, seen)


def read(file: Path) -> Marks:
    return read_marks(file, CHAPTERS, class_of(*STUDENTS))[0]


def test_a_file_is_made_with_the_first_mark(file: Path) -> None:
    change(file, "ada", Mark(2.5, "Say why."))
    assert file.read_bytes().decode() == f"{HEADER}ada,2.3,2.5,Say why.\n"
    change(file, "ada", None, Mark(2.5, "Say why."))
    assert file.read_bytes().decode() == HEADER


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
    "comment", ["", "- forgot g", "'= x", "'", "=1+1", "a;=b", '"', "x,\n y", "\uff1d1", "\x1b[31m"]
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
