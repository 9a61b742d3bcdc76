"""Load the people of a class: its roster, the codes of an anonymous class, and its marks."""

from __future__ import annotations

from pathlib import Path

from autograder.manifest import Chapter
from autograder.reports.marks import Marks, read_marks, renamed
from autograder.submissions.class_list import ClassList, match
from autograder.submissions.codes import key_path, refuse_names, with_codes
from autograder.submissions.find import Submission
from autograder.submissions.roster import read_roster


def people_of(
    submissions: list[Submission], out: Path, roster: Path | None, *, anonymous: bool
) -> ClassList:
    """Return the class, with the names that its reports show.

    Raises:
        ValueError: The roster or the key contains a mistake, or ``out`` has reports with names.
        OSError: The roster or the key cannot be read or written.
    """
    people = match(submissions, read_roster(roster) if roster else None, roster)
    if anonymous:
        refuse_names(out)
        people = with_codes(people, key_path(roster, out))
    return people


def marks_of(people: ClassList, path: Path, chapters: list[Chapter]) -> Marks:
    """Return the marks of a class. Its marks.csv may use any name of a student.

    Raises:
        ValueError: A line is not valid, or a student has two marks for an exercise.
    """
    return renamed(read_marks(path, chapters, people.names), people.names, path)


def folder_with_names(out: Path, *, anonymous: bool) -> Path:
    """Return the folder for the files that need names. For an anonymous class, it is beside out."""
    return out.resolve().with_name(f"{out.resolve().name}-named") if anonymous else out


def differences(people: ClassList) -> list[str]:
    """Return sentences that describe where the roster and the submissions do not match."""
    return [
        f"{title}: {len(names)} ({'; '.join(names)})."
        for title, names in (
            ("Nothing handed in", people.missing),
            ("Not in the roster", people.unmatched),
        )
        if names
    ]
