"""The report on one student's submission, as stored in results/<student>.json."""

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
    """The result of one check in the report on a student."""

    name: str
    status: Status
    message: Message
    weight: float
    hidden: bool
    robust: bool


@dataclass(frozen=True)
class Chart:
    """The data for the chart of an open exercise: a student's solution and ours.

    The chart plots each solution's error against its cost. ``axes`` names the two quantities.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """The results of one exercise in the report on a student. An unknown score is None.

    ``score_on_given`` is the score when the earlier chapters come from our reference. An ``extra``
    credit exercise does not add to the points possible.
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
    """How late a submission is under the course's late policy, and how many points that costs.

    ``days`` is None if that is unknown. ``words`` explains the result in full sentences.
    """

    days: int | None
    deduction: float
    words: str


@dataclass(frozen=True)
class RunKey:
    """The conditions of grading: everything besides the submission that a report depends on.

    If any of them changes, the report is no longer valid. ``points`` holds the points of each
    graded exercise, and ``extra`` lists the exercises that give extra credit.
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
    """All results of one student.

    Attributes:
        score: The points from checks. It is None if the grader failed.
        score_on_given: The points from checks, with the reference's earlier chapters.
        points: The points that the checks are worth.
        by_hand: The points that people gave for written answers.
        waiting: The points that people can still give.
        earlier: The numbers of the earlier chapters by the student that the graded ones use.
        submission: A digest of the graded files.
        seconds: How long grading took.
        late: How late the submission is. It is None if the work has no due date.
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
        """The points earned from checks and from marks, or None if the grader failed."""
        return None if self.score is None else self.score + (self.by_hand or 0)

    @property
    def penalty(self) -> float:
        """The points lost to lateness, which never exceed the points earned."""
        return min(self.late.deduction if self.late else 0.0, self.earned or 0.0)

    @property
    def total(self) -> float | None:
        """The points earned minus the late penalty, or None if the grader failed."""
        return None if self.earned is None else round(self.earned - self.penalty, 2)


def tiers(checks: Sequence[CheckReport]) -> list[tuple[str, int, int]]:
    """Count how many physics checks and how many robust checks pass.

    For each kind of which there are any, return its name, the number of checks that pass, and the
    total number.
    """
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
