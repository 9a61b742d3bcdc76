"""Read the marks for students' written answers, and add them to the reports.

The autograder cannot judge written answers. An instructor reads them, and enters points and
comments in marks.csv.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.manifest import Chapter, Exercise
from autograder.reports.gradebook import as_cell
from autograder.reports.report import ExerciseReport, StudentReport
from autograder.scores import shown
from autograder.submissions.csv_rows import read_csv
from autograder.text.clean import clean

HEADER = ["student", "exercise", "points", "comment"]
# A spreadsheet would take such a comment for a formula, so we store it with an apostrophe in front.
FORMULA_START = re.compile(r"^(?='*[=+\-@＝＋－＠])")  # noqa: RUF001
GUARDED = re.compile(r"^'(?='*[=+\-@＝＋－＠])")  # noqa: RUF001


@dataclass(frozen=True)
class Mark:
    """An instructor's mark for a student's written answer: the points and a comment."""

    points: float
    comment: str


Marks = dict[tuple[str, str], Mark]  # keyed by student and exercise


@dataclass(frozen=True)
class Row:
    """A row of marks.csv: the mark for one student's answer to one exercise.

    Attributes:
        student: The student's name.
        exercise: The id of the exercise.
        mark: The points and the comment.
        first: The number of the row's first line in the file, counted from 1.
        last: The number of its last line, which is larger if the comment spans several lines.
    """

    student: str
    exercise: str
    mark: Mark
    first: int
    last: int


def read_marks(path: Path, chapters: list[Chapter], students: Iterable[str]) -> Marks:
    """Read marks.csv, where instructors enter points and comments for students' written answers.

    The columns are student, exercise, points and comment. European spreadsheets separate columns
    with semicolons and write decimal commas, so both are accepted. If the file does not exist,
    there are no marks.

    Raises:
        ValueError: A line is invalid. The message gives its number and says what is wrong.
    """
    _, rows = read_rows(path, chapters, students)
    return {(row.student, row.exercise): row.mark for row in rows}


def read_rows(
    path: Path, chapters: list[Chapter], students: Iterable[str]
) -> tuple[str, list[Row]]:
    """Read the rows of marks.csv, together with their line numbers and the column separator.

    With this information, a program can change a single mark and leave the other lines untouched.

    Returns:
        The separator, which is a comma or a semicolon, and the rows.

    Raises:
        ValueError: A line is invalid, as in ``read_marks``.
    """
    if not path.exists():
        return ",", []
    exercises = {exercise.id: exercise for chapter in chapters for exercise in chapter.exercises}
    names = _names(students)
    found: dict[tuple[str, str], Row] = {}
    separator, rows = _rows(path)
    for line, last, row in rows:
        where = f"{path}, line {line}"
        student_given, exercise_given, points_given, comment = row
        student = names.get(student_given) or names.get(_key(student_given))
        if student is None:
            raise ValueError(
                f"{where}: student {student_given!r} did not hand anything in. Use the name in the "
                "gradebook"
            )
        exercise = _written(where, exercise_given, exercises)
        if (student, exercise.id) in found:
            raise ValueError(
                f"{where}: a second mark for {student!r} in {exercise.id}. Give only one"
            )
        decimal = points_given.replace(",", ".") if separator == ";" else points_given
        points = float(decimal) if re.fullmatch(r"[0-9]+(\.[0-9]+)?", decimal) else None
        if points is None or points > exercise.points:
            raise ValueError(
                f"{where}: the points for {exercise.id} must be a number from 0 to "
                f"{exercise.points}, got {points_given!r}"
            )
        mark = Mark(points, re.sub(GUARDED, "", comment))
        found[student, exercise.id] = Row(student, exercise.id, mark, line, last)
    return separator, [*found.values()]


def row_of(student: str, exercise: str, mark: Mark, students: Iterable[str]) -> list[str]:
    """Build the row of marks.csv that records the mark for one student's answer.

    The name and the comment are escaped if a spreadsheet would take them for formulas.
    """
    harmless = as_cell(student)
    name = harmless if _names(students).get(harmless) == student else student
    comment = clean(mark.comment).strip()
    return [name, exercise, shown(mark.points), re.sub(FORMULA_START, "'", comment)]


def renamed(marks: Marks, names: Mapping[str, str], path: Path) -> Marks:
    """Return a copy of the marks in which each student has the same name as in the reports.

    The name in marks.csv may be different, for example if it comes from the roster. ``names`` maps
    every possible name of a student to the name in the reports.

    Raises:
        ValueError: A student has two marks for the same exercise, under different names.
    """
    found: Marks = {}
    for (student, exercise), mark in marks.items():
        if (names[student], exercise) in found:
            raise ValueError(
                f"{path}: a second mark for {student!r} in {exercise}, under another name. Give "
                "only one"
            )
        found[names[student], exercise] = mark
    return found


def apply_marks(report: StudentReport, marks: Marks) -> StudentReport:
    """Return a copy of a student's report that contains the marks for written answers.

    Any earlier marks in the report are replaced. An answer without a mark is reported as waiting to
    be marked.
    """
    exercises = []
    given: list[float] = []
    waiting = 0.0
    for exercise in report.exercises:
        if exercise.kind == "written":
            mark = marks.get((report.student, exercise.id))
            exercise = _marked(exercise, mark)
            if mark is None:
                waiting += exercise.points
            else:
                given.append(mark.points)
        exercises.append(exercise)
    by_hand = round(sum(given), 2) if given else None
    return replace(report, exercises=exercises, by_hand=by_hand, waiting=waiting)


def _marked(exercise: ExerciseReport, mark: Mark | None) -> ExerciseReport:
    if mark is None:
        return replace(exercise, status="waiting", score=None, score_on_given=None, comment="")
    points = mark.points
    return replace(
        exercise, status="marked", score=points, score_on_given=points, comment=mark.comment
    )


def _rows(path: Path) -> tuple[str, Iterator[tuple[int, int, list[str]]]]:
    """Open marks.csv, in which instructors enter marks, and check its header.

    Returns:
        The column separator, and the rows below the header with their first and last line numbers.
    """
    table = read_csv(path)
    if table.header != HEADER:
        wanted = ",".join(HEADER)
        raise ValueError(f"{path}, line 1: the header must be {wanted}, got {table.first_line!r}")
    return table.separator, table.rows("comment")


def _written(where: str, given: str, exercises: dict[str, Exercise]) -> Exercise:
    written = [exercise.id for exercise in exercises.values() if exercise.kind == "written"]
    wanted = f"Written exercises: {', '.join(written) or 'none'}"
    if given not in exercises:
        raise ValueError(f"{where}: there is no exercise {given!r}. {wanted}")
    if exercises[given].kind != "written":
        raise ValueError(f"{where}: exercise {given!r} gets its points from checks. {wanted}")
    return exercises[given]


def _names(students: Iterable[str]) -> dict[str, str]:
    """Map every spelling of a student's name that marks.csv may contain to the name in the reports.

    A spreadsheet may have changed how accents are encoded, or added an apostrophe to a name that
    looks like a formula. If the names of two students share a spelling, that spelling is left out
    unless it is the exact name of one of them.
    """
    forms: dict[str, set[str]] = {}
    for name in students:
        for form in (name, _key(name), _key(as_cell(name))):
            forms.setdefault(form, set()).add(name)
    exact = {form: form for form, names in forms.items() if form in names}
    return {form: min(names) for form, names in forms.items() if len(names) == 1} | exact


def _key(name: str) -> str:
    """Normalize the accented letters in a student's name, so that names can be compared.

    Unicode has two encodings for a letter such as é. Both look the same, but they do not compare
    equal.
    """
    return unicodedata.normalize("NFC", name.strip())
