"""Write a class's grades to files that Moodle can import.

These are moodle.csv for the gradebook, and the grading worksheet of an assignment.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from pathlib import Path

from autograder.reports.texts import number, replace_file
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell

MOST = 100.0  # Moodle does not import larger grades, unless the site allows it
NO_GRADE = "-"  # Moodle reads an empty cell as 0 if the column becomes a new grade item
WORKSHEET = [
    *("Identifier", "Full name", "Grade", "Maximum Grade", "Grade can be changed"),
    "Last modified (grade)",
]


def write_moodle(path: Path, people: ClassList, grades: Mapping[str, float], title: str) -> None:
    """Write moodle.csv, from which an instructor can import grades into Moodle's gradebook.

    The file has a row for each student on the roster. Moodle stops the import at a student it does
    not know. If the cell that should identify a student is empty, Moodle even gives the grade to
    the student in the row above. That is why the columns for logins and e-mail addresses are
    written only if every student has one.
    """
    students = [(member, member.student) for member in people.members if member.student]
    columns = {"ID number": [who.id for _, who in students]}
    if all(who.login for _, who in students):
        columns["Username"] = [who.login for _, who in students]
    if all(who.email for _, who in students):
        columns["Email address"] = [who.email for _, who in students]
    columns["Full name"] = [as_cell(who.name) for _, who in students]
    columns[title] = [number(grades.get(one.shown)) or NO_GRADE for one, _ in students]
    _write(path, [[*columns], *map(list, zip(*columns.values(), strict=True))])


def write_worksheet(
    path: Path, people: ClassList, grades: Mapping[str, float], points: float
) -> bool:
    """Write a grading worksheet that an instructor can upload to a Moodle assignment.

    The worksheet lists all submissions that were downloaded from Moodle. It needs no roster,
    because the folder names in a Moodle download contain the numbers of the participants. The
    column for comments is left out, because its empty cells would delete the comments in Moodle.

    Returns:
        True if the worksheet was written, or False if there are no submissions from Moodle.
    """
    rows = []
    for member in people.members:
        export = member.submission.export if member.submission else None
        if export and export.platform == "moodle":
            who = f"Participant {export.number}", as_cell(export.name)
            rows.append([*who, number(grades.get(member.shown)), number(points), "Yes", "-"])
    if rows:
        _write(path, [WORKSHEET, *rows])
    return bool(rows)


def _write(path: Path, rows: list[list[str]]) -> None:
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    replace_file(path, text.getvalue())
