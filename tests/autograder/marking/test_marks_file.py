"""marks.csv is changed mark by mark, and nothing that somebody wrote there is lost."""

from __future__ import annotations

import multiprocessing
from pathlib import Path

import pytest

from autograder.marking.marks_file import ChangedError, MarksFile
from autograder.reports.marks import Mark, read_marks
from graded import CHAPTERS, NASTY, class_of

STUDENTS = ["ada", "bob", "=1+1", "-x", "Zoe\u0301", " cem ", NASTY]
HEADER = "student,exercise,points,comment\n"


@pytest.fixture
def marks(tmp_path: Path) -> MarksFile:
    return MarksFile(tmp_path / "marks.csv", CHAPTERS, class_of(*STUDENTS))


def text_of(marks: MarksFile) -> str:
    return marks.path.read_bytes().decode()


def test_a_file_is_made_with_the_first_mark(marks: MarksFile) -> None:
    marks.change("ada", "2.3", Mark(2.5, "Say why."), None)
    assert text_of(marks) == f"{HEADER}ada,2.3,2.5,Say why.\n"
    marks.change("ada", "2.3", None, Mark(2.5, "Say why."))
    assert text_of(marks) == HEADER


FILES = {
    "plain": f'{HEADER}bob,2.3,1,"by ""hand"""\nada,2.3,2,\n',
    "no end": f"{HEADER}bob,2.3,1,by hand\nada,2.3,2,",
    "excel": f"\ufeff{HEADER}bob,2.3,1,by hand\nada,2.3,2,\n".replace("\n", "\r\n"),
    "european": (HEADER.replace(",", ";") + "bob;2.3;1,50;by hand;;\n;;;\nada;2.3;2;\n").replace(
        "\n", "\r\n"
    ),
    "untidy": 'Student, Exercise ,Points,Comment,,\n\n bob ,2.3,1.0,"two\n\nlines",,\n\nada,2.3,2,',
}


@pytest.mark.parametrize("text", FILES.values(), ids=FILES.keys())
def test_rows_written_by_hand_stay_as_they_are(marks: MarksFile, text: str) -> None:
    marks.path.write_bytes(text.encode())
    before, _, _ = text.rpartition("ada")
    marks.change("ada", "2.3", Mark(0.5, "a, b; c\nd"), Mark(2.0, ""))
    assert text_of(marks).startswith(before + "ada")
    marks.change("=1+1", "2.3", Mark(3.0, "Good."), None)
    assert text_of(marks).startswith(before + "ada")
    assert text_of(marks).endswith("\r\n" if "\r\n" in text else "\n")
    read = marks.read()
    assert read["ada", "2.3"] == Mark(0.5, "a, b; c\nd")
    assert read["=1+1", "2.3"] == Mark(3.0, "Good.")
    assert len(read) == 3
    for student in ("ada", "=1+1"):
        marks.change(student, "2.3", None, read[student, "2.3"])
    assert text_of(marks).removesuffix("\r\n").removesuffix("\n") in before


@pytest.mark.parametrize("student", STUDENTS)
@pytest.mark.parametrize(
    "comment", ["", "- forgot g", "'= x", "'", "=1+1", "a;=b", '"', "x,\n y", "\uff1d1", "\x1b[31m"]
)
def test_what_is_written_is_read_again_and_is_no_formula(
    marks: MarksFile, student: str, comment: str
) -> None:
    marks.change(student, "2.3", Mark(1.0, comment), None)
    (((who, _), mark),) = marks.read().items()
    assert (who, mark.points) == (student, 1.0)
    assert mark.comment == comment.replace("\x1b", "\\x1b")
    row = text_of(marks).removeprefix(HEADER)
    assert not row.startswith(("=", "-", "+", "@"))
    assert not row.split(",1,")[1].lstrip('"').startswith(("=", "-", "+", "@", "\uff1d"))


def test_a_mark_that_somebody_else_has_changed_is_not_overwritten(marks: MarksFile) -> None:
    marks.change("ada", "2.3", Mark(2.0, ""), None)
    other = MarksFile(marks.path, CHAPTERS, class_of(*STUDENTS))
    other.change("ada", "2.3", Mark(1.0, ""), Mark(2.0, ""))
    for new in (Mark(3.0, ""), None):
        with pytest.raises(ChangedError):
            marks.change("ada", "2.3", new, Mark(2.0, ""))
    assert marks.read() == {("ada", "2.3"): Mark(1.0, "")}


def test_a_file_with_a_mistake_stays_as_it_is(marks: MarksFile) -> None:
    text = f"{HEADER}ada,2.3,9,\n"
    marks.path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"line 2: .* '9'"):
        marks.change("bob", "2.3", Mark(1.0, ""), None)
    assert text_of(marks) == text


def test_a_link_to_the_file_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "class").mkdir()
    (tmp_path / "class/marks.csv").symlink_to(tmp_path / "kept.csv")
    marks = MarksFile(tmp_path / "class/marks.csv", CHAPTERS, class_of(*STUDENTS))
    marks.change("ada", "2.3", Mark(1.0, ""), None)
    assert (tmp_path / "class/marks.csv").is_symlink()
    assert (tmp_path / "kept.csv").read_text(encoding="utf-8") == f"{HEADER}ada,2.3,1,\n"


def give(path: Path, students: list[str], mine: list[str]) -> None:
    marks = MarksFile(path, CHAPTERS, class_of(*students))
    for student in mine:
        marks.change(student, "2.3", Mark(1.0, student), None)


def test_two_servers_lose_no_mark_of_each_other(tmp_path: Path) -> None:
    students = [f"s{i:02}" for i in range(60)]
    context = multiprocessing.get_context("fork")
    processes = [
        context.Process(target=give, args=(tmp_path / "marks.csv", students, students[i::3]))
        for i in range(3)
    ]
    for process in processes:
        process.start()
    for process in processes:
        process.join()
        assert process.exitcode == 0
    marks = read_marks(tmp_path / "marks.csv", CHAPTERS, class_of(*students))[0]
    assert marks == {(s, "2.3"): Mark(1.0, s) for s in students}
