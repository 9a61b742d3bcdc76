"""Find out when each student handed in. Times of files are not used, since copying changes them."""

from __future__ import annotations

from datetime import tzinfo
from pathlib import Path

from autograder.course.dates import parse_time
from autograder.course.late import HandedIn
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import read_csv

TIMES = "times.csv"
HEADER = ["student", "submitted"]
EXAMPLE = "2026-10-23 20:15 or 2026-10-23T20:15:00+02:00"


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
