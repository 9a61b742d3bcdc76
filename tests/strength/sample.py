"""The results of the sample class, as its README shows them."""

from __future__ import annotations

import io
from collections.abc import Sequence

from autograder.grader.class_run import print_class
from autograder.grader.conditions import Conditions
from autograder.grader.grading import grade_submission
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, load_chapters
from autograder.reports.report import StudentReport
from autograder.submissions.find import Submission
from autograder.text.wrapping import plain_console

STUDENTS = ("ada", "ben", "dina", "finn", "hana")
WIDTH = 130  # characters of a line; some messages are longer


def sample_table(students: Sequence[str] = STUDENTS) -> str:
    """Grade some students; return their indented lines of the table that `make grade` prints.

    It is a ValueError if Ada's work, the second right solution, loses a point.
    """
    assignment = Conditions(load_chapters(), "1", Level())
    reports = [
        grade_submission(assignment, Submission(student, ROOT / "sample_class" / student))
        for student in students
    ]
    for report in reports:
        if report.student == "ada":
            check_whole(report)
    screen = io.StringIO()
    print_class(plain_console(screen, 1000), reports)
    lines = [line.rstrip() for line in screen.getvalue().splitlines()]
    return "\n".join(f"    {cut(line)}" for line in lines if line.strip(" ─"))


def check_whole(report: StudentReport) -> None:
    for exercise, check in ((r.exercise.id, check) for r in report.results for check in r.checks):
        if check.status != "passed":
            raise ValueError(
                f"sample_class/{report.student} must pass every check, and {check.name} of "
                f"exercise {exercise} says: {check.message.in_short}"
            )


def cut(line: str) -> str:
    """Return a line, or only its beginning and dots if it is too long for the page."""
    return line if len(line) <= WIDTH else f"{line[:WIDTH].rpartition(' ')[0]} ..."
