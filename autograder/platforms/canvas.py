"""Write canvas.csv, from which an instructor can import grades into the Canvas gradebook."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping
from pathlib import Path

from autograder.reports.texts import number, replace_file
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.csv_rows import FORMULA, as_cell
from autograder.submissions.names import key, letters
from autograder.text.clean import clean_line

HEADER = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"]
# If the title of a column contains one of these words, Canvas ignores the column.
NOT_IMPORTED = re.compile(r"(Current|Final) (Score|Points|Grade)|Override (Score|Grade|Status)")
OTHER_COLUMNS = (*HEADER, "LastName", "FirstName", "Integration ID", "Root Account")


def write_canvas(
    path: Path, people: ClassList, grades: Mapping[str, float], title: str, points: float
) -> None:
    """Write the grades of a class to a file that Canvas can import.

    The file has a row for each student on the roster. Canvas recognizes a student by the ID or, if
    that is empty, by the SIS user ID, the login or the name. A student without a grade gets an
    empty cell. ``title`` is the title of an existing assignment, such as "Lab 1 (12345)", or of a
    new one.
    """
    rows = [[*HEADER, title], ["    Points Possible", "", "", "", "", number(points)]]
    for member in people.members:
        if who := member.student:
            name = as_cell(who.name)
            login = who.login or who.email
            grade = number(grades.get(member.report))
            rows.append([name, _canvas_id(member, people), who.id, login, "", grade])
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    replace_file(path, text.getvalue())


def check_title(title: str) -> str:
    """Check that Canvas will import a column with this title, and return the title unchanged.

    Raises:
        ValueError: The title is not one line of text, begins like a formula, or is the name of a
            column that Canvas does not import.
    """
    if not title.strip() or clean_line(title) != title or FORMULA.search(title):
        raise ValueError(
            f"--title must be one line of text, and not begin like a formula, got {title!r}"
        )
    if title in OTHER_COLUMNS or NOT_IMPORTED.search(title):
        raise ValueError(
            f"--title must not be the name of one of Canvas's own columns, got {title!r}"
        )
    return title


def _canvas_id(member: Member, people: ClassList) -> str:
    """Find a student's ID number in Canvas, or return "" if it is unknown.

    If the student submitted the work through Canvas, the name of the submission contains the
    number. In a group, that is the number of only one of the students. Otherwise the student's id
    on the roster is used if it is a number, but not if it is the number of another student. Canvas
    would mistake the digits at the start of any other id for one of its own IDs.
    """
    student = member.student
    own = student.id if student else ""
    export = member.submission.export if member.submission else None
    if student and export and export.platform == "canvas" and export.number.isdecimal():
        group = [m.student for m in people.members if m.report == member.report and m.student]
        if len(group) == 1:
            return export.number
        if all(key(one.id) != key(export.number) for one in group):
            # The ids on the roster are not those of Canvas.
            named = [one for one in group if letters(export.name) in one.canvas_names]
            return export.number if named == [student] else ""
    others = {
        other.submission.export.number
        for other in people.members
        if other.submission and other.submission.export and other.report != member.report
    }
    return own if re.fullmatch(r"[1-9][0-9]*", own) and own not in others else ""
