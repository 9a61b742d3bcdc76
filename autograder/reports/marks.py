"""Read the marks for students' written answers, and add them to the reports.

The autograder cannot judge written answers. An instructor reads them, and enters points and
comments in marks.csv.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.manifest import Chapter, Exercise
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import Mistakes, read_csv

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


def read_marks(path: Path, chapters: list[Chapter], people: ClassList) -> tuple[Marks, list[str]]:
    """Read marks.csv, where instructors enter points and comments for students' written answers.

    Returns:
        The marks by the name of the report, and notes on rows that have no effect.

    Raises:
        ValueError: Lines are invalid. The message lists all of them.
    """
    _, rows = read_rows(path, chapters, people)
    absent = [row.student for row in rows if not row.report]
    notes = [f"{path}: {', '.join(absent)} handed in nothing, so the marks are not used."]
    marks = {(row.report, row.exercise): row.mark for row in rows if row.report}
    return marks, notes if absent else []


def read_rows(path: Path, chapters: list[Chapter], people: ClassList) -> tuple[str, list[Row]]:
    """Read the rows of marks.csv and the separator of its columns, a comma or a semicolon.

    European spreadsheets separate columns with semicolons and write decimal commas, so both are
    accepted. If the file does not exist, there are no rows.

    Raises:
        ValueError: Lines are invalid, as in ``read_marks``.
    """
    if not path.exists():
        return ",", []
    exercises = {exercise.id: exercise for chapter in chapters for exercise in chapter.exercises}
    table = read_csv(path)
    if table.header != HEADER:
        wanted = ",".join(HEADER)
        raise ValueError(f"{path}, line 1: the header must be {wanted}, got {table.first_line!r}")
    mistakes = Mistakes(path)
    found: dict[tuple[str, str], Row] = {}
    for line, _, (name, given, points_given, comment) in table.rows("comment", mistakes):
        try:
            report = people.report_of(name)
            exercise = _written(given, exercises)
            points = _points(points_given, table.separator, exercise)
        except ValueError as error:
            mistakes.add(line, str(error))
            continue
        row = Row(name, report, exercise.id, Mark(points, re.sub(GUARDED, "", comment)), line)
        before = found.setdefault((report or name, exercise.id), row)
        if before is not row:
            words = f"a second mark for {report or name!r} in {exercise.id}, as in line"
            mistakes.add(line, f"{words} {before.line}. Give only one")
    mistakes.raise_any()
    return table.separator, [*found.values()]


def apply_marks(
    report: StudentReport,
    marks: Marks,
    is_changed: Callable[[str, Mark], bool] = lambda *_: False,
) -> StudentReport:
    """Return a copy of a student's report that contains the marks for written answers.

    Any earlier marks in the report are replaced. An answer without a mark is reported as waiting to
    be marked. ``is_changed`` says of an exercise and a mark whether the mark was given for another
    answer. Such a mark counts, and is reported as changed.
    """
    results = []
    given: list[float] = []
    waiting = 0.0
    for result in report.results:
        exercise = result.exercise
        if exercise.kind == "written":
            mark = marks.get((report.student, exercise.id))
            if mark is None:
                result = replace(result, status="waiting")
                waiting += exercise.points
            else:
                changed = is_changed(exercise.id, mark)
                result = replace(result, status="changed" if changed else "marked")
                given.append(mark.points)
            points, comment = (mark.points, mark.comment) if mark else (None, "")
            result = replace(result, score=points, score_on_given=points, comment=comment)
        results.append(result)
    by_hand = round(sum(given), 2) if given else None
    return replace(report, results=results, by_hand=by_hand, waiting=waiting)


def _written(given: str, exercises: dict[str, Exercise]) -> Exercise:
    written = [exercise.id for exercise in exercises.values() if exercise.kind == "written"]
    wanted = f"Written exercises: {', '.join(written) or 'none'}"
    if given not in exercises:
        raise ValueError(f"there is no exercise {given!r}. {wanted}")
    if exercises[given].kind != "written":
        raise ValueError(f"exercise {given!r} gets its points from checks. {wanted}")
    return exercises[given]


def _points(given: str, separator: str, exercise: Exercise) -> float:
    decimal = given.replace(",", ".") if separator == ";" else given
    points = float(decimal) if re.fullmatch(r"[0-9]+(\.[0-9]+)?", decimal) else None
    if points is None or points > exercise.points:
        wanted = f"must be a number from 0 to {exercise.points:g}, got {given!r}"
        raise ValueError(f"the points for {exercise.id} {wanted}")
    return points
