"""Convert the results of checks to data for the page, with the same texts as in `make check`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from autograder.answers import questions_of
from autograder.manifest import Chapter, Exercise
from autograder.scores import result_of, total
from autograder.student.chapter_results import ChapterResults
from autograder.student.failure import Failure, failure_of
from autograder.student.finish import end_of
from autograder.student.screen import (
    changed_notes,
    extra_notes,
    first_open,
    inherited_notes,
    passed_words,
    passing,
    states_of,
)


def report_to_page(
    report: ChapterResults, exercise: Exercise | None, engine: list[Path], given: list[Chapter]
) -> dict[str, Any]:
    """Convert a report to data for the page, which shows it as `make check` prints it."""
    chapter, reports = report.chapter, [report]
    first = first_open(reports, exercise)
    failure = failure_of(*first, engine) if first else None
    changed = changed_notes(chapter, engine)
    summary = ""
    if first is None:
        summary = passed_words(reports, exercise, engine, given, changed=bool(changed))
    notes = [*extra_notes(chapter, engine), *inherited_notes(report, exercise, engine), *changed]
    earned, points = total(report.results)
    return {
        "chapter": chapter.name,
        "passed": first is None and not changed,
        "summary": summary,
        "earned": earned,
        "points": points,
        "results": _results(report, engine),
        "failure": failure_to_page(failure) if failure else None,
        "notes": notes,
        "finish": [words for words, _ in end_of(reports, exercise, engine, given)],
    }


def report_of_written(chapter: Chapter, exercise: Exercise, engine: list[Path]) -> dict[str, Any]:
    """Build the page's report on a written exercise, which has no automatic checks."""
    report = ChapterResults(chapter, [result_of(exercise, [])], [], [])
    question = next(one for one in questions_of(chapter, engine) if one.exercise == exercise)
    told = report_to_page(report, exercise, engine, [])
    return told | {"summary": "", "notes": question.problems, "finish": []}


def _results(report: ChapterResults, engine: list[Path]) -> list[dict[str, Any]]:
    return [
        {
            "id": result.exercise.id,
            "title": result.exercise.title,
            "state": state,
            "physics": passing(result.physics),
            "robust": passing(result.robust),
            "score": result.score,
            "points": result.exercise.points,
            "checks": [
                {"name": check.name, "status": check.status, "robust": check.robust}
                for check in result.checks
            ],
        }
        for result, state in zip(report.results, states_of(report, engine), strict=True)
    ]


def failure_to_page(failure: Failure) -> dict[str, Any]:
    """Convert a failed check to data for the page. A "line" of 0 means that there is none."""
    file, _, line = failure.place.removeprefix("chapters/").partition(":")
    return {
        "heading": failure.heading,
        "rows": [list(row) for row in failure.diagnosis],
        "printed": failure.printed,
        "steps": failure.steps,
        "file": file,
        "line": int(line or 0),
        "nudge": failure.hints,
    }
