"""Write a class's grades to files that Canvas and Moodle can import."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.manifest import Chapter
from autograder.platforms.canvas import check_title, write_canvas
from autograder.platforms.moodle import MOST, write_moodle, write_worksheet
from autograder.reports.report import StudentReport
from autograder.scores import possible, shown
from autograder.submissions.class_list import ClassList

CANVAS_ID = re.compile(r" \([0-9]+\)$")  # in Canvas, the title of an assignment ends with its id


@dataclass(frozen=True)
class Column:
    """The gradebook column on Canvas or Moodle into which the grades are imported.

    Attributes:
        title: The title of the column. It may end with the id of an assignment, as in "Lab 1
            (12345)".
        points: The number of points that the assignment is worth on the platform. All grades are
            scaled to this number.
    """

    title: str = ""
    points: float | None = None

    def __post_init__(self) -> None:
        if self.title:
            check_title(self.title)
        if self.points is not None and not 0 < self.points < float("inf"):
            raise ValueError(f"--points must be a positive number, got {self.points:g}")


def write_uploads(
    folder: Path,
    chapters: Sequence[Chapter],
    people: ClassList,
    reports: Sequence[StudentReport],
    column: Column,
) -> tuple[list[Path], list[str]]:
    """Write the files from which an instructor can import grades into Canvas or Moodle.

    These are canvas.csv and moodle.csv if the class has a roster, plus Moodle's grading worksheet
    if there are submissions from Moodle.

    Returns:
        The paths of the files, and notes for the instructor.
    """
    most = possible(exercise for chapter in chapters for exercise in chapter.exercises)
    for_canvas = column.points or most
    for_moodle = min(column.points or MOST, MOST)
    title = column.title or "Chapters " + ", ".join(str(chapter.number) for chapter in chapters)
    totals = {r.student: r.total for r in reports if r.status == "graded" and r.total is not None}

    def scaled(points: float) -> dict[str, float]:
        return {name: round(total * points / most, 2) for name, total in totals.items()}

    of_moodle = {name: min(grade, for_moodle) for name, grade in scaled(for_moodle).items()}
    paths: list[Path] = []
    lines: list[str] = []
    if people.has_roster:
        paths += [folder / "canvas.csv", folder / "moodle.csv"]
        write_canvas(paths[0], people, scaled(for_canvas), title, for_canvas)
        write_moodle(paths[1], people, of_moodle, CANVAS_ID.sub("", title))
    worksheet = folder / "moodle-worksheet.csv"
    if write_worksheet(worksheet, people, of_moodle, for_moodle):
        paths.append(worksheet)
    if not paths:
        return [], []
    if people.unmatched:
        lines.append("Not in canvas.csv and moodle.csv: " + "; ".join(people.unmatched) + ".")
    for path in paths:
        points = for_canvas if path.name == "canvas.csv" else for_moodle
        if points != most:
            lines.append(
                f"{path.name}: rescaled from {shown(most)} points to {shown(points)}. "
                "Choose other points with POINTS=, up to 100 for Moodle."
            )
    if more := sum(total > most for total in totals.values()):
        lines.append(
            f"Grades over {shown(for_moodle)}: {more}. Moodle would reject them, so "
            f"they are imported as {shown(for_moodle)}."
        )
    if waiting := sum(r.waiting > 0 for r in reports):
        lines.append(
            f"Students with answers that are not marked yet: {waiting}. Until then, those answers "
            "earn no points in the grades for the platforms."
        )
    return paths, lines
