"""Hand-given marks: what is read, what is refused with its place, and how reports take them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.reports.marks import Mark, apply_marks, read_marks
from autograder.submissions.class_list import ClassList
from graded import CHAPTERS, class_of, failed_run, report_of

STUDENTS = class_of("ada", "=1+1", "Zoe\u0301")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    file = tmp_path / "marks.csv"
    assert read_marks(file, CHAPTERS, STUDENTS)[0] == {}, "without a file there are no marks"
    return file


@pytest.mark.parametrize(
    ("written", "student", "people"),
    [
        ("'=1+1", "=1+1", STUDENTS),
        ("Zo\u00e9", "Zoe\u0301", STUDENTS),
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
        ("ada,B2.1,1,", 2, "the exercise must be one of 2.3, got 'B2.1'"),
        ("ada,2.3,two,", 2, "the points for 2.3 must be a number from 0 to 3, got 'two'"),
        ("ada,2.3,nan,", 2, "got 'nan'"),
        ("ada,2.3,-1,", 2, "got '-1'"),
        ("ada,2.3,3.01,", 2, "got '3.01'"),
        ("ada,2.3,,", 2, "got ''"),
        ("ada,2.3,٣,", 2, "got '٣'"),
        ('ada,2.3,"2,5",', 2, "got '2,5'"),
        ("ada,2.3,1,a\n\nada,2.3,2,b", 4, "a second mark for 'ada' in 2.3, as in line 2."),
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


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "line 1: the header must be student,exercise,points,comment"),
        (b"student,points,exercise,comment\nada,2.3,1,\n", "line 1: the header must be"),
        (b"student,exercise,points,comment\nada,2.3,1,sch\xf6n\n", "line 2: this is not UTF-8"),
    ],
)
def test_another_header_or_encoding_is_refused(file: Path, content: bytes, words: str) -> None:
    file.write_bytes(content)
    with pytest.raises(ValueError, match=words):
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

    assert apply_marks(marked, {}) == report_of(), "other marks start afresh"
    zero = apply_marks(marked, {("ada", "2.3"): Mark(0, "Empty.")})
    assert (zero.by_hand, zero.waiting) == (0, 0), "a zero by hand is a mark"
    failed = apply_marks(failed_run("ada"), {("ada", "2.3"): Mark(3, "")})
    assert (failed.status, failed.score, failed.by_hand) == ("error, retry", None, 3)
