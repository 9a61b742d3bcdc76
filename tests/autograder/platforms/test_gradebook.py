"""The gradebook: every number in its column, and no text that a spreadsheet runs."""

from __future__ import annotations

import csv
import unicodedata
from pathlib import Path

import pytest

from autograder.reports.gradebook import write_gradebook
from autograder.reports.marks import Mark, apply_marks
from autograder.reports.report import StudentReport
from autograder.submissions.csv_rows import as_cell
from graded import CHAPTERS, class_of, failed_run, hostile, nothing_done, report_of

FULL_WIDTH = "\uff1d\uff0b\uff0d\uff20"  # = + - @ as Chinese and Japanese keyboards write them


def rows(out: Path, *reports: StudentReport, separator: str = ",") -> list[list[str]]:
    path = write_gradebook(out, CHAPTERS, reports, class_of())
    assert path == out / "gradebook.csv"
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file, delimiter=separator))


def test_the_points_possible_stand_between_the_header_and_the_students(tmp_path: Path) -> None:
    marked = apply_marks(report_of("cleo"), {("cleo", "2.3"): Mark(2.25, "")})
    header, possible, ada, cleo = rows(tmp_path, report_of(), marked)
    assert header == [
        *("student", "status", "score", "score on given chapters", "by hand", "waiting"),
        *("total", "B2.1", "2.2", "2.3", "B3.1"),
    ]
    assert possible == ["points possible", "", "11", "11", "3", "", "14", "2", "4", "3", "5"]
    assert ada == ["ada", "graded", "3", "8", "", "3", "3", "2", "1", "", "0"]
    assert cleo == ["cleo", "graded", "3", "8", "2.25", "0", "5.25", "2", "1", "2.25", "0"]


def test_an_error_of_the_grader_is_no_number_and_a_zero_is_one(tmp_path: Path) -> None:
    *_, eve, eli = rows(tmp_path, failed_run(), nothing_done())
    assert eve == ["eve", "error, retry", "", "", "", "3", "", "2", "1", "", ""]
    assert eli == ["eli", "graded", "0", "0", "", "3", "0", "0", "0", "", "0"]


def test_missing_exercises_are_empty_and_large_points_keep_their_digits(tmp_path: Path) -> None:
    report = report_of(results=report_of().results[3:], score=1234567.25)
    cells = rows(tmp_path, report)[2]
    assert (cells[2], cells[7:]) == ("1234567.25", ["", "", "", "0"])


@pytest.mark.parametrize(
    "name",
    [
        *("=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "  =1", "\u00a0=1"),
        *("\x00=1", "\x1b[1m=1", "\u202e=1"),
        *(f"{sign}1" for sign in FULL_WIDTH),
    ],
)
def test_no_name_begins_a_formula(tmp_path: Path, name: str) -> None:
    cell = rows(tmp_path, report_of(name))[2][0]
    assert cell.lstrip()[0] not in f"=+-@\t\r{FULL_WIDTH}", cell
    assert name[-1] in cell, "the name can still be told"


def test_no_formula_begins_where_columns_are_parted_by_semicolons(tmp_path: Path) -> None:
    for name in ("ann;=1+1", "ann; =1+1", 'ann";=1+1;"'):
        for cell in rows(tmp_path, report_of(name), separator=";")[2]:
            assert not cell.lstrip().startswith("="), cell


@pytest.mark.parametrize("name", ["Åsa B", "O'Neill", "d-e", "a=b", "x@y.org", "王", "🦊", "[red]"])
def test_an_ordinary_name_stays_as_it_is(name: str) -> None:
    assert as_cell(name) == name


def test_a_hostile_name_is_one_line_without_control_characters(tmp_path: Path) -> None:
    table = rows(tmp_path, hostile('a\r\nb,"c\x1b[31m\x00\ud800'), report_of())
    assert len(table) == 4
    assert {len(row) for row in table} == {11}
    assert table[2][0] == 'a b,"c\\x1b[31m\\x00\\ud800'
    text = (tmp_path / "gradebook.csv").read_text(encoding="utf-8")
    assert {c for c in text if unicodedata.category(c) in ("Cc", "Cs")} <= {"\r", "\n"}
