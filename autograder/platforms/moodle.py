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
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.csv_rows import as_cell
from autograder.submissions.moodle_worksheet import Worksheet
from autograder.submissions.names import Names

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
) -> tuple[bool, list[str]]:
    """Write a copy of a Moodle assignment's grading worksheet with the grades filled in.

    It needs no roster, because the folder names in a Moodle download contain the numbers of the
    participants. The other students of a group are found by what the worksheet says about them.
    Nothing is written if there is no grade for any participant.

    Returns:
        Whether the file was written, and the students who have a grade but are not in it.
    """
    found = _members_in(worksheet, people)
    filled = {number: grades[m.report] for number, m in found.items() if m.report in grades}
    if filled:
        replace_bytes(path, worksheet.filled(filled))
    there = {*found.values()}
    left_out = [m.shown for m in people.members if m.report in grades and m not in there]
    return bool(filled), left_out


def _members_in(worksheet: Worksheet, people: ClassList) -> dict[str, Member]:
    """Find the student in each row of a worksheet, by the participant's number.

    Students of whose group no submission is in this worksheet are left out. Otherwise, the grades
    could get into the worksheet of another assignment, where participants have other numbers.
    """
    reports = from_moodle(people)
    here = {reports[row.number] for row in worksheet.rows if row.number in reports}
    names = Names((m, m.shown, m.student.names if m.student else ()) for m in people.members)
    found: dict[str, Member] = {}
    for row in worksheet.rows:
        group = [one for one in people.members if one.report == reports.get(row.number)]
        fits = [fit for name in (row.id_number, row.email, row.name) if (fit := names.all_of(name))]
        named = [one for one in group or people.members if fits and all(one in fit for fit in fits)]
        if group or (len(named) == 1 and named[0].report in here):
            found[row.number] = [*named, *group][0]
    return found


def _write(path: Path, rows: list[list[str]]) -> None:
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    replace_file(path, text.getvalue())
