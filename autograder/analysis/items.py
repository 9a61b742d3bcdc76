"""Compute how well a class did on each exercise and on each of its checks.

The page class.html shows the scores that students have with the reference solution in place of
their earlier chapters. Otherwise a single mistake in chapter 2 would lower the scores in every
chapter that uses vectors.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import fmean
from typing import Literal

from autograder.analysis.discrimination import Discrimination, discrimination
from autograder.checks.verdict import Verdict
from autograder.manifest import Chapter, Exercise
from autograder.message import Kind
from autograder.reports.report import Cause, StudentReport
from autograder.reports.texts import check_title
from autograder.scores import Result

State = Literal["passed", "failed", "not written", "blocked", "inherited", "error"]
STATES: tuple[State, ...] = ("passed", "failed", "not written", "blocked", "inherited", "error")
HIDDEN = "a hidden check"
MOST_MISSED = 5
BINS = 10


@dataclass(frozen=True)
class CheckItem:
    """The results of a whole class on one check of an exercise."""

    name: str
    robust: bool
    hidden: bool
    states: Counter[State]  # the number of students in each state


@dataclass(frozen=True)
class ExerciseItem:
    """The results of a whole class on one exercise.

    A student has no score if grading failed, or while a written answer waits to be marked.
    """

    exercise: Exercise
    counted: int  # students who have a score
    passed: int  # students who pass every check
    mean: float | None  # the average of the points, or None if nobody has a score
    full: int  # students with all points on given chapters
    part: int  # those with some of them
    none: int  # those with none of them
    mean_on_given: float | None  # the average on given chapters, as a fraction of the points
    discrimination: Discrimination
    checks: list[CheckItem]
    first_lost: str  # the check that most students fail

    @property
    def share(self) -> float | None:
        """The fraction of those with a score who pass, or None if there is none or no check."""
        if self.exercise.kind == "written" or not self.counted:
            return None
        return self.passed / self.counted


def items_of(chapter: Chapter, reports: Sequence[StudentReport]) -> list[ExerciseItem]:
    """Compute how well a class did on each exercise of a chapter, in the order of the exercises."""
    return [_item(exercise, reports) for exercise in chapter.exercises]


def _item(exercise: Exercise, reports: Sequence[StudentReport]) -> ExerciseItem:
    results: list[Result] = []
    given: list[float] = []
    rest: list[float] = []
    for report in reports:
        for result in report.results:
            if result.exercise.id == exercise.id:
                results.append(result)
                if result.score_on_given is not None and report.score_on_given is not None:
                    given.append(result.score_on_given)
                    by_checks = 0.0 if exercise.kind == "written" else result.score_on_given
                    rest.append(round(report.score_on_given - by_checks, 2))
    scores = [result.score for result in results if result.score is not None]
    on_given = [r.score_on_given for r in results if r.score_on_given is not None]
    full = sum(score >= exercise.points for score in on_given)
    none = sum(score <= 0.0 for score in on_given)
    lost = Counter(
        HIDDEN if check.hidden else check_title(check.name)
        for result in results
        for check in result.checks
        if check.status in ("failed", "blocked", "inherited")
    )
    return ExerciseItem(
        exercise,
        counted=len(scores),
        passed=sum(result.status == "passed" for result in results),
        mean=round(fmean(scores), 2) if scores else None,
        full=full,
        part=len(on_given) - full - none,
        none=none,
        mean_on_given=fmean(on_given) / exercise.points if on_given else None,
        discrimination=discrimination(given, rest),
        checks=_checks(results),
        first_lost=lost.most_common(1)[0][0] if lost else "",
    )


def _checks(results: Sequence[Result]) -> list[CheckItem]:
    """Count how many students passed or failed each check, beginning with the physics checks."""
    items: dict[tuple[str, bool], CheckItem] = {}
    for result in results:
        for check in result.checks:
            new = CheckItem(check.name, check.robust, check.hidden, Counter())
            item = items.setdefault((check.name, check.hidden), new)
            item.states[_state(check)] += 1
    return sorted(items.values(), key=lambda item: (item.robust, item.hidden))


def _state(check: Verdict) -> State:
    unwritten = check.message.kind is Kind.UNWRITTEN and check.status in ("failed", "blocked")
    return "not written" if unwritten else check.status


def most_missed(items: Sequence[ExerciseItem]) -> list[ExerciseItem]:
    """Return up to five exercises that not everybody passes, lowest pass rate first."""
    missed = [item for item in items if item.share is not None and item.share < 1]
    order = sorted(missed, key=lambda i: (i.share or 0.0, (i.mean or 0.0) / i.exercise.points))
    return order[:MOST_MISSED]


def causes_in(reports: Sequence[StudentReport]) -> list[tuple[Cause, int]]:
    """List the exercises of earlier assignments that students have to fix first.

    Each is returned with the number of students whose graded exercises it blocks, most first.
    """
    found: dict[str, Cause] = {}
    counts: Counter[str] = Counter()
    for cause in (cause for report in reports for cause in report.causes):
        if cause.result.status == "failed":
            name = cause.result.exercise.id
            counts[name] += 1
            known = found.setdefault(name, cause)
            blocks = dict.fromkeys([*known.blocks, *cause.blocks])
            found[name] = replace(known, blocks=[*blocks])
    return [(found[name], count) for name, count in counts.most_common()]


def histogram(reports: Sequence[StudentReport]) -> list[tuple[int, int, int]]:
    """Count how many students of a class score 0 to 10 percent, 10 to 20 percent, and so on.

    Full marks go into the last bin, and so do higher scores due to extra credit. Students without a
    score are not counted.

    Returns:
        For each bin its limits in percent, and the number of students.
    """
    counts: Counter[int] = Counter()
    for report in reports:
        most = report.points or report.extra  # an assignment's checks may give only extra credit
        if report.score is not None and most:
            counts[min(int(round(BINS * report.score / most, 6)), BINS - 1)] += 1
    step = 100 // BINS
    return [(step * i, step * (i + 1), counts[i]) for i in range(BINS)]
