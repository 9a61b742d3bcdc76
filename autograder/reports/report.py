"""The report on one student's submission, which the grader stores in results/<student>.json."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

from autograder.scores import Result, extra_possible

ReportStatus = Literal["graded", "error, retry", "nothing to grade"]


@dataclass(frozen=True)
class Cause:
    """An exercise of an earlier assignment that fails and blocks graded ones. It has no points."""

    result: Result  # has only the physics checks
    assignment: str  # the name of the earlier assignment, or "" if it is not known
    blocks: list[str]  # the graded exercises that build on this one and fail, such as ["B2.10"]

    @property
    def name(self) -> str:
        """The exercise with its assignment, such as "B2.9 of lab1"."""
        name = self.result.exercise.id
        return f"{name} of {self.assignment}" if self.assignment else name

    @property
    def advice(self) -> str:
        """What the student should do, as the rest of a sentence that begins with the name."""
        verb = "build" if self.blocks[1:] else "builds"
        listed = " and ".join(filter(None, [", ".join(self.blocks[:-1]), *self.blocks[-1:]]))
        return f"fails. Fix it first, because {listed} {verb} on it."


@dataclass(frozen=True)
class Late:
    """How late a student handed in the work, and how many points that costs."""

    days: int | None  # None if we do not know when the work was handed in
    deduction: float  # the points to subtract under the course's late policy
    words: str  # an explanation for the student, in full sentences


@dataclass(frozen=True)
class RunKey:
    """The settings of a run. An earlier report with the same ones and submission is reused."""

    seed: str
    chapters: list[int]
    points: dict[str, float]  # of each exercise
    extra: list[str]  # the exercises for extra credit
    given: list[int]
    earlier: dict[str, str]  # the earlier assignments that contain prerequisites
    checks: str
    grader: str
    python: str
    level: dict[str, bool]
    time_limit: float


@dataclass(frozen=True)
class StudentReport:
    """The report on one student: the results of all exercises, and the points."""

    student: str
    status: ReportStatus
    seed: str
    isolation: str
    score: float | None  # the points from checks, or None if grading failed
    score_on_given: float | None  # those with our solutions in place of earlier chapters
    points: float  # what the checks are worth
    by_hand: float | None  # the points that instructors gave for written answers
    waiting: float  # the points for written answers that nobody has marked yet
    earlier: list[int]  # the student's own earlier chapters that the graded ones use
    notes: list[str]
    results: list[Result]
    submission: str = ""  # a hash of the graded files, which shows whether they have changed
    seconds: float | None = None  # how long grading took
    run: RunKey | None = None
    late: Late | None = None  # None if the work has no due date
    nothing: str = ""  # why nothing of the submission could be graded, or "" if something could
    causes: list[Cause] = field(default_factory=list)

    @property
    def extra(self) -> float:
        """The points that checks can give as extra credit. They are not part of ``points``."""
        exercises = [result.exercise for result in self.results]
        return extra_possible(e for e in exercises if e.kind != "written")

    @property
    def first_cause(self) -> Cause | None:
        """The exercise of an earlier assignment to fix first, if one has a mistake of its own."""
        return next((cause for cause in self.causes if cause.result.status == "failed"), None)

    @property
    def changed(self) -> list[str]:
        """The written exercises whose answers have changed since a person marked them."""
        return [result.exercise.id for result in self.results if result.status == "changed"]

    @property
    def earned(self) -> float | None:
        """The points from checks and marks before any late penalty, or None if grading failed."""
        return None if self.score is None else self.score + (self.by_hand or 0)

    @property
    def penalty(self) -> float:
        """The points that lateness costs, never more than the points earned."""
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


def for_students(report: StudentReport) -> StudentReport:
    """Return a copy without the secrets of hidden checks, from which all that is shown is made."""

    def public(result: Result) -> Result:
        return replace(result, checks=[replace(check, secret=None) for check in result.checks])

    results = [public(result) for result in report.results]
    causes = [replace(cause, result=public(cause.result)) for cause in report.causes]
    return replace(report, results=results, causes=causes)
