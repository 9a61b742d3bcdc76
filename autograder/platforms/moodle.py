"""Write a class's grades to files that Moodle can import.

These are moodle.csv for the gradebook, and a copy of an assignment's grading worksheet.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from pathlib import Path

from autograder.files import replace_bytes
from autograder.reports.texts import number, replace_file
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell
from autograder.submissions.moodle_worksheet import Worksheet

MOST = 100.0  # Moodle does not import larger grades, unless the site allows it
NO_GRADE = "-"  # Moodle reads an empty cell as 0 if the column becomes a new grade item


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
    columns[title] = [number(grades.get(one.report)) or NO_GRADE for one, _ in students]
    _write(path, [[*columns], *map(list, zip(*columns.values(), strict=True))])


def from_moodle(people: ClassList) -> dict[str, str]:
    """Find the submissions that were downloaded from Moodle.

    Returns:
        The name of each participant's report, by the participant's number in Moodle.
    """
    found = {}
    for member in people.members:
        export = member.submission.export if member.submission else None
        if export and export.platform == "moodle":
            found[export.number] = member.report
    return found


def write_worksheet(
    path: Path, worksheet: Worksheet, people: ClassList, grades: Mapping[str, float]
) -> list[str]:
    """Write a copy of a Moodle assignment's grading worksheet with the grades filled in.

    It needs no roster, because the folder names in a Moodle download contain the numbers of the
    participants. Nothing is written if there is no grade for any participant.

    Returns:
        The students who have a grade but are not in the worksheet.
    """
    known = {row.number for row in worksheet.rows}
    reports = {number: one for number, one in from_moodle(people).items() if number in known}
    filled = {number: grades[one] for number, one in reports.items() if one in grades}
    if filled:
        replace_bytes(path, worksheet.filled(filled))
    return sorted(grades.keys() - reports.values())


def _write(path: Path, rows: list[list[str]]) -> None:
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    replace_file(path, text.getvalue())
