"""Find out when students handed in, and how late that is with the extensions of the course file.

Times of files are not used, since copying changes them.
"""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, tzinfo
from pathlib import Path
from typing import Any

from autograder.course.dates import parse_time
from autograder.course.late import HandedIn, late_of
from autograder.course.model import Deadline
from autograder.course.points import points_of
from autograder.manifest import Chapter
from autograder.reports.report import Late
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.csv_rows import read_csv
from autograder.submissions.names import Names, UnknownNameError, some
from autograder.submissions.roster import read_roster

TIMES = "times.csv"
HEADER = ["student", "submitted"]
EXAMPLE = "2026-10-23 20:15 or 2026-10-23T20:15:00+02:00"


def lateness(
    deadline: Deadline, chapters: list[Chapter], folder: Path, people: ClassList
) -> tuple[dict[str, Late], list[str]]:
    """Compute how late each report's submission is, with notes for the instructor."""
    said, notes = times_of(folder, people, deadline.due.tzinfo or UTC)
    granted, more_notes = _extensions(deadline, people)
    notes += more_notes
    points = points_of(chapters)
    reports = [submission.student for submission in people.submissions]
    late = {
        report: late_of(deadline, granted.get(report, []), said.get(report), points)
        for report in reports
    }
    add = f"To add times, write {folder / TIMES}."
    if unknown := [report for report in reports if report not in said]:
        notes.append(
            f"The submission time is unknown for {len(unknown)} of {len(reports)} students, who "
            f"therefore get no penalty: {some(unknown)}. {add}"
        )
    if unclear := [report for report, at in said.items() if at.late and at.at is None]:
        notes.append(
            f"Late by an unknown amount of time, and therefore without a penalty: {len(unclear)} "
            f"({some(unclear)}). {add}"
        )
    if days := [each for each in late.values() if each.days]:
        lose = sum(each.deduction > 0.0 for each in days)
        some_of = f"{lose or 'none'} of them {'get' if lose > 1 else 'gets'} a"
        notes.append(
            f"{len(days)} students were late, and {some_of} penalty."
            if len(days) > 1
            else f"1 student was late, and gets {'a' if lose else 'no'} penalty."
        )
    return late, notes


def _extensions(
    deadline: Deadline, people: ClassList
) -> tuple[dict[str, list[datetime]], list[str]]:
    """Find out which reports the extensions in the course file apply to."""
    granted: dict[str, list[datetime]] = {}
    of_member: dict[Member, tuple[str, datetime]] = {}
    notes: list[str] = []
    for name, due in deadline.extensions.items():
        about = f"Extension of {name!r} in the course file:"
        try:
            members = people.members_of(name)
        except ValueError as error:
            if people.has_roster or not isinstance(error, UnknownNameError):
                raise ValueError(f"{about} {error}") from error
            notes.append(f"{about} {error}")
            continue
        for member in members:
            before, time = of_member.setdefault(member, (name, due))
            if time != due:
                words = f"{before!r} is the same student and has another date. Give only one"
                raise ValueError(f"{about} {words}")
            granted.setdefault(member.report, []).append(due)
    return granted, notes


def late_on_gradescope(
    deadline: Deadline, chapters: list[Chapter], metadata: dict[str, Any]
) -> Late:
    """Compute how late a submission to Gradescope is, from the metadata of Gradescope."""
    try:
        at: datetime | None = parse_time(metadata["created_at"], deadline.due.tzinfo or UTC)
    except (KeyError, TypeError, ValueError, AttributeError):
        at = None
    users = metadata.get("users")
    users = [user for user in users if isinstance(user, dict)] if isinstance(users, list) else []
    known = Names((name, name, [name]) for name in deadline.extensions)
    found = [known.all_of(str(user.get(key))) for user in users for key in ("name", "email")]
    granted = [deadline.extensions[names[0]] for names in found if len(names) == 1]
    handed_in = HandedIn("Gradescope", at) if at else None
    return late_of(deadline, granted, handed_in, points_of(chapters))


def for_gradescope(deadline: Deadline, roster: Path | None) -> Deadline:
    """Return a deadline whose extensions have the keys that Gradescope knows: names and emails."""
    if roster is None or not deadline.extensions:
        return deadline
    students = read_roster(roster)
    names = Names((one, f"{one.name} in line {one.line}", one.names) for one in students)
    extensions: dict[str, datetime] = {}
    for name, due in deadline.extensions.items():
        about = f"Extension of {name!r} in the course file:"
        found = names.all_of(name)
        if len(found) != 1:
            raise ValueError(f"{about} {names.problem(name, found)}")
        (student,) = found
        is_alone = names.all_of(student.name) == [student]
        keys = [key for key in (student.email, student.name if is_alone else "") if key]
        if not keys:
            raise ValueError(
                f"{about} Gradescope tells students of one name apart by email only. Add one to "
                f"{roster}, line {student.line}"
            )
        if any(extensions.setdefault(key, due) != due for key in keys):
            raise ValueError(f"{about} {student.name} has two dates")
    return replace(deadline, extensions=extensions)


def times_of(
    folder: Path, people: ClassList, zone: tzinfo
) -> tuple[dict[str, HandedIn], list[str]]:
    """Find out when each report's submission was handed in, with notes on rows without effect.

    Unknown times are left out, times.csv takes precedence, and times without a time zone are in
    ``zone``. A wrong line of times.csv is a ValueError.
    """
    known: dict[str, HandedIn] = {}
    for submission in people.submissions:
        if submission.export and submission.export.platform == "canvas":
            # Canvas marks late submissions in the file name, but does not say how late they are.
            known[submission.student] = HandedIn("Canvas", late=submission.late)
        if (upload := submission.upload) and upload.at:
            at = upload.at if upload.at.tzinfo else upload.at.replace(tzinfo=zone, fold=1)
            known[submission.student] = HandedIn(upload.source, at)
    written, notes = _of_instructor(folder / TIMES, people, zone)
    return known | written, notes


def _of_instructor(
    path: Path, people: ClassList, zone: tzinfo
) -> tuple[dict[str, HandedIn], list[str]]:
    """Read the times in times.csv, the file of the instructor."""
    if not path.exists():
        return {}, []
    table = read_csv(path)
    table.require(HEADER)
    found: dict[str, HandedIn] = {}
    unused = []
    for line, (name, text) in table.rows():
        try:
            report = people.report_of(name)
        except ValueError as error:
            raise table.mistake(line, error) from error
        try:
            at = parse_time(text, zone)
        except ValueError as error:
            words = f"a time looks like {EXAMPLE}, got {text!r}"
            raise table.mistake(line, words) from error
        if not report:
            unused.append(name)
        elif report in found:
            raise table.mistake(line, f"a second time for {report!r}. Give only one")
        else:
            found[report] = HandedIn(TIMES, at)
    notes = [f"{path}: {', '.join(unused)} handed in nothing, so the time is not used."]
    return found, notes if unused else []
