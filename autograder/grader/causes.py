"""Find exercises of earlier assignments that fail, although the graded exercises build on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from autograder.checks.verdict import Verdict, needs_of
from autograder.manifest import Chapter
from autograder.reports.report import Cause
from autograder.scores import Result, results_of


def causes_of(
    whole: Chapter,
    graded: Sequence[Result],
    verdicts: Sequence[Verdict],
    assignments: Mapping[str, str],
) -> list[Cause]:
    """List the exercises that are not graded, but block graded ones because they fail.

    ``verdicts`` are of all exercises of the chapter. ``assignments`` has the name of the earlier
    assignment that each exercise belongs to.
    """
    ids = {result.exercise.id for result in graded}
    others = replace(whole, exercises=[e for e in whole.exercises if e.id not in ids])
    blocked = [result.exercise.id for result in graded if result.status == "blocked"]
    causes = []
    for result in results_of(others, verdicts):
        exercise = result.exercise
        blocks = [name for name in blocked if exercise.id in needs_of(whole, name)]
        if blocks and not result.works and result.status in ("failed", "blocked", "inherited"):
            shown = replace(result, checks=result.physics)
            causes.append(Cause(shown, assignments.get(exercise.id, ""), blocks))
    return causes
