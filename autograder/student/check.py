"""Check a student's code, and print the results."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from autograder.checks.runner import run_checks
from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import Chapter, Exercise
from autograder.scores import result_of
from autograder.student.chapter_results import ProgressBar, report_on
from autograder.student.screen import print_report
from autograder.student.written import print_written


def check(
    chapters: list[Chapter],
    exercise: Exercise | None,
    engine: list[Path],
    seed: str,
    given: list[Chapter],
    *,
    only: bool = False,
) -> bool:
    """Check a student's code, print the results, and return True if all checks pass.

    With ``exercise``, check only that exercise and its prerequisites. With ``only`` too, report
    only its own physics checks. The reference replaces the student's code in ``given`` chapters.
    A written exercise has no checks, so its question is shown instead.
    """
    if exercise and exercise.kind == "written":
        print_written(ProgressBar().console, chapters[0], exercise, engine)
        return True
    reports = []
    run = partial(run_checks, seed=seed)
    with with_given(given, engine) as folders, ProgressBar() as progress:
        for chapter in chapters:
            report = report_on(chapter, exercise, folders, given, run, progress)
            if exercise and only:
                own, better = (
                    [result_of(exercise, r.physics) for r in results if r.exercise == exercise]
                    for results in (report.results, report.on_reference)
                )
                report = replace(report, results=own, on_reference=better)
            reports.append(report)
    return print_report(progress.console, reports, exercise, engine, given)
