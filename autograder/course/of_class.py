"""Compute late penalties and scale marks for a whole class, as the course file specifies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from autograder.course.dates import parse_time
from autograder.course.late import HandedIn, late_of
from autograder.course.mistakes import nearest
from autograder.course.model import Deadline
from autograder.course.times import TIMES, times_of
from autograder.manifest import Chapter
from autograder.reports.marks import Marks
from autograder.reports.report import Late
from autograder.scores import possible
from autograder.submissions.find import Submission


def lateness(
    deadline: Deadline, chapters: list[Chapter], folder: Path, submissions: list[Submission]
) -> tuple[dict[str, Late], list[str]]:
    """Compute how late the work of each student in a class is, and how many points that costs.

    Return the results together with a list of notes for the instructor. A note may say, for
    example, that some submission times are unknown.

    Raises:
        ValueError: A file with the times of the submissions is not valid.
    """
    said = times_of(folder, submissions, deadline.due.tzinfo or UTC)
    points = points_of(chapters)
    students = [submission.student for submission in submissions]
    late = {
        submission.student: late_of(
            deadline, submission.names, said.get(submission.student), points
        )
        for submission in submissions
    }
    notes = []
    names = [name for submission in submissions for name in submission.names]
    for name in (name for name in deadline.extensions if name not in names):
        wanted = nearest(name, names, 1)
        notes.append(f"Extension for {name!r}: no submission has this name. {wanted}".strip())
    add = f"To add times, write {folder / TIMES}."
    if unknown := [student for student in students if student not in said]:
        notes.append(
            f"The submission time is unknown for {len(unknown)} of {len(students)} students, who "
            f"therefore get no penalty: {_some(unknown)}. {add}"
        )
    unclear = [student for student, at in said.items() if at.late and at.at is None]
    if unclear:
        notes.append(
            f"Late by an unknown amount of time, and therefore without a penalty: {len(unclear)} "
            f"({_some(unclear)}). {add}"
        )
    if days := [each for each in late.values() if each.days]:
        lose = sum(each.deduction > 0.0 for each in days)
        notes.append(f"Late: {len(days)}. With a penalty: {lose}.")
    return late, notes


def _some(names: list[str]) -> str:
    return ", ".join(names[:5]) + (", ..." if len(names) > 5 else "")


def late_on_gradescope(
    deadline: Deadline, chapters: list[Chapter], metadata: dict[str, Any]
) -> Late:
    """Compute how late a submission to Gradescope is, from the metadata that Gradescope provides.

    A submission can have several authors. If one of them has an extension, it applies to the whole
    group. The course file may identify this author by name or by e-mail address.
    """
    try:
        at: datetime | None = parse_time(metadata["created_at"], deadline.due.tzinfo or UTC)
    except (KeyError, TypeError, ValueError, AttributeError):
        at = None
    users = metadata.get("users")
    users = [user for user in users if isinstance(user, dict)] if isinstance(users, list) else []
    names = [str(user.get(key)) for user in users for key in ("name", "email")]
    said = HandedIn("Gradescope", at) if at else None
    return late_of(deadline, names, said, points_of(chapters))


def points_of(chapters: Iterable[Chapter]) -> float:
    """Add up the points of all exercises in these chapters, including the written answers.

    Extra credit and optional exercises are left out.
    """
    return possible(exercise for chapter in chapters for exercise in chapter.exercises)


def scaled_marks(marks: Marks, chapters: Iterable[Chapter], manifests: list[Chapter]) -> Marks:
    """Scale the marks for written answers to the points that they are worth in the assignment.

    Instructors mark with our rubrics, which use the points in the manifest. An assignment may give
    more or fewer points for the same exercise.
    """
    rubric = {e.id: e.points for chapter in manifests for e in chapter.exercises}
    assigned = {e.id: e.points for chapter in chapters for e in chapter.exercises}
    return {
        (student, name): replace(
            mark, points=round(mark.points * assigned.get(name, rubric[name]) / rubric[name], 2)
        )
        for (student, name), mark in marks.items()
    }
