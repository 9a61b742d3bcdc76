"""Keep what a graded class leaves: a file of results a student, and all that is made from them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from autograder.manifest import Chapter
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradebook import write_gradebook
from autograder.reports.gradescope import write_gradescope
from autograder.reports.texts import Report, replace_file
from autograder.submissions.find import file_name

NUMBER = (int, float)
SCORE = (int, float, type(None))
# The form of a report and its parts: each key with the types that its value may have. Reports
# may have other keys.
REPORT = {
    "student": str,
    "status": str,
    "seed": str,
    "isolation": str,
    "score": SCORE,
    "score_on_given": SCORE,
    "points": NUMBER,
    "by_hand": SCORE,
    "waiting": NUMBER,
    "earlier": list,
    "notes": list,
    "exercises": list,
}
EXERCISE = {
    "chapter": int,
    "id": str,
    "title": str,
    "kind": str,
    "points": NUMBER,
    "score": SCORE,
    "score_on_given": SCORE,
    "status": str,
    "comment": str,
    "checks": list,
}
CHECK = {
    "name": str,
    "status": str,
    "message": dict,
    "weight": NUMBER,
    "hidden": bool,
    "robust": bool,
}
REPORT_STATES = {"graded", "error, retry"}
CHECK_STATES = {"passed", "failed", "blocked", "inherited", "error"}
EXERCISE_STATES = CHECK_STATES | {"waiting", "marked"}


def write_result(out: Path, report: Report) -> Path:
    """Write results/<student>.json, moved into place whole, and return its path."""
    path = out / "results" / f"{file_name(report['student'])}.json"
    text = json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False)
    replace_file(path, text + "\n")
    return path


def read_result(path: Path) -> Report | None:
    """Return the report in a file; None where it is missing, cut off or of another form."""
    try:
        report = json.loads(path.read_text(encoding="utf-8"), parse_constant=_refuse)
    except (OSError, ValueError, RecursionError):
        return None
    return report if _is_report(report) else None


def write_student(out: Path, report: Report) -> None:
    """Write everything about one student; the results last, by which it counts as complete."""
    write_feedback(out, report)
    write_gradescope(out, report)
    write_result(out, report)


def write_class(out: Path, chapters: list[Chapter], reports: Sequence[Report]) -> list[Path]:
    """Write what is made of all reports, and return the places to look at."""
    index = write_index(out, chapters, reports)
    gradebook = write_gradebook(out, chapters, reports)
    return [index, gradebook, *(out / name for name in ("feedback", "gradescope", "results"))]


def _is_report(value: Any) -> bool:
    return (
        _has(value, REPORT, REPORT_STATES)
        and all(isinstance(note, str) for note in value["notes"])
        and all(_is_exercise(exercise) for exercise in value["exercises"])
    )


def _is_exercise(value: Any) -> bool:
    return _has(value, EXERCISE, EXERCISE_STATES) and all(
        _has(check, CHECK, CHECK_STATES) for check in value["checks"]
    )


def _has(value: Any, form: dict[str, Any], states: set[str]) -> bool:
    return (
        isinstance(value, dict)
        and all(key in value and isinstance(value[key], kind) for key, kind in form.items())
        and value["status"] in states
    )


def _refuse(constant: str) -> float:
    raise ValueError(f"{constant} is no number of points")
