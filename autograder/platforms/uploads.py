"""Write a class's grades to files that Canvas and Moodle can import."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.manifest import Chapter
from autograder.platforms.canvas import check_title, write_canvas
from autograder.platforms.moodle import MOST, from_moodle, write_moodle, write_worksheet
from autograder.reports.report import StudentReport
from autograder.scores import possible, shown
from autograder.submissions.class_list import ClassList
from autograder.submissions.exports import OF_MOODLE
from autograder.submissions.moodle_worksheet import Worksheet
from autograder.submissions.names import some

CANVAS_ID = re.compile(r" \([0-9]+\)$")  # in Canvas, the title of an assignment ends with its id


@dataclass(frozen=True)
class Column:
    """The gradebook column on Canvas or Moodle into which the grades are imported.

    Attributes:
        title: The title of the column. It may end with the id of an assignment, as in "Lab 1
            (12345)".
        points: What full points are worth on the platform. All grades are scaled accordingly, and
            extra credit can make a grade larger.
    """

    title: str = ""
    points: float | None = None

    def __post_init__(self) -> None:
        if self.title:
            check_title(self.title)
        if self.points is not None and not 0 < self.points < float("inf"):
            raise ValueError(f"--points must be a positive number, got {self.points:g}")


@dataclass(frozen=True)
class _Grades:
    """The grades for one of the files.

    Attributes:
        file: The name of the file.
        full: What full points are worth.
        limit: The largest grade that the platform accepts. Larger grades are cut.
        totals: The points of each student who has a grade.
        most: The points that are possible without extra credit.
    """

    file: str
    full: float
    limit: float
    totals: Mapping[str, float]
    most: float

    @property
    def scaled(self) -> dict[str, float]:
        """The grade of each student."""
        return {name: min(grade, self.limit) for name, grade in self._whole.items()}

    @property
    def lines(self) -> list[str]:
        """What the instructor should know about these grades."""
        lines = []
        if self.full != self.most:
            lines.append(
                f"{self.file}: rescaled from {shown(self.most)} points to {shown(self.full)}. "
                "Choose other points with POINTS=."
            )
        if over := sorted(name for name, grade in self._whole.items() if grade > self.limit):
            best = max(self.totals.values())
            points = math.floor(100 * self.limit * self.most / best) / 100
            lines.append(
                f"{self.file}: grades above {shown(self.limit)} were cut, because Moodle accepts "
                f"no larger ones: {len(over)} ({some(over)}). With POINTS={shown(points)}, no "
                "grade is cut."
            )
        return lines

    @property
    def _whole(self) -> dict[str, float]:
        scale = self.full / self.most
        return {name: round(total * scale, 2) for name, total in self.totals.items()}


def write_uploads(
    folder: Path,
    chapters: Sequence[Chapter],
    people: ClassList,
    reports: Sequence[StudentReport],
    column: Column,
    worksheet: Worksheet | None = None,
) -> tuple[list[Path], list[str]]:
    """Write the files from which an instructor can import grades into Canvas or Moodle.

    These are canvas.csv and moodle.csv if the class has a roster, plus Moodle's own grading
    worksheet if the instructor has saved it with the submissions.

    Returns:
        The paths of the files, and notes for the instructor.
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
        of_canvas = _Grades("canvas.csv", full, math.inf, totals, most)
        write_canvas(paths[0], people, of_canvas.scaled, title, full)
        full = min(column.points or MOST, MOST)
        of_moodle = _Grades("moodle.csv", full, MOST, totals, most)
        write_moodle(paths[1], people, of_moodle.scaled, CANVAS_ID.sub("", title))
        lines += of_canvas.lines + of_moodle.lines
    if worksheet:
        full = min(column.points or worksheet.most, worksheet.most)
        grades = _Grades("moodle-worksheet.csv", full, worksheet.most, totals, most)
        path = folder / grades.file
        is_written, left_out = write_worksheet(path, worksheet, people, grades.scaled)
        if is_written:
            paths.append(path)
            lines += grades.lines
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
    elif from_moodle(people):
        lines.append(
            f"For grades in the Moodle assignment itself, download its grading worksheet, save it "
            f"as {OF_MOODLE} in the folder with the submissions, and grade again with this seed."
        )
    if paths and (waiting := sum(r.waiting > 0 for r in reports)):
        lines.append(
            f"Students with answers that are not marked yet: {waiting}. Until then, those answers "
            "earn no points in the grades for the platforms."
        )
    return paths, lines
