"""canvas.csv and moodle.csv, read by the rules that the importers of Canvas and Moodle follow.

The rules are those of Canvas's lib/gradebook_importer.rb, and of Moodle's
grade/import/csv/classes/load_data.php and mod/assign/feedback/offline.
"""

from __future__ import annotations

import csv
import re
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column, write_uploads
from autograder.reports.report import Late, StudentReport
from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.roster import COLUMNS, Student
from graded import CHAPTERS, failed_run, report_of

ROSTER = [
    Student("77", "Ann Lee", "ann@x.org", "al7", 2),
    Student("u8", "O'Neill, Bo", "bo@x.org", "bo8", 3),
    Student("2024", "=1+1", "eve@x.org", "eve", 4),  # whose id is 501 in Canvas
    Student("80", "Cy", "cy@x.org", "", 5),
    Student("81", "Di", "di@x.org", "di", 6),  # handed nothing in
]
NAMES = ["al7", "Bo O'Neill", "11_501_9_work", "80", "zoe"]
CANVAS_USERS = {77: "al7", 78: "bo8", 501: "eve", 80: "cy@x.org", 81: "di"}  # logins, by id
SIS_IDS = {"u8": 78, "2024": 501}
TOTALS = {"Ann Lee": 14.0, "O'Neill, Bo": 4.66, "=1+1": 0.0, "zoe": 5.0}  # of 14; Cy's failed


def of_folders(*names: str, roster: list[Student] | None = None) -> ClassList:
    """Return the class that has handed in folders of these names."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "roster.csv"
        rows = [[one.id, one.name, one.email, one.login] for one in roster or []]
        with path.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([COLUMNS, *rows])
        for name in names:
            (Path(folder) / name).mkdir()
        return read_class(Path(folder), path if roster else None)


def a_class() -> tuple[ClassList, list[StudentReport]]:
    people = of_folders(*NAMES, roster=ROSTER)
    reports = [report_of(name, score=points, waiting=0) for name, points in TOTALS.items()]
    return people, [*reports, failed_run("Cy")]


def written(
    out: Path, title: str = "Lab 1 (12345)", points: float | None = None
) -> tuple[dict[str, list[list[str]]], list[str]]:
    people, reports = a_class()
    paths, lines = write_uploads(out, CHAPTERS, people, reports, Column(title, points))
    return {path.name: rows_of(path) for path in paths}, lines


def rows_of(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def import_into_canvas(rows: list[list[str]]) -> tuple[dict[int, str], str, str]:
    """Return the grade of each user, the title of the assignment, and its points."""
    header, *rest = rows
    assert len(header) > 3
    assert "Student" in header[0]
    assert "ID" in header[1]
    columns = 3
    if re.search(r"SIS\s+User\s+ID", header[2]) and re.search(r"SIS\s+Login\s+ID", header[3]):
        columns += 2
    assert "Section" in header[columns - 1], "invalid header row"
    (title,) = header[columns:]
    possible = ""
    grades: dict[int, str] = {}
    for row in rest:
        if "Points Possible" in row[0]:
            possible = row[columns]
            continue
        number = re.match(r"\s*[0-9]*", row[1])
        user = int(number[0]) if number and number[0].strip() else 0  # Ruby's to_i
        if user not in CANVAS_USERS:
            logins = {login: user for user, login in CANVAS_USERS.items()}
            user = SIS_IDS.get(row[2]) or logins.get(row[3]) or 0
        assert user, f"{row} would become a new student"
        assert user not in grades
        grades[user] = row[columns].strip()
    return grades, title, possible


def test_canvas_finds_the_assignment_and_everybodys_grade(tmp_path: Path) -> None:
    grades, title, possible = import_into_canvas(written(tmp_path)[0]["canvas.csv"])
    assert re.fullmatch(r"(.*)\s\((\d+)\)", title), "Canvas takes the id from the parentheses"
    assert (title, possible) == ("Lab 1 (12345)", "14")
    # No grade for Cy, on whose work the grader failed, and for Di, who handed nothing in.
    assert grades == {77: "14", 78: "4.66", 501: "0", 80: "", 81: ""}


def test_late_work_has_its_penalty_and_extra_credit_is_above_the_points(tmp_path: Path) -> None:
    """Of 14 points, the 2 of B2.1 are extra credit. Ann has earned 13 and is a day late."""
    exercises = [replace(e, extra=e.id == "B2.1") for e in CHAPTERS[0].exercises]
    chapters = [replace(CHAPTERS[0], exercises=exercises), CHAPTERS[1]]
    people, _ = a_class()
    reports = [report_of("Ann Lee", score=13.0, waiting=0, late=Late(1, 1.5, "late"))]
    write_uploads(tmp_path, chapters, people, reports, Column("Lab 1"))
    grades, _, possible = import_into_canvas(rows_of(tmp_path / "canvas.csv"))
    assert (grades[77], possible) == ("11.5", "12")


class MoodleError(Exception):
    """Moodle imports nothing at all."""


def import_into_moodle(
    rows: list[list[str]], by: str, *, new_item: bool = False
) -> dict[str, float | None]:
    """Return the grade of each user. ``by`` is the column that names the user."""
    known = {"ID number": "id", "Email address": "email", "Username": "login"}
    users = {getattr(student, known[by]): student.id for student in ROSTER}
    header, *rest = rows
    key, grade = header.index(by), len(header) - 1
    grades: dict[str, float | None] = {}
    user = ""
    for row in rest:
        if len(row) != len(header):
            raise MoodleError("another number of columns")
        if row[key].strip():  # otherwise the user of the row above
            if row[key].strip() not in users:
                raise MoodleError(f"there is no user {row[key]!r}")
            user = users[row[key].strip()]
        value = row[grade].strip()
        if value == "-" or (value == "" and not new_item):
            grades[user] = None
            continue
        number = 0.0 if value == "" else float(value)  # the database makes 0 of an empty text
        if number > 100:
            raise MoodleError("the grade is over 100")
        grades[user] = number
    return grades


@pytest.mark.parametrize("by", ["ID number", "Email address"])
@pytest.mark.parametrize("new_item", [True, False])
def test_moodle_imports_everybodys_grade_rescaled_to_100(
    tmp_path: Path, by: str, new_item: bool
) -> None:
    files, lines = written(tmp_path)
    grades = import_into_moodle(files["moodle.csv"], by, new_item=new_item)
    assert grades == {"77": 100.0, "u8": 33.29, "2024": 0.0, "80": None, "81": None}
    assert files["moodle.csv"][0][-1] == "Lab 1"
    assert "Username" not in files["moodle.csv"][0], "Cy has none, and would be taken for Bo"
    assert "moodle.csv: rescaled from 14 points to 100." in "\n".join(lines)


@pytest.mark.parametrize(
    ("points", "of_canvas", "of_moodle"),
    [(None, 4.66, 33.29), (28, 9.32, 9.32), (467, 155.44, 33.29)],
)
def test_grades_are_rescaled_to_the_points_of_the_assignment(
    tmp_path: Path, points: float | None, of_canvas: float, of_moodle: float
) -> None:
    files, _ = written(tmp_path, points=points)
    canvas, _, possible = import_into_canvas(files["canvas.csv"])
    assert (float(canvas[78]), float(possible)) == (of_canvas, points or 14)
    assert import_into_moodle(files["moodle.csv"], "ID number")["u8"] == of_moodle


def test_a_grade_over_the_maximum_does_not_stop_moodle(tmp_path: Path) -> None:
    people, reports = a_class()
    reports[0] = report_of("Ann Lee", score=14.5)  # with extra credit
    paths, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column("Lab 1"))
    assert import_into_moodle(rows_of(paths[1]), "ID number")["77"] == 100.0
    assert import_into_canvas(rows_of(paths[0]))[0][77] == "14.5"
    assert "Grades over 100: 1. Moodle would reject them, so they are imported as 100." in lines


def test_those_outside_the_roster_are_left_out_and_named(tmp_path: Path) -> None:
    files, lines = written(tmp_path)
    assert not any("zoe" in cell for rows in files.values() for row in rows for cell in row)
    assert "Not in canvas.csv and moodle.csv: zoe." in lines


def test_no_cell_begins_a_formula(tmp_path: Path) -> None:
    for rows in written(tmp_path)[0].values():
        for cell in (cell for row in rows for cell in row if cell != "-"):
            assert cell.lstrip()[:1] not in ("=", "+", "-", "@"), cell


def test_answers_that_wait_are_reported(tmp_path: Path) -> None:
    people, reports = a_class()
    reports[0] = report_of("Ann Lee", waiting=3)
    _, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column())
    assert lines[-1].startswith("Students with answers that are not marked yet: 2.")  # and Cy


def test_without_a_roster_there_is_only_the_worksheet_of_a_class_from_moodle(
    tmp_path: Path,
) -> None:
    names = ["Ann Lee_12_assignsubmission_file", "Cy_13_assignsubmission_file_", "zoe"]
    people = of_folders(*names)
    reports = [report_of("Ann Lee_12", score=7.0), failed_run("Cy_13"), report_of("zoe")]
    paths, _ = write_uploads(tmp_path, CHAPTERS, people, reports, Column())
    assert [path.name for path in paths] == ["moodle-worksheet.csv"]
    header, *rows = rows_of(paths[0])
    # What Moodle needs to read a worksheet. An empty comment would replace the one that it has.
    assert {"Identifier", "Grade", "Last modified (grade)"} <= set(header)
    assert "Feedback comments" not in header
    grades = {row[header.index("Identifier")]: row[header.index("Grade")] for row in rows}
    assert grades == {"Participant 12": "50", "Participant 13": ""}  # of 100; no grade is skipped
    assert write_uploads(tmp_path, CHAPTERS, ClassList([]), [], Column()) == ([], [])


@pytest.mark.parametrize(
    "title", ["=Lab", "a\nb", " ", "ID", "Final Grade", "Override Score (Fall)", "x;=1"]
)
def test_a_title_that_canvas_would_not_import_is_refused(title: str) -> None:
    with pytest.raises(ValueError, match="--title must"):
        Column(title)
    with pytest.raises(ValueError, match="--points must be a positive number, got 0"):
        Column("Lab 1", 0)
