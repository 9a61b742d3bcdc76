"""Read the marks for written answers, which an instructor gives, and add them to the reports."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.manifest import Chapter, Exercise
from autograder.reports.report import StudentReport
from autograder.scores import ExerciseStatus
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import read_csv

HEADER = ["student", "exercise", "points", "comment"]
# A spreadsheet would take such a comment for a formula, so it has an apostrophe in front.
GUARDED = re.compile(r"^'(?='*[=+\-@＝＋－＠])")  # noqa: RUF001


@dataclass(frozen=True)
class Mark:
    """An instructor's mark for a student's written answer: the points and a comment."""

    points: float
    comment: str


Marks = dict[tuple[str, str], Mark]  # keyed by student and exercise


@dataclass(frozen=True)
class Row:
    """A row of marks.csv: the mark for one student's answer to one exercise."""

    student: str  # the name in the file
    report: str  # the name of the student's report, or "" if nothing was handed in
    exercise: str
    mark: Mark
    line: int  # the number of its first line, counted from 1


Rows = dict[tuple[str, str], Row]  # keyed by the report, or the student without one, and exercise


def read_marks(path: Path, chapters: list[Chapter], people: ClassList) -> tuple[Marks, list[str]]:
    """Read marks.csv, and return the marks and notes on rows that have no effect."""
    rows = read_rows(path, chapters, people)[1].values()
    absent = [row.student for row in rows if not row.report]
    notes = [f"{path}: {', '.join(absent)} handed in nothing, so the marks are not used."]
    marks = {(row.report, row.exercise): row.mark for row in rows if row.report}
    return marks, notes if absent else []


def read_rows(path: Path, chapters: list[Chapter], people: ClassList) -> tuple[str, Rows]:
    """Read the rows of marks.csv and the separator of its columns, a comma or a semicolon.

    European spreadsheets separate columns with semicolons and write decimal commas.
    """
    if not path.exists():
        return ",", {}
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = {exercise.id: exercise for exercise in exercises if exercise.kind == "written"}
    table = read_csv(path)
    table.require(HEADER)
    found: Rows = {}
    for line, (name, exercise, points_given, comment) in table.rows():
        try:
            report = people.report_of(name)
            if exercise not in written:
                wanted = ", ".join(written) or "none, as there are no written exercises"
                raise ValueError(f"the exercise must be one of {wanted}, got {exercise!r}")
            points = _points(points_given, table.separator, written[exercise])
        except ValueError as error:
            raise table.mistake(line, error) from error
        row = Row(name, report, exercise, Mark(points, re.sub(GUARDED, "", comment)), line)
        before = found.setdefault((report or name, exercise), row)
        if before is not row:
            words = f"a second mark for {report or name!r} in {exercise}, as in line"
            raise table.mistake(line, f"{words} {before.line}. Give only one")
    return table.separator, found


def apply_marks(
    report: StudentReport,
    marks: Marks,
    is_changed: Callable[[str, Mark], bool] = lambda *_: False,
) -> StudentReport:
    """Return a copy of a student's report with these marks in place of any earlier ones.

    ``is_changed`` says whether a mark was given for another answer. Such a mark counts, too.
    """
    results = []
    given: list[float] = []
    waiting = 0.0
    for result in report.results:
        if (exercise := result.exercise).kind == "written":
            if mark := marks.get((report.student, exercise.id)):
                status: ExerciseStatus = "changed" if is_changed(exercise.id, mark) else "marked"
                points, comment = mark.points, mark.comment
                given.append(points)
            else:
                status, points, comment = "waiting", None, ""
                waiting += exercise.points
            result = replace(
                result, status=status, score=points, score_on_given=points, comment=comment
            )
        results.append(result)
    by_hand = round(sum(given), 2) if given else None
    return replace(report, results=results, by_hand=by_hand, waiting=waiting)


def _points(given: str, separator: str, exercise: Exercise) -> float:
    decimal = given.replace(",", ".") if separator == ";" else given
    points = float(decimal) if re.fullmatch(r"[0-9]+(\.[0-9]+)?", decimal) else None
    if points is None or points > exercise.points:
        wanted = f"must be a number from 0 to {exercise.points:g}, got {given!r}"
        raise ValueError(f"the points for {exercise.id} {wanted}")
    return points
