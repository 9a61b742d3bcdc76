"""One student's results as they are graded, stored in results/<student>.json and read again."""

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
    """The outcome of a check."""

    name: str
    status: Status
    message: Message
    weight: float
    hidden: bool
    robust: bool


@dataclass(frozen=True)
class Chart:
    """The positions of a submission and of the reference on the chart of an open exercise.

    ``axes`` names the two coordinates, cost and error.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """The outcome of an exercise. A score is None while it is unknown.

    ``score_on_given`` is the score on the reference's earlier chapters. The points of ``extra``
    credit are not part of the points possible.
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
    """How late a submission is by the course's rules, and the points that this costs.

    ``days`` is None if it is unknown. ``words`` explains the rest in sentences.
    """

    days: int | None
    deduction: float
    words: str


@dataclass(frozen=True)
class RunKey:
    """The conditions, besides the submission, under which a report stays valid.

    ``points`` maps each graded exercise to its points, and ``extra`` lists those of extra credit.
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
    """One student's results.

    Checks can give ``points``. A person has given ``by_hand`` points, and can still give
    ``waiting`` points. ``earlier`` lists the student's own chapters on which the graded ones build.
    ``submission`` is the digest of the graded files. Grading took ``seconds``. ``late`` is None if
    nothing is due.
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
        """The points from checks and people together, or None if the grader failed."""
        return None if self.score is None else self.score + (self.by_hand or 0)

    @property
    def penalty(self) -> float:
        """The points that lateness takes away, which are never more than the points earned."""
        return min(self.late.deduction if self.late else 0.0, self.earned or 0.0)

    @property
    def total(self) -> float | None:
        """The points earned without the penalty, or None if the grader failed."""
        return None if self.earned is None else round(self.earned - self.penalty, 2)


def tiers(checks: Sequence[CheckReport]) -> list[tuple[str, int, int]]:
    """Return each tier that has checks: its name, how many pass, and how many there are."""
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
