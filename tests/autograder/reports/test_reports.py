"""What a class leaves can be read again, whole or not at all, and all is made from it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from autograder.analysis.class_page import write_class_page
from autograder.grader.people import people_of
from autograder.records import to_json
from autograder.reports.marks import Mark, apply_marks
from autograder.reports.results import (
    read_result,
    read_results,
    write_class,
    write_result,
    write_student,
)
from autograder.reports.texts import replace_file
from graded import CHAPTERS, cause_of, check, class_of, failed_run, hostile, nothing_done, report_of


def test_what_is_no_character_can_be_written_and_read(tmp_path: Path) -> None:
    assert read_result(write_result(tmp_path, hostile())) == hostile()
    replace_file(tmp_path / "text", "half a \ud800")
    assert (tmp_path / "text").read_bytes() == b"half a \\ud800"


def test_a_result_that_is_missing_or_cut_off_is_none(tmp_path: Path) -> None:
    path = write_result(tmp_path, report_of())
    whole = path.read_bytes()
    for length in (0, 1, len(whole) // 2, len(whole) - 3):
        path.write_bytes(whole[:length])
        assert read_result(path) is None, length
    for content in (b"\xff\xfe", b"[" * 100_000, b"null", b"[]", b"7"):
        path.write_bytes(content)
        assert read_result(path) is None, content[:9]
    path.unlink()
    assert read_result(path) is None
    assert read_result(tmp_path) is None


@pytest.mark.parametrize(
    ("where", "key", "value"),
    [
        ((), "score", "18"),
        ((), "score", float("nan")),
        ((), "status", "passed"),
        ((), "notes", [1]),
        ((), "results", None),
        ((), "seed", 7),
        (("results", 0), "status", "graded"),
        (("results", 0), "checks", [None]),
        (("results", 0, "exercise"), "points", "2"),
        (("results", 1, "checks", 1), "status", "no"),
        (("results", 1, "checks", 1), "weight", "1"),
    ],
)
def test_a_result_of_another_form_is_none(
    tmp_path: Path, where: tuple[Any, ...], key: str, value: object
) -> None:
    report = to_json(report_of())
    part: Any = report
    for step in where:
        part = part[step]
    path = tmp_path / "ada.json"
    path.write_text(json.dumps(report), encoding="utf-8")
    assert read_result(path) is not None
    kept = part.pop(key)
    path.write_text(json.dumps(report), encoding="utf-8")
    assert read_result(path) is None, "the key is missing"
    part[key] = value
    assert value != kept
    path.write_text(json.dumps(report), encoding="utf-8")
    assert read_result(path) is None, "the value is wrong"


def test_what_is_wrong_in_a_result_is_said_in_one_line(tmp_path: Path) -> None:
    path = write_result(tmp_path, report_of())
    report = json.loads(path.read_text(encoding="utf-8"))
    report["results"][1]["score"] = "18"
    for changed, words in (
        (report, r"Expected `float \| null`, got `str` - at `\$\.results\[1\]\.score`"),
        ({"student": "ada", "exercises": []}, "missing required field `status`"),  # an old one
    ):
        path.write_text(json.dumps(changed), encoding="utf-8")
        with pytest.raises(ValueError, match=rf"ada\.json cannot be read \(.*{words}") as caught:
            read_results(tmp_path)
        assert "Grade the class again into" in str(caught.value)
        assert "\n" not in str(caught.value)
    (tmp_path / "class/ada").mkdir(parents=True)
    (note,) = people_of(tmp_path / "class", tmp_path, None).notes
    assert note.endswith("so these submissions are graded again: 1.")


def test_all_that_a_class_leaves_is_made_from_its_reports(tmp_path: Path) -> None:
    cleo = apply_marks(report_of("cleo"), {("cleo", "2.3"): Mark(2.5, "")})
    hidden = check("test_hidden", "failed", "Only this.", hidden=True)
    cy = report_of("cy", causes=[cause_of("B2.0", "failed", hidden)])
    reports = [cleo, nothing_done(), failed_run(), cy]
    for report in reports:
        write_student(tmp_path, report)
    places = write_class(tmp_path, CHAPTERS, reports, class_of())
    assert all(place.exists() for place in places)
    assert {place.name for place in places} == {path.name for path in tmp_path.iterdir()}
    write_class_page(tmp_path, CHAPTERS, reports)
    files = {path.relative_to(tmp_path): path.read_bytes() for path in tmp_path.rglob("*.*")}
    assert len(files) == 3 + 3 * 4, "and nothing is left beside them"
    with_secrets = {path.parts[0] for path, text in files.items() if b"secret" in text}
    assert with_secrets == {"results"}, "students get no file from there"
    assert files[Path("results/cy.json")].count(b"secret message") == 3
    assert b"Only this." in files[Path("feedback/cy.html")]
    again = [read_result(tmp_path / "results" / f"{r.student}.json") for r in reports]
    assert again == reports
    for report in again:
        assert report is not None
        write_student(tmp_path, report)
    write_class(tmp_path, CHAPTERS, [report for report in again if report], class_of())
    assert files == {
        path.relative_to(tmp_path): path.read_bytes() for path in tmp_path.rglob("*.*")
    }
