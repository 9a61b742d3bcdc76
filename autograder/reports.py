"""Write what a graded class leaves: a JSON file a student, and the gradebook."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

from autograder.manifest import Chapter
from autograder.scores import Result, total


def write_result(out: Path, student: str, seed: str, isolation: str, results: list[Result]) -> None:
    """Write results/<student>.json, moved into place whole."""
    score, points = total(results)
    report = {
        "student": student,
        "seed": seed,
        "isolation": isolation,
        "status": overall_status(results),
        "score": score,
        "points": points,
        "exercises": [_exercise(result) for result in results],
    }
    text = json.dumps(report, indent=1, ensure_ascii=False) + "\n"
    _replace(out / "results" / f"{student}.json", text)


def write_gradebook(out: Path, chapters: list[Chapter], grades: dict[str, list[Result]]) -> Path:
    """Write gradebook.csv: a row a student, a column an exercise, first the points possible.

    A cell without a number is not graded: a written answer, or a fault of the grader.
    """
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    possible = sum(exercise.points for exercise in exercises if exercise.kind != "written")
    rows: list[list[str]] = [
        ["student", "status", "score", *(exercise.id for exercise in exercises)],
        ["points possible", "", str(possible), *(str(exercise.points) for exercise in exercises)],
    ]
    for student, results in grades.items():
        scores = [total(results)[0], *(result.score for result in results)]
        cells = ["" if score is None else f"{score:g}" for score in scores]
        rows.append([_harmless(student), overall_status(results), *cells])
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    _replace(out / "gradebook.csv", text.getvalue())
    return out / "gradebook.csv"


def overall_status(results: list[Result]) -> str:
    """Return "graded", or "error, retry" where the grader itself failed on an exercise."""
    return "error, retry" if any(result.status == "error" for result in results) else "graded"


def _exercise(result: Result) -> dict[str, Any]:
    exercise = result.exercise
    return {
        "id": exercise.id,
        "title": exercise.title,
        "points": exercise.points,
        "score": result.score,
        "status": result.status,
        "checks": [
            {"name": check.name, "status": check.status, "message": check.message}
            for check in result.checks
        ],
    }


def _harmless(text: str) -> str:
    """Keep a spreadsheet from taking a name for a formula."""
    return "'" + text if text.startswith(("=", "+", "-", "@", "\t", "\r")) else text


def _replace(path: Path, text: str) -> None:
    """Write a file beside its place and move it there, so that it is never half written."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".tmp")
    # What is no character, in a student's message or name, is written as an escape.
    temporary.write_bytes(text.encode("utf-8", errors="backslashreplace"))
    temporary.replace(path)
