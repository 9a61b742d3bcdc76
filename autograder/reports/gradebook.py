"""Write gradebook.csv, the table of a class's grades.

The table has a row for each student and a column for each exercise. Any spreadsheet can open it.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from pathlib import Path

from autograder.manifest import Chapter
from autograder.reports.report import StudentReport
from autograder.reports.texts import number, replace_file
from autograder.scores import possible
from autograder.text.clean import clean_line

MISSING = "nothing handed in"
UNMATCHED = "not on the roster"
COLUMNS = "student,status,score,score on given chapters,by hand,waiting"
WITH_DUE_DATE = ["points", "late days", "penalty"]  # columns for an assignment with a due date
# If a cell begins with one of these characters, even in full width or after spaces, a spreadsheet
# takes it for a formula. In some countries a new cell also begins after each semicolon.
FORMULA = re.compile(r"(^|;)(\s*)(?=[=+\-@＝＋－＠])")  # noqa: RUF001


def write_gradebook(
    out: Path,
    chapters: list[Chapter],
    reports: Sequence[StudentReport],
    missing: Sequence[str] = (),
    unmatched: Sequence[str] = (),
) -> Path:
    """Write gradebook.csv, the instructor's table of all grades, and return its path.

    The row below the header shows how many points each exercise is worth. A cell is empty if there
    is no grade, for example because nobody has marked the answer yet.

    ``missing`` lists students who have handed in nothing, and ``unmatched`` lists those who are not
    on the roster. If the assignment has a due date, three more columns show the points earned, the
    days late and the penalty. The total is then the points earned minus the penalty.
    """
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = possible(exercise for exercise in exercises if exercise.kind == "written")
    everything = possible(exercises)
    checked = everything - written
    late = any(report.late for report in reports)
    of_late = [everything, None, None] if late else []
    points = [exercise.points for exercise in exercises]
    sums = [checked, checked, written, None, *of_late, everything, *points]
    columns = [*COLUMNS.split(","), *(WITH_DUE_DATE if late else []), "total"]
    rows = [
        [*columns, *(as_cell(exercise.id) for exercise in exercises)],
        ["points possible", "", *map(number, sums)],
    ]
    for report in reports:
        scores = {exercise.id: exercise.score for exercise in report.exercises}
        cells = [
            report.score,
            report.score_on_given,
            report.by_hand,
            report.waiting,
            *(_late(report) if late else ()),
            report.total,
            *(scores.get(exercise.id) for exercise in exercises),
        ]
        status = f"{report.status}; {UNMATCHED}" if report.student in unmatched else report.status
        rows.append([*map(as_cell, (report.student, status)), *map(number, cells)])
    rows += [[as_cell(name), MISSING, *[""] * (len(rows[0]) - 2)] for name in missing]
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    path = out / "gradebook.csv"
    replace_file(path, text.getvalue())
    return path


def _late(report: StudentReport) -> list[float | None]:
    """Return the gradebook's cells for a late penalty: points earned, days late and penalty.

    A cell is None if its value is unknown, for example because the work could not be graded.
    """
    days = report.late.days if report.late else None
    return [report.earned, days, None if report.earned is None else report.penalty]


def as_cell(text: str) -> str:
    """Convert text to a one-line CSV cell that no spreadsheet can interpret as a formula.

    For example, the name "=1+1" becomes "'=1+1", which a spreadsheet shows as plain text.
    """
    return FORMULA.sub(r"\1\2'", clean_line(text))
