"""The `release` command, which gives students the reference solution after the deadline."""

from __future__ import annotations

import argparse
from collections.abc import Collection
from datetime import UTC, datetime

from autograder.course.choose import work_of
from autograder.course.late import clock
from autograder.course.model import Course
from autograder.manifest import load_chapters


def run_release(arguments: argparse.Namespace) -> int:
    """Release what the arguments say, unless a student may still hand it in."""
    from autograder.course.reading import read_course
    from autograder.release.run import release
    from autograder.submissions.unpack import class_folder

    course = None
    if arguments.assignment or arguments.course.is_file():
        # Any mistake in the file is an error here, because it could hide a due date.
        course = read_course(arguments.course)
    work = work_of(arguments, handed_out=True)
    exercises = arguments.exercises.replace(",", " ").split()
    assigned = [exercise.id for chapter in work.chapters for exercise in chapter.exercises]
    if course:
        refuse_early(course, exercises or assigned, datetime.now(UTC))
    if arguments.assignment:
        exercises = exercises or assigned
    numbers = [chapter.number for chapter in work.chapters]
    chapters = [chapter for chapter in load_chapters() if chapter.number in numbers]
    submissions = arguments.submissions and class_folder(arguments.submissions)
    roster = arguments.roster or work.roster
    return release(chapters, exercises, submissions, arguments.grades, arguments.out, roster=roster)


def refuse_early(course: Course, released: Collection[str], now: datetime) -> None:
    """Raise ValueError if any student may still hand in work for one of these exercises.

    An exercise may belong to several assignments.
    """
    wanted = {name.lower() for name in released}
    for work in course.assignments:
        ids = [exercise.id for chapter in work.chapters for exercise in chapter.exercises]
        both = [name for name in ids if name.lower() in wanted]
        if work.deadline is None or not both:
            continue
        dues = [work.deadline.due, *work.deadline.extensions.values()]
        last = max(dues, key=lambda due: due.astimezone(UTC))
        if now < last.astimezone(UTC):
            raise ValueError(
                f"{work.name} is due {clock(last)}, counting extensions. Release its reference "
                f"later, or name other exercises: {', '.join(both)} must wait"
            )
