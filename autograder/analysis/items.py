"""Compute how well a class did on each exercise and on each of its checks.

The scores on given chapters are those with our solutions in place of the student's earlier ones.
Otherwise one mistake in chapter 2 would lower the scores in every chapter that uses vectors.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import fmean

from autograder.analysis.discrimination import Discrimination, discrimination
from autograder.checks.verdict import Verdict
from autograder.manifest import Chapter, Exercise
from autograder.message import Kind
from autograder.reports.report import Cause, StudentReport
from autograder.reports.texts import check_title

STATES = ("passed", "failed", "not written", "blocked", "inherited", "error")
HIDDEN = "a hidden check"
MOST_MISSED = 5
BINS = 10


@dataclass(frozen=True)
class ExerciseItem:
    """The results on one exercise. Students without a score yet are not counted."""

    exercise: Exercise
    scores: list[float]
    passed: int  # students who pass every check
    on_given: list[float]  # the scores on given chapters
    discrimination: Discrimination
    checks: list[tuple[Verdict, Counter[str]]]  # with the number of students in each of STATES
    first_lost: str  # the check that most students fail

    @property
    def share(self) -> float | None:
        """The fraction of those with a score who pass, or None if there is none or no check."""
        if self.exercise.kind == "written" or not self.scores:
            return None
        return self.passed / len(self.scores)

    @property
    def mean(self) -> float | None:
        """The average of the points, or None if nobody has a score."""
        return round(fmean(self.scores), 2) if self.scores else None

    @property
    def mean_on_given(self) -> float | None:
        """The average on given chapters, as a fraction of the points."""
        return fmean(self.on_given) / self.exercise.points if self.on_given else None

    @property
    def full_part_none(self) -> tuple[int, int, int]:
        """How many students have all points, some or none on given chapters."""
        full = sum(score >= self.exercise.points for score in self.on_given)
        none = sum(score <= 0.0 for score in self.on_given)
        return full, len(self.on_given) - full - none, none


def items_of(chapter: Chapter, reports: Sequence[StudentReport]) -> list[ExerciseItem]:
    """Compute how well a class did on each exercise of a chapter, in the order of the exercises."""
    return [_item(exercise, reports) for exercise in chapter.exercises]


def _item(exercise: Exercise, reports: Sequence[StudentReport]) -> ExerciseItem:
    pairs = [(r, o) for r in reports for o in r.results if o.exercise.id == exercise.id]
    results = [result for _, result in pairs]
    own: list[float] = []
    rest: list[float] = []
    for report, result in pairs:
        if result.score_on_given is not None and report.score_on_given is not None:
            own.append(result.score_on_given)
            by_checks = 0.0 if exercise.kind == "written" else result.score_on_given
            rest.append(round(report.score_on_given - by_checks, 2))
    states: dict[tuple[str, bool], tuple[Verdict, Counter[str]]] = {}
    lost: Counter[str] = Counter()
    for check in (check for result in results for check in result.checks):
        _, counts = states.setdefault((check.name, check.hidden), (check, Counter()))
        unwritten = check.message.kind is Kind.UNWRITTEN and check.status in ("failed", "blocked")
        counts["not written" if unwritten else check.status] += 1
        if check.status in ("failed", "blocked", "inherited"):
            lost[HIDDEN if check.hidden else check_title(check.name)] += 1
    return ExerciseItem(
        exercise,
        scores=[result.score for result in results if result.score is not None],
        passed=sum(result.status == "passed" for result in results),
        on_given=[r.score_on_given for r in results if r.score_on_given is not None],
        discrimination=discrimination(own, rest),
        checks=sorted(states.values(), key=lambda pair: (pair[0].robust, pair[0].hidden)),
        first_lost=lost.most_common(1)[0][0] if lost else "",
    )


def most_missed(items: Sequence[ExerciseItem]) -> list[ExerciseItem]:
    """Return up to five exercises that not everybody passes, lowest pass rate first."""
    missed = [item for item in items if item.share is not None and item.share < 1]
    order = sorted(missed, key=lambda i: (i.share or 0.0, (i.mean or 0.0) / i.exercise.points))
    return order[:MOST_MISSED]


def causes_in(reports: Sequence[StudentReport]) -> list[tuple[Cause, int]]:
    """List the exercises of earlier assignments to fix first, and how many students they block."""
    found: dict[str, list[Cause]] = {}
    for cause in (cause for report in reports for cause in report.causes):
        if cause.result.status == "failed":
            found.setdefault(cause.result.exercise.id, []).append(cause)
    causes = sorted(found.values(), key=len, reverse=True)
    blocks = [dict.fromkeys(name for one in same for name in one.blocks) for same in causes]
    return [(replace(s[0], blocks=[*b]), len(s)) for s, b in zip(causes, blocks, strict=True)]


def histogram(reports: Sequence[StudentReport]) -> list[tuple[int, int, int]]:
    """Count the students who score 0 to 10 percent, 10 to 20 percent, and so on.

    Each bin is returned with its limits in percent. The last one includes full marks and more.
    """
    counts: Counter[int] = Counter()
    for report in reports:
        most = report.points or report.extra  # an assignment's checks may give only extra credit
        if report.score is not None and most:
            counts[min(int(round(BINS * report.score / most, 6)), BINS - 1)] += 1
    step = 100 // BINS
    return [(step * i, step * (i + 1), counts[i]) for i in range(BINS)]
