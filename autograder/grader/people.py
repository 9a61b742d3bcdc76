"""Find out who is in a class for a command, and choose the names for the reports."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path

from autograder.reports.report import StudentReport
from autograder.reports.results import read_result
from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.codes import CODE, key_path, refuse_names, with_codes


def people_of(folder: Path, out: Path, roster: Path | None, *, anonymous: bool) -> ClassList:
    """Find the students of a class and what they have handed in.

    If the class is anonymous, the reports in ``out`` use codes instead of names. The names of
    reports that are there already are those of students who have handed in before.

    Raises:
        ValueError: The submissions, the roster or the key file contain a mistake, or ``out``
            contains reports with names although the class is anonymous.
        OSError: A file cannot be read or written.
    """
    people = read_class(folder, roster)
    if anonymous:
        refuse_names(out)
        people = with_codes(people, key_path(roster, out))
    earlier = [*out.glob("results/*.json"), *out.glob("earlier/results/*.json")]
    found = {path: read_result(path) for path in earlier}
    notes = [*people.notes]
    if unread := sum(not found[path] and path.parent == out / "results" for path in found):
        other = "are damaged or of another version, so these submissions are graded again"
        notes.append(f"Reports in {out} that {other}: {unread}.")
    gone = frozenset(report.student for report in found.values() if report)
    return replace(people, notes=notes, gone=gone)


def folder_with_names(out: Path, folder: Path, *, anonymous: bool) -> Path:
    """Return the place for files that contain students' names, such as those for Canvas.

    If the class is anonymous, it is outside ``out``, so that ``out`` can be shared.

    Raises:
        ValueError: It would be in the folder of the class, and count as a student.
    """
    if not anonymous:
        return out
    named = out.resolve().with_name(f"{out.resolve().name}-named")
    if named.is_relative_to(folder.resolve()):
        raise ValueError(
            f"--out must not be in the folder of an anonymous class, since the names would be "
            f"beside it, got {str(out)!r}"
        )
    return named


def differences(people: ClassList, reports: Sequence[StudentReport]) -> list[str]:
    """List students who handed in nothing, or nothing to grade, or who are not on the roster.

    For example, if a submission is named "Ann Le" and the roster lists "Ann Lee", suggest how to
    rename the submission.
    """
    nothing: dict[str, list[str]] = {}
    for report in reports:
        if report.nothing:
            nothing.setdefault(report.nothing, []).append(report.student)
    changed = [f"{report.student} {exercise}" for report in reports for exercise in report.changed]
    lines = [
        f"{title}: {len(names)} ({'; '.join(names)})."
        for title, names in (
            ("Nothing handed in", people.missing),
            ("Not on the roster", people.unmatched),
            ("Answers that have changed since they were marked", changed),
        )
        if names
    ]
    if nothing:
        lines.append(f"Handed in, nothing to grade: {sum(map(len, nothing.values()))}.")
        lines += [f"  {'; '.join(names)}: {why}" for why, names in nothing.items()]
    # We compare only names, because two codes may be similar by chance.
    absent = {
        m.shown.lower(): m
        for m in people.members
        if m.student and not m.submission and m.shown == m.student.name
    }
    for m in people.members:
        if people.has_roster and m.submission and not m.student and not CODE.fullmatch(m.shown):
            for name in get_close_matches(m.shown.lower(), absent, 1):
                if student := absent[name].student:
                    lines.append(
                        f"If {m.shown} is {student.name}, rename the submission to {student.id}."
                    )
    return lines
