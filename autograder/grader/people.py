"""Find out who is in a class for a command, and who of them cannot be graded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path

from autograder.reports.report import StudentReport
from autograder.reports.results import read_result
from autograder.submissions.class_list import ClassList, read_class


def people_of(folder: Path, out: Path, roster: Path | None) -> ClassList:
    """Find the students of a class, what they have handed in, and who has reports in ``out``."""
    earlier = [*out.glob("results/*.json"), *out.glob("earlier/results/*.json")]
    people = read_class(folder, roster)
    found = {path: read_result(path) for path in earlier}
    notes = [*people.notes]
    if unread := sum(not found[path] and path.parent == out / "results" for path in found):
        other = "are damaged or of another version, so these submissions are graded again"
        notes.append(f"Reports in {out} that {other}: {unread}.")
    gone = frozenset(report.student for report in found.values() if report)
    return replace(people, notes=notes, gone=gone)


def differences(people: ClassList, reports: Sequence[StudentReport]) -> list[str]:
    """List students who handed in nothing, or nothing to grade, or who are not on the roster."""
    changed = [f"{report.student} {exercise}" for report in reports for exercise in report.changed]
    lines = [
        f"{title}: {len(names)} ({'; '.join(names)})."
        for title, names in (
            ("Nothing handed in", people.absent),
            ("Not on the roster", people.unmatched),
            ("Answers that have changed since they were marked", changed),
        )
        if names
    ]
    nothing: dict[str, list[str]] = {}
    for report in reports:
        if report.nothing:
            nothing.setdefault(report.nothing, []).append(report.student)
    if nothing:
        lines.append(f"Handed in, nothing to grade: {sum(map(len, nothing.values()))}.")
        lines += [f"  {'; '.join(names)}: {why}" for why, names in nothing.items()]
    absent = {m.shown.lower(): m.student for m in people.members if not m.submission and m.student}
    for shown in people.unmatched:
        for name in get_close_matches(shown.lower(), absent, 1):
            student = absent[name]
            lines.append(f"If {shown} is {student.name}, rename the submission to {student.id}.")
    return lines
