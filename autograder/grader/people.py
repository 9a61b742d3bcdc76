"""Match the submissions and marks of a class with its roster, and choose the names for reports."""

from __future__ import annotations

from difflib import get_close_matches
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
    """Match the submissions with the students on the roster, and choose the names used in reports.

    If the class is anonymous, the reports use codes instead of names.

    Raises:
        ValueError: The roster or the key file contains a mistake, or ``out`` contains reports with
            names although the class is anonymous.
        OSError: The roster or the key file cannot be read or written.
    """
    people = match(submissions, read_roster(roster) if roster else None, roster)
    if anonymous:
        refuse_names(out)
        people = with_codes(people, key_path(roster, out))
    return people


def marks_of(people: ClassList, path: Path, chapters: list[Chapter]) -> Marks:
    """Read the points and comments that an instructor gave for students' written answers.

    In marks.csv, a student may be entered under any known name, such as the login or the e-mail
    address.

    Raises:
        ValueError: A line is not valid, or a student has two marks for the same exercise.
    """
    return renamed(read_marks(path, chapters, people.names), people.names, path)


def folder_with_names(out: Path, *, anonymous: bool) -> Path:
    """Return the folder for files that contain students' names, such as those for Canvas.

    If the class is anonymous, this folder is outside ``out``, so that ``out`` can be shared.
    """
    return out.resolve().with_name(f"{out.resolve().name}-named") if anonymous else out


def differences(people: ClassList) -> list[str]:
    """List students who handed in nothing, and submissions whose names are not on the roster.

    For example, if a submission is named "Ann Le" and the roster lists "Ann Lee", suggest how to
    rename the submission.
    """
    lines = [
        f"{title}: {len(names)} ({'; '.join(names)})."
        for title, names in (
            ("Nothing handed in", people.missing),
            ("Not on the roster", people.unmatched),
        )
        if names
    ]
    # We compare only names, because two codes may be similar by chance.
    absent = {
        m.shown.lower(): m
        for m in people.members
        if m.student and not m.submission and m.shown == m.student.name
    }
    for m in people.members:
        if people.has_roster and m.submission and not m.student and m.shown == m.folder:
            for name in get_close_matches(m.folder.lower(), absent, 1):
                if student := absent[name].student:
                    lines.append(
                        f"If {m.folder} is {student.name}, rename the submission to {student.id}."
                    )
    return lines
