"""Find out which exercises an instructor's command is about: an assignment, or whole chapters."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from autograder.course.model import Work
from autograder.manifest import select_chapters, split_given

DEFAULT = Path("course.toml")
NOT_WITH_ASSIGNMENT = ("chapters", "given", "checks")  # these come from the course file


def work_of(arguments: argparse.Namespace, *, handed_out: bool = False) -> Work:
    """Return the assignment or the chapters that an instructor has named on the command line.

    No chapters means all of them without the given ones. If the work is ``handed_out``, as by `make
    handout`, the instructor must name chapters, and given ones may be among them.

    Raises:
        ValueError: The options contradict each other, or the course file has a mistake.
    """
    if arguments.assignment is not None:
        for option in NOT_WITH_ASSIGNMENT:
            if value := getattr(arguments, option, None):
                raise ValueError(
                    f"with an assignment, {arguments.course} names the {option}: leave out {value}"
                )
        return _assigned(arguments.course, arguments.assignment)
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


def _assigned(path: Path, name: str) -> Work:
    from autograder.course.reading import read_course  # which needs a package that students lack

    works = {work.name: work for work in read_course(path).assignments}
    if name not in works:
        raise ValueError(f"{path} has no assignment {name!r}. It has {', '.join(works)}")
    return works[name]
