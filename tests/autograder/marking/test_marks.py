"""Hand-given marks: what is read, what is refused with its place, and how reports take them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.reports.marks import Mark, apply_marks, read_marks
from graded import CHAPTERS, class_of, failed_run, report_of

STUDENTS = class_of("ada", "=1+1", "Zoe\u0301")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "marks.csv"


def test_without_a_file_there_are_no_marks(file: Path) -> None:
    assert read_marks(file, CHAPTERS, STUDENTS)[0] == {}


@pytest.mark.parametrize(
    "content",
    [
        b'student,exercise,points,comment\nada,2.3,2.5,"Good, but short"\n',
        b'\xef\xbb\xbfstudent,exercise,points,comment\r\nada,2.3,2.5,"Good, but short"\r\n',
        b"\xef\xbb\xbfstudent;exercise;points;comment\r\nada;2.3;2,5;Good, but short\r\n;;;\r\n",
        b'Student, Exercise ,Points,Comment,,\n\n ada , 2.3 , 2.5 ,"Good, but short",,\n',
    ],
    ids=["plain", "excel", "european", "untidy"],
)
def test_marks_are_read_as_spreadsheets_write_them(file: Path, content: bytes) -> None:
    file.write_bytes(content)
    assert read_marks(file, CHAPTERS, STUDENTS)[0] == {("ada", "2.3"): Mark(2.5, "Good, but short")}


@pytest.mark.parametrize(("written", "student"), [("'=1+1", "=1+1"), ("Zo\u00e9", "Zoe\u0301")])
def test_a_name_may_be_copied_from_the_gradebook_or_typed(
    file: Path, written: str, student: str
) -> None:
    file.write_text(f"student,exercise,points,comment\n{written},2.3,0,\n", encoding="utf-8")
    assert read_marks(file, CHAPTERS, STUDENTS)[0] == {(student, "2.3"): Mark(0.0, "")}


def test_a_name_that_could_mean_two_students_means_the_one_who_is_called_so(file: Path) -> None:
    file.write_text("student,exercise,points,comment\n'=x,2.3,1,\n", encoding="utf-8")
    assert list(read_marks(file, CHAPTERS, class_of("=x", "'=x"))[0]) == [("'=x", "2.3")]


@pytest.mark.parametrize(
    ("row", "line", "words"),
    [
        ("bob,2.3,1,", 2, "there is no student 'bob'"),
        ("ada,2.9,1,", 2, "no exercise '2.9'. Written exercises: 2.3"),
        ("ada,B2.1,1,", 2, "'B2.1' gets its points from checks. Written exercises: 2.3"),
        ("ada,2.3,two,", 2, "the points for 2.3 must be a number from 0 to 3, got 'two'"),
        ("ada,2.3,nan,", 2, "got 'nan'"),
        ("ada,2.3,inf,", 2, "got 'inf'"),
        ("ada,2.3,-1,", 2, "got '-1'"),
        ("ada,2.3,3.01,", 2, "got '3.01'"),
        ("ada,2.3,,", 2, "got ''"),
        ("ada,2.3,٣,", 2, "got '٣'"),
        ('ada,2.3,"2,5",', 2, "got '2,5'"),
        (
            "ada,2.3,1,a\n\nada,2.3,2,b",
            4,
            "a second mark for 'ada' in 2.3, as in line 2. Give only one",
        ),
        ('ada,2.3,1,"two\nlines"\nbob,2.3,1,', 4, "no student 'bob'"),
        ("ada,2.3,1,good, but short", 2, "there must be 4 cells, got 5. Put a comment"),
        ('ada,2.3,1,"never closed\nada,2.3,2,', 2, "Close the quote"),
    ],
)
def test_a_row_that_is_wrong_is_refused_with_its_place(
    file: Path, row: str, line: int, words: str
) -> None:
    file.write_text(f"student,exercise,points,comment\n{row}\n", encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(words)) as caught:
        read_marks(file, CHAPTERS, STUDENTS)
    assert f"{file}, line {line}: " in str(caught.value)


@pytest.mark.parametrize("header", ["", "ada,2.3,1,", "student,points,exercise,comment"])
def test_another_header_is_refused(file: Path, header: str) -> None:
    file.write_text(f"{header}\nada,2.3,1,\n", encoding="utf-8")
    with pytest.raises(
        ValueError, match="line 1: the header must be student,exercise,points,comment"
    ):
        read_marks(file, CHAPTERS, STUDENTS)


def test_another_encoding_is_refused_with_its_line(file: Path) -> None:
    file.write_bytes("student,exercise,points,comment\nada,2.3,1,schön\n".encode("cp1252"))
    with pytest.raises(ValueError, match="line 2: this is not UTF-8"):
        read_marks(file, CHAPTERS, STUDENTS)


def test_a_mark_counts_as_points_by_hand_and_waits_no_longer() -> None:
    report = report_of()
    marked = apply_marks(report, {("ada", "2.3"): Mark(2.5, "Clear."), ("bob", "2.3"): Mark(1, "")})
    assert report == report_of(), "the report that is given stays as it is"
    why = marked.results[2]
    assert (why.status, why.score, why.comment) == ("marked", 2.5, "Clear.")
    assert (marked.by_hand, marked.waiting) == (2.5, 0)
    assert (marked.score, marked.points, marked.seed) == (3.0, 11, "7")
    assert [e.status for e in marked.results] == ["passed", "failed", "marked", "inherited"]


def test_other_marks_start_afresh() -> None:
    once = apply_marks(report_of(), {("ada", "2.3"): Mark(2.5, "Clear.")})
    none = apply_marks(once, {})
    assert (none.results[2].status, none.results[2].score) == ("waiting", None)
    assert none.results[2].comment == ""
    assert (none.by_hand, none.waiting) == (None, 3)
    zero = apply_marks(once, {("ada", "2.3"): Mark(0, "Empty.")})
    assert (zero.by_hand, zero.waiting) == (0, 0), "a zero by hand is a mark"


def test_a_mark_makes_no_error_of_the_grader_good() -> None:
    marked = apply_marks(failed_run("ada"), {("ada", "2.3"): Mark(3, "")})
    assert (marked.status, marked.score, marked.by_hand) == ("error, retry", None, 3)
