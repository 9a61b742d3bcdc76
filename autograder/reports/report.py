"""The report on one student's submission, which is stored in results/<student>.json."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from autograder.checks.verdict import Point, Status
from autograder.message import Message
from autograder.scores import ExerciseStatus

ReportStatus = Literal["graded", "error, retry"]


@dataclass(frozen=True)
class CheckReport:
    """The outcome of one check."""

    name: str
    status: Status
    message: Message
    weight: float
    hidden: bool
    robust: bool


@dataclass(frozen=True)
class Chart:
    """The positions of a submission and of the reference on the chart of an open exercise.

    ``axes`` names the two coordinates, which are cost and error.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """The outcome of an exercise. A score is None if it is not known yet.

    ``score_on_given`` is the score with the earlier chapters of the reference. The points of
    ``extra`` credit do not count toward the possible points.
    """

    chapter: int
    id: str
    title: str
    kind: str
    points: float
    score: float | None
    score_on_given: float | None
    status: ExerciseStatus
    comment: str
    checks: list[CheckReport]
    chart: Chart | None
    extra: bool = False


@dataclass(frozen=True)
class Late:
    """How late a submission is under the rules of the course, and how many points it loses.

    ``days`` is None if it is unknown. ``words`` contains sentences with further explanations.
    """

    days: int | None
    deduction: float
    words: str


@dataclass(frozen=True)
class RunKey:
    """The conditions that must not change if a report is to remain valid.

    ``points`` maps each graded exercise to its points. ``extra`` lists the extra-credit exercises.
    The submission itself is not one of the conditions.
    """

    seed: str
    chapters: list[int]
    points: dict[str, float]
    extra: list[str]
    given: list[int]
    checks: str
    grader: str
    python: str
    level: dict[str, bool]
    time_limit: float


@dataclass(frozen=True)
class StudentReport:
    """The results of one student.

    ``points`` is the number of points that checks can give. ``by_hand`` is the number of points
    that people have given, and ``waiting`` is the number that they can still give. ``earlier``
    lists the student's own earlier chapters that the graded chapters use. ``submission`` is the
    digest of the graded files. ``seconds`` is the time that grading took. ``late`` is None if the
    work has no due date.
    """

    student: str
    status: ReportStatus
    seed: str
    isolation: str
    score: float | None
    score_on_given: float | None
    points: float
    by_hand: float | None
    waiting: float
    earlier: list[int]
    notes: list[str]
    exercises: list[ExerciseReport]
    submission: str = ""
    seconds: float | None = None
    run: RunKey | None = None
    late: Late | None = None

    @property
    def earned(self) -> float | None:
        """The points that checks and people have given. It is None if the grader failed."""
        return None if self.score is None else self.score + (self.by_hand or 0)

    @property
    def penalty(self) -> float:
        """The points deducted for lateness, which never exceed the points earned."""
        return min(self.late.deduction if self.late else 0.0, self.earned or 0.0)

    @property
    def total(self) -> float | None:
        """The points earned minus the penalty, or None if the grader failed."""
        return None if self.earned is None else round(self.earned - self.penalty, 2)


def tiers(checks: Sequence[CheckReport]) -> list[tuple[str, int, int]]:
    """Return the tiers that have checks, physics or robust.

    For each tier, return its name, the number of passed checks, and the number of checks.
    """
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
