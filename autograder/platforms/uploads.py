"""Write a class's grades to files that Canvas and Moodle can import."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.files import replace_bytes, replace_table
from autograder.manifest import Chapter
from autograder.reports.report import StudentReport
from autograder.reports.texts import number
from autograder.scores import possible, shown
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.csv_rows import FORMULA, as_cell
from autograder.submissions.exports import OF_MOODLE
from autograder.submissions.moodle_worksheet import Worksheet
from autograder.submissions.names import Names, key, letters, some
from autograder.text.clean import clean_line

CANVAS_ID = re.compile(r" \([0-9]+\)$")  # in Canvas, the title of an assignment ends with its id
OF_CANVAS = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"]
MOST_IN_MOODLE = 100.0  # Moodle does not import larger grades, unless the site allows it
NO_GRADE = "-"  # Moodle reads an empty cell as 0 if the column becomes a new grade item


@dataclass(frozen=True)
class Column:
    """The gradebook column on Canvas or Moodle into which the grades are imported.

    ``points`` is what full points are worth there. All grades are scaled accordingly. The title may
    end with the id of an assignment, as in "Lab 1 (12345)".
    """

    title: str = ""
    points: float | None = None

    def __post_init__(self) -> None:
        title = self.title
        if title and (not title.strip() or clean_line(title) != title or FORMULA.search(title)):
            raise ValueError(
                f"--title must be one line of text, and not begin like a formula, got {title!r}"
            )
        if self.points is not None and not 0 < self.points < float("inf"):
            raise ValueError(f"--points must be a positive number, got {self.points:g}")


def _scaled(
    totals: Mapping[str, float], most: float, file: str, full: float, limit: float
) -> tuple[dict[str, float], list[str]]:
    """Scale points out of ``most`` for a file in which full points are worth ``full``, with notes.

    Larger grades than ``limit`` are cut, because the platform does not accept them.
    """
    grades = {name: round(total * full / most, 2) for name, total in totals.items()}
    lines = []
    if full != most:
        lines.append(
            f"{file}: rescaled from {shown(most)} points to {shown(full)}. Choose other points "
            "with POINTS=."
        )
    if over := sorted(name for name, grade in grades.items() if grade > limit):
        lines.append(
            f"{file}: grades above {shown(limit)} were cut, because Moodle accepts no larger "
            f"ones: {len(over)} ({some(over)}). Choose fewer points with POINTS=."
        )
    return {name: min(grade, limit) for name, grade in grades.items()}, lines


def write_uploads(
    folder: Path,
    chapters: Sequence[Chapter],
    people: ClassList,
    reports: Sequence[StudentReport],
    column: Column,
    worksheet: Worksheet | None = None,
) -> tuple[list[Path], list[str]]:
    """Write the files for Canvas and Moodle, and return their paths, and notes for the instructor.

    These are canvas.csv and moodle.csv if the class has a roster, plus a copy of Moodle's grading
    worksheet if there is one.
    """
    most = possible(exercise for chapter in chapters for exercise in chapter.exercises)
    totals = {r.student: r.total for r in reports if r.status == "graded" and r.total is not None}
    title = column.title or "Chapters " + ", ".join(str(chapter.number) for chapter in chapters)
    paths: list[Path] = []
    lines: list[str] = []
    if people.has_roster:
        if people.unmatched:
            lines.append("Not in canvas.csv and moodle.csv: " + "; ".join(people.unmatched) + ".")
        paths += [folder / "canvas.csv", folder / "moodle.csv"]
        full = column.points or most
        grades, notes = _scaled(totals, most, "canvas.csv", full, math.inf)
        replace_table(paths[0], _for_canvas(people, grades, title, full))
        lines += notes
        full = min(column.points or MOST_IN_MOODLE, MOST_IN_MOODLE)
        grades, notes = _scaled(totals, most, "moodle.csv", full, MOST_IN_MOODLE)
        replace_table(paths[1], _for_moodle(people, grades, CANVAS_ID.sub("", title)))
        lines += notes
    if worksheet:
        full = min(column.points or worksheet.most, worksheet.most)
        path = folder / "moodle-worksheet.csv"
        grades, notes = _scaled(totals, most, path.name, full, worksheet.most)
        members = _members_in(worksheet, people)
        filled = {n: grades[m.report] for n, m in members.items() if m.report in grades}
        if filled:
            paths.append(path)
            replace_bytes(path, worksheet.filled(filled))
            lines += notes
        there = {*members.values()}
        left_out = [m.shown for m in people.members if m.report in grades and m not in there]
        if left_out:
            lines.append(
                f"Not in {worksheet.path.name} from Moodle: {some(left_out)}. Make sure that it "
                "is the worksheet of this assignment, downloaded after the last submission."
            )
        if worksheet.unread:
            lines.append(
                f"{worksheet.path.name}: {len(worksheet.unread)} submission times cannot be read, "
                f"such as {worksheet.unread[0]!r}."
            )
    elif _from_moodle(people):
        lines.append(
            f"For grades in the Moodle assignment itself, download its grading worksheet, save it "
            f"as {OF_MOODLE} in the folder with the submissions, and grade again."
        )
    if paths and (waiting := sum(r.waiting > 0 for r in reports)):
        lines.append(
            f"Students with answers that are not marked yet: {waiting}. Until then, those answers "
            "earn no points in the grades for the platforms."
        )
    return paths, lines


def _for_canvas(
    people: ClassList, grades: Mapping[str, float], title: str, full: float
) -> list[list[str]]:
    """Make a table of the roster, with the columns that Canvas needs to recognize students."""
    rows = [[*OF_CANVAS, title], ["    Points Possible", "", "", "", "", number(full)]]
    for member in people.members:
        if who := member.student:
            known = [as_cell(who.name), _canvas_id(member, people), who.id, who.login or who.email]
            rows.append([*known, "", number(grades.get(member.report))])
    return rows


def _canvas_id(member: Member, people: ClassList) -> str:
    """Find a student's ID number in Canvas, or return "" if it is unknown.

    The name of a submission through Canvas contains the number, in a group of only one of the
    students. Otherwise the student's id on the roster is used if it is a number, but not if it is
    the number of another student. Canvas would mistake the digits at the start of any other id for
    one of its own IDs.
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


def _for_moodle(people: ClassList, grades: Mapping[str, float], title: str) -> list[list[str]]:
    """Make a table with a row for each student on the roster.

    Moodle stops the import at a student it does not know. If the cell that should identify a
    student is empty, Moodle even gives the grade to the student in the row above. That is why the
    columns for logins and e-mail addresses are written only if every student has one.
    """
    students = [(member, member.student) for member in people.members if member.student]
    columns = {"ID number": [who.id for _, who in students]}
    if all(who.login for _, who in students):
        columns["Username"] = [who.login for _, who in students]
    if all(who.email for _, who in students):
        columns["Email address"] = [who.email for _, who in students]
    columns["Full name"] = [as_cell(who.name) for _, who in students]
    columns[title] = [number(grades.get(one.report)) or NO_GRADE for one, _ in students]
    return [[*columns], *map(list, zip(*columns.values(), strict=True))]


def _from_moodle(people: ClassList) -> dict[str, str]:
    """Return the report of each submission from Moodle, by the number of its participant."""
    exports = [(m.submission.export, m.report) for m in people.members if m.submission]
    return {one.number: report for one, report in exports if one and one.platform == "moodle"}


def _members_in(worksheet: Worksheet, people: ClassList) -> dict[str, Member]:
    """Find the student in each row of a worksheet, by the participant's number.

    Only a student who has uploaded something has a number in the class. The others of a group are
    found by what the worksheet says about them. Students of whose group no submission is in this
    worksheet are left out. Otherwise, the grades could get into the worksheet of another
    assignment, where participants have other numbers.
    """
    reports = _from_moodle(people)
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
