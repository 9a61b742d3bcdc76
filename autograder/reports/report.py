"""One student's results, as they are graded, kept in results/<student>.json, and read again."""

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
    """What became of a check."""

    name: str
    status: Status
    message: Message
    weight: float
    hidden: bool
    robust: bool


@dataclass(frozen=True)
class Chart:
    """Where a work lies on the chart of an open exercise, and the reference: cost and error.

    ``axes`` say what both are.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """What became of an exercise. A score is None while nobody can tell it.

    ``score_on_given`` is that on the reference's earlier chapters.
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


@dataclass(frozen=True)
class RunKey:
    """What must be the same for a report to hold, next to the submission itself."""

    seed: str
    chapters: list[int]
    given: list[int]
    checks: str
    grader: str
    python: str
    level: dict[str, bool]
    time_limit: float


@dataclass(frozen=True)
class StudentReport:
    """One student's results.

    ``points`` are those that checks can give; ``by_hand`` those that a person has given, and
    ``waiting`` those that one may give yet. ``earlier`` are the student's own chapters on which the
    graded ones build. ``submission`` is the digest of what was graded, in ``seconds``.
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

    @property
    def total(self) -> float | None:
        """The points of checks and persons together; None where the grader failed."""
        return None if self.score is None else self.score + (self.by_hand or 0)


def tiers(checks: Sequence[CheckReport]) -> list[tuple[str, int, int]]:
    """Return for each tier that has checks its name, how many pass, and how many there are."""
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
