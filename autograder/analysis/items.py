"""Compute how well a class did on each exercise and on each of its checks.

Each chapter is scored with the reference solution in place of the student's earlier chapters.
Otherwise a single mistake in chapter 2 would lower the scores in every chapter that uses vectors.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from autograder.analysis.discrimination import Discrimination, discrimination
from autograder.manifest import Chapter, Exercise
from autograder.message import Kind
from autograder.reports.report import CheckReport, ExerciseReport, StudentReport

State = Literal["passed", "failed", "not written", "blocked", "inherited", "error"]
STATES: tuple[State, ...] = ("passed", "failed", "not written", "blocked", "inherited", "error")
HIDDEN = "a hidden check"


@dataclass(frozen=True)
class CheckItem:
    """The results of a whole class on one check of an exercise.

    Attributes:
        robust: True if the check tests bad arguments, overflow or NaN.
        states: The number of students who passed the check, who failed it, who had not written the
            function, and so on.
    """

    name: str
    robust: bool
    hidden: bool
    states: Counter[State]


@dataclass(frozen=True)
class ExerciseItem:
    """The results of a whole class on one exercise.

    Attributes:
        full: The number of students with full credit.
        part: The number of students with partial credit.
        none: The number of students with no credit.
        mean: The average score as a fraction of the points, or None if no student has a score.
    """

    exercise: Exercise
    full: int
    part: int
    none: int
    mean: float | None
    discrimination: Discrimination
    checks: list[CheckItem]

    @property
    def counted(self) -> int:
        """The number of students in the class who have a score for this exercise."""
        return self.full + self.part + self.none


def items_of(chapter: Chapter, reports: Sequence[StudentReport]) -> list[ExerciseItem]:
    """Compute how well a class did on each exercise of a chapter, in the order of the exercises."""
    return [_item(exercise, reports) for exercise in chapter.exercises]


def _item(exercise: Exercise, reports: Sequence[StudentReport]) -> ExerciseItem:
    found: list[ExerciseReport] = []
    own: list[float] = []
    rest: list[float] = []
    for report in reports:
        for result in report.exercises:
            if result.id != exercise.id:
                continue
            found.append(result)
            if result.score_on_given is not None and report.score_on_given is not None:
                own.append(result.score_on_given)
                by_checks = 0.0 if result.kind == "written" else result.score_on_given
                rest.append(report.score_on_given - by_checks)
    scores = [result.score_on_given for result in found if result.score_on_given is not None]
    full = sum(score >= exercise.points for score in scores)
    none = sum(score <= 0.0 for score in scores)
    return ExerciseItem(
        exercise,
        full,
        len(scores) - full - none,
        none,
        sum(scores) / len(scores) / exercise.points if scores else None,
        discrimination(own, rest),
        _checks(found),
    )


def _checks(results: Sequence[ExerciseReport]) -> list[CheckItem]:
    """Count how many students passed or failed each check of an exercise.

    The list begins with the physics checks, followed by those for bad arguments, overflow and NaN.
    """
    items: dict[tuple[str, bool], CheckItem] = {}
    for result in results:
        for check in result.checks:
            new = CheckItem(check.name, check.robust, check.hidden, Counter())
            item = items.setdefault((check.name, check.hidden), new)
            item.states[_state(check)] += 1
    return sorted(items.values(), key=lambda item: (item.robust, item.hidden))


def _state(check: CheckReport) -> State:
    unwritten = check.message.kind is Kind.UNWRITTEN and check.status in ("failed", "blocked")
    return "not written" if unwritten else check.status
