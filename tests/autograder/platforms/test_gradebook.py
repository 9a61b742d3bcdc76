"""The gradebook and results.json: every number in its place, and no text that does harm."""

from __future__ import annotations

import csv
import json
import unicodedata
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from autograder.message import Kind, Message
from autograder.reports.gradebook import write_gradebook
from autograder.reports.gradescope import as_text, gradescope_results, write_gradescope
from autograder.reports.marks import Mark, apply_marks
from autograder.reports.report import StudentReport
from autograder.submissions.csv_rows import as_cell
from autograder.submissions.find import file_name
from graded import (
    CHAPTERS,
    SHOUT,
    blocked,
    check,
    class_of,
    failed_run,
    hostile,
    nothing_done,
    report_of,
    with_exercise,
)

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


@pytest.mark.parametrize(
    "name",
    [
        *("=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\n=1", "\u00a0=1", "\u202e=1"),
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


SCHEMA = json.loads(Path(__file__).with_name("gradescope.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
MARKED = apply_marks(report_of(), {("ada", "2.3"): Mark(2.5, "Say why.")})


def results_of(report: StudentReport) -> dict[str, Any]:
    return dict(json.loads(as_text(gradescope_results(report))))


def by_number(results: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {test["number"]: test for test in results["tests"]}


@pytest.mark.parametrize(
    "report",
    [
        report_of(),
        MARKED,
        failed_run(),
        nothing_done(),
        hostile(),
        blocked(),
        report_of(status="error, retry", score=None, score_on_given=None, results=[]),
    ],
    ids=["graded", "marked", "error", "zero", "hostile", "blocked", "nothing known"],
)
def test_every_report_is_of_the_documented_form(tmp_path: Path, report: StudentReport) -> None:
    path = write_gradescope(tmp_path, report)
    assert path == tmp_path / "gradescope" / file_name(report.student) / "results.json"
    results = json.loads(path.read_text(encoding="utf-8"))
    VALIDATOR.validate(results)
    if report.results:
        assert sum(test["max_score"] for test in results["tests"]) == 2 + 4 + 3 + 5


def test_an_exercise_is_a_test_with_its_own_points_and_what_was_lost() -> None:
    results = results_of(report_of())
    copy, angles, _, mass = results["tests"]
    assert (copy["number"], copy["name"], copy["visibility"]) == ("B2.1", "Copy", "visible")
    assert (copy["score"], copy["max_score"], copy["status"]) == (2.0, 2, "passed")
    assert (angles["score"], angles["max_score"], angles["status"]) == (1.0, 4, "failed")
    assert "physics 1 of 3" in angles["output"]
    assert "failed: angle\ngot       1\nwanted    2" in angles["output"]
    assert "right angle" not in angles["output"]
    assert (mass["score"], mass["status"]) == (0.0, "failed")
    assert "earlier chapter" in mass["output"]
    assert results["score"] == 3.0
    unwritten = Message("not written yet: Angles", kind=Kind.UNWRITTEN)
    lacking = with_exercise(report_of(), 1, checks=[check("test_angle", "failed", unwritten)])
    assert "failed" not in by_number(results_of(lacking))["2.2"]["output"]
    for words in ("seed: 7", "isolation: none", "given chapters: 8 points", "person: 3 points"):
        assert words in results["output"]


def test_a_hidden_check_shows_its_rationale_and_not_its_name() -> None:
    results = results_of(report_of())
    assert "failed: a hidden check\nAngles turn once round." in by_number(results)["2.2"]["output"]
    assert "far away" not in json.dumps(results).replace("_", " ")
    assert "secret plan" not in json.dumps(results).replace("_", " ")
    assert "secret message" not in json.dumps(results)


def test_a_written_exercise_waits_without_a_score_until_a_person_marks_it() -> None:
    waiting = by_number(results_of(report_of()))["2.3"]
    assert waiting["max_score"] == 3
    assert "waiting for a person to mark it" in waiting["output"]
    assert waiting.keys().isdisjoint({"score", "status"})
    results = results_of(MARKED)
    marked = by_number(results)["2.3"]
    assert (marked["score"], marked["max_score"]) == (2.5, 3)
    assert "Say why." in marked["output"]
    assert results["score"] == 5.5, "checks and marks together"
    assert "waiting" not in results["output"]


def test_where_the_grader_failed_there_is_no_number_at_all() -> None:
    failed = apply_marks(failed_run("ada"), {("ada", "2.3"): Mark(3, "")})
    results = results_of(failed)
    assert "score" not in results, "its parts would add up to a mark that nobody earned"
    assert "grader error, please retry" in results["output"]
    tests = by_number(results)
    assert tests["B3.1"].keys().isdisjoint({"score", "status"})
    assert "grader error, please retry" in tests["B3.1"]["output"]
    assert "the disk is full" in tests["B3.1"]["output"]
    assert tests["B2.1"]["score"] == 2.0, "what was graded stays"
    report = report_of(status="error, retry")
    lost = [check("test_mass", "error", "killed")]
    report = with_exercise(report, 3, status="error", score=5.0, checks=lost)
    results = results_of(report)
    assert "score" not in results, "although numbers are left in the report"
    assert "score" not in by_number(results)["B3.1"]


def test_hostile_text_stays_text_and_loses_its_control_characters(tmp_path: Path) -> None:
    results = json.loads(write_gradescope(tmp_path, hostile()).read_text(encoding="utf-8"))
    formats = ("output_format", "test_output_format", "test_name_format")
    assert {results[key] for key in formats} == {"text"}, "nothing in it is taken for HTML"
    texts = [results["output"], *(test["output"] for test in results["tests"])]
    assert any(SHOUT in text for text in texts)
    for text in texts:
        assert {c for c in text if unicodedata.category(c) in ("Cc", "Cs")} <= {"\n", "\t"}
        assert "\u202e" not in text
        assert len(text) < 50_000, "what is too long is cut"
