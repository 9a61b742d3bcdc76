"""Check a student's code, and find out which failures come from mistakes in earlier chapters."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from autograder.checks.runner import GraderError, run_checks
from autograder.checks.verdict import Verdict, with_needs
from autograder.diagnosis.earlier_chapters import (
    below_and_not_given,
    explained_on_given,
    mark_inherited,
    run_on_given,
    suspects,
    with_given,
)
from autograder.manifest import Chapter, Exercise
from autograder.scores import result_of, results_of
from autograder.student.chapter_results import ChapterResults
from autograder.student.screen import ProgressBar, print_report
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


def report_on(
    chapter: Chapter,
    exercise: Exercise | None,
    folders: list[Path],
    given: list[Chapter],
    run: Callable[..., list[Verdict]],
    progress: ProgressBar,
) -> ChapterResults:
    """Run the checks of a chapter, or of one exercise and its prerequisites, on a student's code.

    A check that fails only because of a mistake in an earlier chapter is reported as inherited.
    """
    progress.title = f"chapter {chapter.number}"
    wanted = with_needs(chapter, [exercise.id] if exercise else None)
    below = below_and_not_given(chapter, given)
    first = run(chapter, folders, exercises=wanted, on_verdict=progress.show)
    try:
        again = run_on_given(chapter, first, folders, below, partial(run, exercises=wanted))
    except GraderError:  # use the first run alone
        again = []
    verdicts = explained_on_given(mark_inherited(first, again), again)
    results, better = (
        [result for result in results_of(chapter, outcome) if result.exercise.id in wanted]
        for outcome in (verdicts, again)
    )
    doubtful = [] if again else suspects(first, folders, below, run)
    return ChapterResults(chapter, results, better if again else [], doubtful)
