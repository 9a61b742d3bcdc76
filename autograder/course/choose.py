"""Find out which exercises an instructor's command applies to.

On the command line, the instructor selects either an assignment from the course file or some
chapters.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from autograder.course.model import Work
from autograder.course.reading import read_assignment
from autograder.manifest import select_chapters, split_given

DEFAULT = Path("course.toml")
NOT_WITH_ASSIGNMENT = ("chapters", "given", "checks")  # these come from the course file


def work_of(arguments: argparse.Namespace, *, handed_out: bool = False) -> Work:
    """Return the exercises that an instructor has selected on the command line.

    The instructor selects either an assignment from the course file or some chapters. If
    ``handed_out`` is True, as in `make handout`, the given chapters are added to the selection.
    Otherwise they are removed from it, and an empty selection means all chapters.

    Raises:
        ValueError: The options contradict each other, or the course file contains mistakes that
            matter for the assignment. Its other mistakes are printed.
    """
    if arguments.assignment is not None:
        return _assigned(arguments)
    if arguments.course != DEFAULT:
        raise ValueError("--course needs an assignment too, such as --assignment lab1")
    given = getattr(arguments, "given", "")
    if not handed_out:
        if DEFAULT.exists():
            words = "is not used, because no assignment is named (make: ASSIGNMENT=)"
            print(f"{DEFAULT} {words}", file=sys.stderr)
        complete, chapters = split_given(select_chapters(arguments.chapters), given)
        return Work("", chapters, complete, hidden=getattr(arguments, "checks", None))
    if not arguments.chapters:
        raise ValueError("name the chapters, such as 2-3, or an assignment with --assignment")
    return Work("", select_chapters(arguments.chapters), select_chapters(given) if given else [])


def _assigned(arguments: argparse.Namespace) -> Work:
    for option in NOT_WITH_ASSIGNMENT:
        if value := getattr(arguments, option, None):
            raise ValueError(
                f"with an assignment, {arguments.course} names the {option}: leave out {value}"
            )
    work, note = read_assignment(arguments.course, arguments.assignment)
    if note:
        print(note, file=sys.stderr)
    return work
