"""Write gradebook.csv, with a row for each student and a column for each exercise."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from autograder.files import replace_table
from autograder.manifest import Chapter
from autograder.reports.report import StudentReport
from autograder.reports.texts import number
from autograder.scores import possible
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell

MISSING = "nothing handed in"
UNMATCHED = "not on the roster"
COLUMNS = "student,status,score,score on given chapters,by hand,waiting"
WITH_DUE_DATE = ["points", "late days", "penalty"]  # columns for an assignment with a due date


def write_gradebook(
    out: Path, chapters: list[Chapter], reports: Sequence[StudentReport], people: ClassList
) -> Path:
    """Write gradebook.csv, the instructor's table of all grades, and return its path.

    The students of a group have a row each. A cell is empty if there is no grade yet.
    """
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = possible(exercise for exercise in exercises if exercise.kind == "written")
    everything = possible(exercises)
    checked = everything - written
    late = any(report.late for report in reports)
    columns = [*COLUMNS.split(","), *(WITH_DUE_DATE if late else []), "total"]
    of_late = [everything, None, None] if late else []
    points = [exercise.points for exercise in exercises]
    sums = [checked, checked, written, None, *of_late, everything, *points]
    rows = [
        [*columns, *(as_cell(exercise.id) for exercise in exercises)],
        ["points possible", "", *map(number, sums)],
    ]
    for report in reports:
        scores = {result.exercise.id: result.score for result in report.results}
        cells = [report.score, report.score_on_given, report.by_hand, report.waiting]
        if late:
            penalty = None if report.earned is None else report.penalty
            cells += [report.earned, report.late.days if report.late else None, penalty]
        cells += [report.total, *(scores.get(exercise.id) for exercise in exercises)]
        for name in people.students_of(report.student) or [report.student]:
            status = _status(report, is_unmatched=name in people.unmatched)
            rows.append([*map(as_cell, (name, status)), *map(number, cells)])
    rows += [[as_cell(name), MISSING, *[""] * (len(rows[0]) - 2)] for name in people.absent]
    path = out / "gradebook.csv"
    replace_table(path, rows)
    return path


def _status(report: StudentReport, *, is_unmatched: bool) -> str:
    """Say in which state a student is, and what a person should look at."""
    parts = [f"handed in, nothing to grade: {report.nothing}" if report.nothing else report.status]
    parts += [f"changed since marked: {', '.join(report.changed)}"] if report.changed else []
    parts += [UNMATCHED] if is_unmatched else []
    return "; ".join(parts)
