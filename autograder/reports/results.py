"""Keep what a graded class leaves: a file of results a student, and all that is made from them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from autograder.manifest import Chapter
from autograder.records import from_json, to_json
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradebook import write_gradebook
from autograder.reports.gradescope import write_gradescope
from autograder.reports.report import StudentReport
from autograder.reports.texts import replace_file
from autograder.submissions.find import file_name


def write_result(out: Path, report: StudentReport) -> Path:
    """Write results/<student>.json, moved into place whole, and return its path."""
    path = out / "results" / f"{file_name(report.student)}.json"
    text = json.dumps(to_json(report), indent=1, ensure_ascii=False, allow_nan=False)
    replace_file(path, text + "\n")
    return path


def read_result(path: Path) -> StudentReport | None:
    """Return the report in a file; None where it is missing, cut off or of another form."""
    try:
        told = json.loads(path.read_text(encoding="utf-8"), parse_constant=_refuse)
        return from_json(StudentReport, told)
    except (OSError, ValueError, RecursionError):
        return None


def write_student(out: Path, report: StudentReport) -> None:
    """Write everything about one student; the results last, by which it counts as complete."""
    write_feedback(out, report)
    write_gradescope(out, report)
    write_result(out, report)


def write_class(out: Path, chapters: list[Chapter], reports: Sequence[StudentReport]) -> list[Path]:
    """Write what is made of all reports, and return the places to look at."""
    index = write_index(out, chapters, reports)
    gradebook = write_gradebook(out, chapters, reports)
    return [index, gradebook, *(out / name for name in ("feedback", "gradescope", "results"))]


def _refuse(constant: str) -> float:
    raise ValueError(f"{constant} is no number of points")
