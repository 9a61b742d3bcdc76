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
    """Where a submission and the reference are on the chart of an open exercise.

    ``axes`` names the two coordinates, which are cost and error.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """The outcome of an exercise. A score that is not known yet is None.

    ``score_on_given`` is the score with the earlier chapters taken from the reference. The points
    of ``extra`` credit are not part of the possible points.
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
    """How late a submission is by the rules of the course, and the points that this costs.

    ``days`` is None if it is unknown. ``words`` contains further explanations, as sentences.
    """

    days: int | None
    deduction: float
    words: str


@dataclass(frozen=True)
class RunKey:
    """The conditions, besides the submission, under which a report remains valid.

    ``points`` maps each graded exercise to its points. ``extra`` lists the extra-credit exercises.
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

    Checks can give ``points``. A person has given ``by_hand`` points, and can still give
    ``waiting`` points. ``earlier`` lists the student's own chapters on which the graded ones build.
    ``submission`` is the digest of the graded files. ``seconds`` is the time that grading took.
    ``late`` is None if the work has no due date.
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
        """The points from checks and from people, or None if the grader failed."""
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
    """Return the tiers that have checks.

    Each has a name, a number of passed checks, and a total.
    """
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
