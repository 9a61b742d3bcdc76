"""The report on one student's submission, which the grader stores in results/<student>.json."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from autograder.checks.verdict import Point, Secret, Status, Verdict
from autograder.message import Message
from autograder.scores import ExerciseStatus

# The last one means that something was handed in, but nothing that can be graded.
ReportStatus = Literal["graded", "error, retry", "nothing to grade"]


@dataclass(frozen=True)
class CheckReport:
    """The result of one check of a student's code, with a message that explains a failure.

    If the check is hidden, ``secret`` contains its real name and full message. Nothing that a
    student may see contains it: such pages and files are made from ``for_students(report)``.
    """

    name: str
    status: Status
    message: Message
    weight: float
    hidden: bool
    robust: bool
    secret: Secret | None = None


@dataclass(frozen=True)
class Chart:
    """The cost and the error of a student's solution to an open exercise, to be shown on a chart.

    An open exercise has more than one good answer, so the chart plots the error of each solution
    against its cost.

    Attributes:
        axes: The names of the two quantities.
        own: The cost and the error of the student's solution.
        reference: The cost and the error of our solution, or None if they are unknown.
    """

    axes: list[str]
    own: Point
    reference: Point | None


@dataclass(frozen=True)
class ExerciseReport:
    """A student's result on one exercise, as stored in the student's report.

    A score is None if it is not known yet. ``score_on_given`` is the score that the student would
    get with our solutions to the earlier chapters. If ``extra`` is True, the exercise gives extra
    credit, and its points are not part of the possible total.
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
class Cause:
    """An exercise of an earlier assignment that fails and thereby blocks graded exercises.

    It earns no points, and has no column in the gradebook.

    Attributes:
        assignment: The name of the earlier assignment, or "" if it is not known.
        blocks: The graded exercises that build on this one and fail, such as ["B2.10"].
        checks: The physics checks of the exercise.
    """

    chapter: int
    id: str
    title: str
    assignment: str
    status: ExerciseStatus
    blocks: list[str]
    checks: list[CheckReport]

    @property
    def name(self) -> str:
        """The exercise with its assignment, such as "B2.9 of lab1"."""
        return f"{self.id} of {self.assignment}" if self.assignment else self.id

    @property
    def advice(self) -> str:
        """What the student should do, as the rest of a sentence that begins with the name."""
        verb = "build" if self.blocks[1:] else "builds"
        return f"fails. Fix it first, because {_listed(self.blocks)} {verb} on it."


@dataclass(frozen=True)
class Late:
    """How late a student handed in the work, and how many points that costs.

    Attributes:
        days: The number of days, or None if we do not know when the work was handed in.
        deduction: The number of points to subtract under the course's late policy.
        words: An explanation for the student, in full sentences.
    """

    days: int | None
    deduction: float
    words: str


@dataclass(frozen=True)
class RunKey:
    """The settings with which a submission was graded, such as the seed and the time limit.

    The report from an earlier run is reused if neither the settings nor the submission have
    changed. ``points`` maps each exercise to its points, and ``extra`` lists the exercises for
    extra credit. ``earlier`` maps prerequisites to the names of the earlier assignments that
    contain them.
    """

    seed: str
    chapters: list[int]
    points: dict[str, float]
    extra: list[str]
    given: list[int]
    earlier: dict[str, str]
    checks: str
    grader: str
    python: str
    level: dict[str, bool]
    time_limit: float


@dataclass(frozen=True)
class StudentReport:
    """The report on one student: the results of all exercises, and the points.

    Attributes:
        score: The points from checks. It is None if grading failed.
        score_on_given: The points from checks when our solutions replace the student's earlier
            chapters.
        points: The points that the checks are worth.
        by_hand: The points that instructors gave for written answers.
        waiting: The points for written answers that nobody has marked yet.
        earlier: The numbers of the student's own earlier chapters that the graded ones use.
        submission: A hash of the graded files, which shows whether they have changed.
        seconds: How long grading took.
        late: How late the submission is. It is None if the work has no due date.
        nothing: Why nothing of the submission could be graded, or "" if something could.
        causes: The exercises of earlier assignments that block graded ones.
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
    nothing: str = ""

    causes: list[Cause] = field(default_factory=list)

    @property
    def extra(self) -> float:
        """The points that checks can give as extra credit. They are not part of ``points``."""
        return round(sum(e.points for e in self.exercises if e.extra and e.kind != "written"), 2)

    @property
    def first_cause(self) -> Cause | None:
        """The exercise of an earlier assignment that the student should fix before anything else.

        The result is None if no such exercise contains a mistake of its own.
        """
        return next((cause for cause in self.causes if cause.status == "failed"), None)

    @property
    def earned(self) -> float | None:
        """The student's points from checks and marks, before any late penalty.

        The result is None if grading failed.
        """
        return None if self.score is None else self.score + (self.by_hand or 0)

    @property
    def penalty(self) -> float:
        """The points that the student loses because the work was handed in late.

        The penalty is never larger than the points earned, so the total cannot be negative.
        """
        return min(self.late.deduction if self.late else 0.0, self.earned or 0.0)

    @property
    def about_lateness(self) -> str:
        """How late the work is and what that costs, in sentences for the student."""
        if self.late is None:
            return ""
        limit = " The penalty is never more than the points earned."
        return self.late.words + (limit if self.late.deduction > self.penalty else "")

    @property
    def total(self) -> float | None:
        """The student's points after the late penalty, or None if grading failed."""
        return None if self.earned is None else round(self.earned - self.penalty, 2)


def check_report(verdict: Verdict) -> CheckReport:
    """Convert the verdict on a check to the form in which reports store it."""
    return CheckReport(
        verdict.name,
        verdict.status,
        verdict.message,
        verdict.weight,
        verdict.hidden,
        verdict.robust,
        verdict.secret,
    )


def for_students(report: StudentReport) -> StudentReport:
    """Return a copy of the report without anything that students may not know of hidden checks."""

    def public(checks: Sequence[CheckReport]) -> list[CheckReport]:
        return [replace(check, secret=None) for check in checks]

    return replace(
        report,
        exercises=[replace(one, checks=public(one.checks)) for one in report.exercises],
        causes=[replace(one, checks=public(one.checks)) for one in report.causes],
    )


def _listed(names: Sequence[str]) -> str:
    """Join names for a sentence, as in "B2.9, B2.10 and 2.5"."""
    return " and ".join(filter(None, [", ".join(names[:-1]), *names[-1:]]))


def tiers(checks: Sequence[CheckReport]) -> list[tuple[str, int, int]]:
    """Count the physics checks and the robust checks of an exercise, and how many of each pass.

    Returns:
        One tuple for each kind of check that the exercise has. For example, ("physics", 3, 4) means
        that 3 of 4 physics checks pass.
    """
    found = []
    for name, robust in (("physics", False), ("robust", True)):
        states = [check.status for check in checks if check.robust is robust]
        if states:
            found.append((name, states.count("passed"), len(states)))
    return found
