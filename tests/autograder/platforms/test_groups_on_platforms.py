"""Each student of a group gets the group's grade on Canvas and Moodle, and nobody gets it twice."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column, write_uploads
from autograder.submissions.moodle_worksheet import read_worksheet
from autograder.submissions.roster import Student
from graded import CHAPTERS, report_of
from listed import listed
from moodle_sheet import Sheet, download, upload

GROUP = "team 1 (Ann Lee, Bo O'Neill, Cy)"


def roster_with(*ids: str) -> list[Student]:
    names = ["Ann Lee", "Bo O'Neill", "Cy", "Dan Ek"]
    groups = ["team 1", "team 1", "team 1", ""]
    return [
        Student(number, name, "", "", line, group)
        for line, (number, name, group) in enumerate(zip(ids, names, groups, strict=True), 2)
    ]


@pytest.mark.parametrize(
    ("ids", "wanted"),
    [
        (("77", "78", "79", "80"), ["77", "78", "79", "80"]),
        (("a1", "a2", "a3", "a4"), ["77", "", "", "80"]),
        (("1001", "1002", "1003", "1004"), ["77", "", "", "80"]),  # of the university, not Canvas
    ],
)
def test_canvas_gets_one_row_with_an_own_id_for_each_student_of_a_group(
    tmp_path: Path, ids: tuple[str, ...], wanted: list[str]
) -> None:
    people = listed("leeann_77_501_work.zip", "ekdan_80_502_work.zip", roster=roster_with(*ids))
    reports = [report_of(GROUP, score=7.0, waiting=0), report_of("Dan Ek", score=3.0, waiting=0)]
    write_uploads(tmp_path, CHAPTERS, people, reports, Column("Lab", 14))
    with (tmp_path / "canvas.csv").open(encoding="utf-8", newline="") as file:
        _, _, *rows = csv.reader(file)
    assert [row[1] for row in rows] == wanted
    assert [row[2] for row in rows] == [*ids]
    assert [row[5] for row in rows] == ["7", "7", "7", "3"]


@pytest.mark.parametrize("identity", [("idnumber", "email"), ("email",), ()])
def test_a_worksheet_has_the_grade_of_a_group_for_each_of_its_students(
    tmp_path: Path, identity: tuple[str, ...]
) -> None:
    sheet = Sheet(identity=identity)
    participants = {
        12: ("Ann Lee", "u77", "ann@x.org"),
        13: ("Bo O'Neill", "u78", "bo@x.org"),
        16: ("Eve", "u90", "eve@x.org"),
    }
    (tmp_path / "worksheet.csv").write_text(download(sheet, participants), encoding="utf-8")
    people = listed(
        "Ann Lee_12_assignsubmission_file", roster=roster_with("u77", "u78", "u79", "u80")
    )
    reports = [report_of(GROUP, score=7.0, waiting=0)]
    worksheet = read_worksheet(tmp_path / "worksheet.csv")
    _, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column(), worksheet)
    content = (tmp_path / "moodle-worksheet.csv").read_bytes()
    assert upload(content, sheet, participants) == ({12: 50.0, 13: 50.0}, [])
    assert any(line.startswith("Not in worksheet.csv from Moodle: Cy.") for line in lines)
