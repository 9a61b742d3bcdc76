"""canvas.csv and moodle.csv, read as Canvas's lib/gradebook_importer.rb and Moodle's
grade/import/csv/classes/load_data.php do (worksheets: moodle_sheet.py).
"""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column, write_uploads
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList
from autograder.submissions.moodle_worksheet import Worksheet, read_worksheet
from autograder.submissions.roster import Student
from graded import CHAPTERS, failed_run, report_of
from listed import listed
from moodle_sheet import GERMAN, Sheet, download, upload

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


def a_class() -> tuple[ClassList, list[StudentReport]]:
    people = listed(*NAMES, roster=ROSTER)
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
        assert len(row) == len(header), "Moodle imports nothing at all"
        if row[key].strip():  # otherwise the user of the row above
            user = users[row[key].strip()]
        value = row[grade].strip()
        if value == "-" or (value == "" and not new_item):
            grades[user] = None
            continue
        number = 0.0 if value == "" else float(value)  # the database makes 0 of an empty text
        assert number <= 100, "Moodle imports nothing at all"
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


def test_only_a_grade_that_moodle_would_reject_is_cut(tmp_path: Path) -> None:
    """Ann has 14.5 of 14 points, and Bo 15.4, because of extra credit."""
    people, reports = a_class()
    reports[:2] = [report_of("Ann Lee", score=14.5), report_of("O'Neill, Bo", score=15.4)]
    paths, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column("Lab 1"))
    grades = import_into_moodle(rows_of(paths[1]), "ID number")
    assert (grades["77"], grades["u8"]) == (100.0, 100.0)
    assert import_into_canvas(rows_of(paths[0]))[0][77] == "14.5"
    cut = next(line for line in lines if "were cut" in line)
    assert "moodle.csv: grades above 100 were cut, because Moodle accepts no larger ones" in cut
    assert "2 (Ann Lee; O'Neill, Bo). Choose fewer points with POINTS=." in cut
    paths, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column("Lab 1", 90.9))
    grades = import_into_moodle(rows_of(paths[1]), "ID number")
    assert (grades["77"], grades["u8"]) == (94.15, 99.99)
    assert "were cut" not in "".join(lines)


def test_what_is_not_written_is_reported_and_no_cell_begins_a_formula(tmp_path: Path) -> None:
    files, lines = written(tmp_path)
    cells = [cell for rows in files.values() for row in rows for cell in row if cell != "-"]
    assert not any("zoe" in cell or cell.lstrip()[:1] in ("=", "+", "-", "@") for cell in cells)
    assert "Not in canvas.csv and moodle.csv: zoe." in lines
    people, reports = a_class()
    reports[0] = report_of("Ann Lee", waiting=3)
    _, lines = write_uploads(tmp_path, CHAPTERS, people, reports, Column())
    assert lines[-1].startswith("Students with answers that are not marked yet: 2.")  # and Cy


OF_MOODLE = listed(
    *("Ann Lee_12_assignsubmission_file", "Bo O'Neill_13_assignsubmission_file_"),
    *("Bo O'Neill_14_assignsubmission_file", "zoe"),
)


def worksheet_of(folder: Path, text: str) -> Worksheet:
    (folder / "worksheet.csv").write_text(text, encoding="utf-8")
    return read_worksheet(folder / "worksheet.csv")


@pytest.mark.parametrize(("points", "half"), [(None, 10.0), (16, 8.0), (50, 10.0)])
def test_the_worksheet_from_moodle_gets_grades_in_its_own_points(
    tmp_path: Path, points: float | None, half: float
) -> None:
    """It needs no roster, and works for students with the same name."""
    sheet = Sheet(GERMAN, most=20)
    reports = [report_of("Ann Lee_12", score=7.0), failed_run("Bo O'Neill_13"), report_of("zoe")]
    reports.append(report_of("Bo O'Neill_14", score=17.5))
    worksheet = worksheet_of(tmp_path, download(sheet))
    paths, lines = write_uploads(
        tmp_path, CHAPTERS, OF_MOODLE, reports, Column("", points), worksheet
    )
    assert [path.name for path in paths] == ["moodle-worksheet.csv"]
    assert upload(paths[0].read_bytes(), sheet) == ({12: half, 14: 20.0}, [])
    assert "Not in worksheet.csv from Moodle: zoe." in "".join(lines)
    if points != 16:  # of 20, 17.5 points of 14 are exactly 20
        assert "1 (Bo O'Neill_14). Choose fewer points with POINTS=." in "".join(lines)


def test_a_worksheet_of_another_assignment_is_not_filled(tmp_path: Path) -> None:
    people = listed("Ann Lee_99_assignsubmission_file")
    worksheet = worksheet_of(tmp_path, download(Sheet()))
    paths, lines = write_uploads(
        tmp_path, CHAPTERS, people, [report_of("Ann Lee_99")], Column(), worksheet
    )
    assert paths == []
    assert not (tmp_path / "moodle-worksheet.csv").exists()
    assert lines[0].startswith("Not in worksheet.csv from Moodle: Ann Lee_99. Make sure that it is")


def test_without_a_worksheet_the_instructor_hears_where_to_save_it(tmp_path: Path) -> None:
    paths, lines = write_uploads(tmp_path, CHAPTERS, OF_MOODLE, [report_of("zoe")], Column())
    assert paths == []
    assert len(lines) == 1
    assert "save it as worksheet.csv in the folder with the submissions" in lines[0]
    assert write_uploads(tmp_path, CHAPTERS, ClassList([]), [], Column()) == ([], [])


@pytest.mark.parametrize("title", ["=Lab", "a\nb", " ", "x;=1"])
def test_a_title_that_is_no_cell_is_refused(title: str) -> None:
    with pytest.raises(ValueError, match="--title must"):
        Column(title)
    with pytest.raises(ValueError, match="--points must be a positive number, got 0"):
        Column("Lab 1", 0)
