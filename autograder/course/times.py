"""Find out when each student handed in. Times of files are not used, since copying changes them."""

from __future__ import annotations

from datetime import tzinfo
from pathlib import Path

from autograder.course.dates import parse_time
from autograder.course.late import HandedIn
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import Mistakes, read_csv

TIMES = "times.csv"
HEADER = ["student", "submitted"]
EXAMPLE = "2026-10-23 20:15 or 2026-10-23T20:15:00+02:00"


def times_of(
    folder: Path, people: ClassList, zone: tzinfo
) -> tuple[dict[str, HandedIn], list[str]]:
    """Find out when each report's submission was handed in, with notes on rows without effect.

    Unknown times are left out, times.csv takes precedence, and times without a time zone are in
    ``zone``. ValueError lists the wrong lines of times.csv.
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
    if table.header != HEADER:
        raise ValueError(
            f"{path}, line 1: the header must be student,submitted, got {table.first_line!r}"
        )
    mistakes = Mistakes(path)
    found: dict[str, HandedIn] = {}
    unused = []
    for line, _, (name, text) in table.rows("cell", mistakes):
        try:
            report = people.report_of(name)
        except ValueError as error:
            mistakes.add(line, str(error))
            continue
        try:
            at = parse_time(text, zone)
        except ValueError:
            mistakes.add(line, f"a time looks like {EXAMPLE}, got {text!r}")
            continue
        if not report:
            unused.append(name)
        elif report in found:
            mistakes.add(line, f"a second time for {report!r}. Give only one")
        else:
            found[report] = HandedIn(TIMES, at)
    mistakes.raise_any()
    notes = [f"{path}: {', '.join(unused)} handed in nothing, so the time is not used."]
    return found, notes if unused else []
