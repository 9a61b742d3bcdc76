"""Write gradebook.csv, with a row per student and a column per exercise."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from pathlib import Path

from autograder.clean import clean_line
from autograder.manifest import Chapter
from autograder.reports.report import StudentReport
from autograder.reports.texts import number, replace_file

MISSING = "nothing handed in"
UNMATCHED = "not in the roster"
COLUMNS = "student,status,score,score on given chapters,by hand,waiting,total"
# A character that begins a formula, also in full width, at the start of a cell or after spaces. A
# spreadsheet that separates columns by semicolons begins a cell after each of them.
FORMULA = re.compile(r"(^|;)(\s*)(?=[=+\-@＝＋－＠])")  # noqa: RUF001


def write_gradebook(
    out: Path,
    chapters: list[Chapter],
    reports: Sequence[StudentReport],
    missing: Sequence[str] = (),
    unmatched: Sequence[str] = (),
) -> Path:
    """Write gradebook.csv with the points possible in its second row, and return its path.

    An empty cell means that there is no grade: an answer waits for a person, the grader failed, or
    the student is ``missing``, since nothing was handed in. ``unmatched`` are those who are not in
    the roster.
    """
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = sum(exercise.points for exercise in exercises if exercise.kind == "written")
    points = [exercise.points for exercise in exercises]
    checked = sum(points) - written
    rows = [
        [*COLUMNS.split(","), *(as_cell(exercise.id) for exercise in exercises)],
        ["points possible", "", *map(str, (checked, checked, written, "", sum(points), *points))],
    ]
    for report in reports:
        scores = {exercise.id: exercise.score for exercise in report.exercises}
        cells = [
            report.score,
            report.score_on_given,
            report.by_hand,
            report.waiting,
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


def as_cell(text: str) -> str:
    """Return a text on one line that no spreadsheet reads as a formula."""
    return FORMULA.sub(r"\1\2'", clean_line(text))
