"""Save the grades of a class, and write the files that show them to students and instructors."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import msgspec

from autograder.manifest import Chapter
from autograder.records import to_json
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradebook import write_gradebook
from autograder.reports.gradescope import write_gradescope
from autograder.reports.report import StudentReport
from autograder.reports.texts import replace_file
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import file_name


def write_result(out: Path, report: StudentReport) -> Path:
    """Save a student's report as results/<student>.json, and return the path of the file."""
    path = out / "results" / f"{file_name(report.student)}.json"
    text = json.dumps(to_json(report), indent=1, ensure_ascii=False, allow_nan=False)
    replace_file(path, text + "\n")
    return path


def read_result(path: Path) -> StudentReport | None:
    """Read a student's report from a JSON file, or return None if the file has no valid report."""
    try:
        return _read(path)
    except (OSError, ValueError, RecursionError):
        return None


def read_results(out: Path) -> list[StudentReport]:
    """Read the reports on all students of a graded class, sorted by student.

    Raises:
        ValueError: There are no reports, or one of them cannot be read.
    """
    reports = []
    for path in (out / "results").glob("*.json"):
        try:
            reports.append(_read(path))
        except (OSError, ValueError, RecursionError) as error:
            again = f"Grade the class again into {str(out)!r}"
            raise ValueError(f"{path} cannot be read ({error}). {again}") from error
    if not reports:
        raise ValueError(f"{str(out)!r} has no results. It must be a folder of make grade OUT=...")
    return sorted(reports, key=lambda report: report.student)


def write_student(out: Path, report: StudentReport) -> None:
    """Write a student's page, Gradescope file and, when these are complete, the report."""
    write_feedback(out, report)
    write_gradescope(out, report)
    write_result(out, report)


def write_class(
    out: Path, chapters: list[Chapter], reports: Sequence[StudentReport], people: ClassList
) -> list[Path]:
    """Write an overview and a gradebook of the class, and return what to open of all files."""
    index = write_index(out, chapters, reports, people)
    gradebook = write_gradebook(out, chapters, reports, people)
    return [index, gradebook, *(out / name for name in ("feedback", "gradescope", "results"))]


def _read(path: Path) -> StudentReport:
    """Read a report. The error for a value that is missing or wrong names its key."""
    text = path.read_text(encoding="utf-8")
    return msgspec.convert(json.loads(text, parse_constant=_refuse), StudentReport)


def _refuse(constant: str) -> float:
    raise ValueError(f"{constant} is not a number of points")
