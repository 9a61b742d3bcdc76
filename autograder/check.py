"""Check chapters for a student, and tell failures of their own from inherited ones."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from autograder.given import (
    below_and_not_given,
    mark_inherited,
    run_on_given,
    suspects,
    told_on_given,
    with_given,
)
from autograder.manifest import Chapter, Exercise
from autograder.runner import GraderError, run_checks, with_needs
from autograder.scores import results_of
from autograder.screen import ProgressBar, Report, print_report


def check(
    chapters: list[Chapter],
    exercise: Exercise | None,
    engine: list[Path],
    seed: str,
    given: list[Chapter],
    *,
    only: bool = False,
) -> bool:
    """Check the chapters, or one exercise and what it needs; print it all; return success.

    With ``only``, what an exercise needs is checked, but neither shown nor asked for success. The
    ``given`` chapters are the reference's. A check that an earlier chapter fails, and not this
    one, is shown as inherited.
    """
    reports = []
    with with_given(given, engine) as folders, ProgressBar() as progress:
        for chapter in chapters:
            progress.title = f"chapter {chapter.number}"
            wanted = with_needs(chapter, [exercise.id] if exercise else None)
            told = [exercise.id] if exercise and only else wanted
            below = below_and_not_given(chapter, given)
            first = run_checks(
                chapter, folders, seed=seed, exercises=wanted, on_verdict=progress.show
            )
            run = partial(run_checks, seed=seed)
            try:
                again = run_on_given(chapter, first, folders, below, partial(run, exercises=wanted))
            except GraderError:  # the first run stands
                again = []
            verdicts = told_on_given(mark_inherited(first, again), again)
            results, better = (
                [result for result in results_of(chapter, outcome) if result.exercise.id in told]
                for outcome in (verdicts, again)
            )
            doubtful = [] if again else suspects(first, folders, below, run)
            reports.append(Report(chapter, results, better if again else [], doubtful))
    return print_report(progress.console, reports, exercise, engine, given)
