"""Compute how many points a student earns on each exercise from the results of its checks."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal

from autograder.checks.verdict import Point, Status, Verdict
from autograder.manifest import Chapter, Exercise
from autograder.message import Kind

# "marked" means that a person gave points, and "changed" that the answer is a new one since then.
ExerciseStatus = Status | Literal["waiting", "marked", "changed"]
PHYSICS_SHARE = 0.85  # the physics checks' part of the points, if there are robust checks too


@dataclass(frozen=True)
class Result:
    """A student's result on one exercise: its status, its points and the verdicts on its checks."""

    exercise: Exercise
    status: ExerciseStatus
    score: float | None  # None if nobody has marked the written answer or the grader failed
    checks: list[Verdict]
    chapter: int = 0  # the number of the exercise's chapter
    score_on_given: float | None = None  # with our solutions to the earlier chapters
    comment: str = ""  # what the person wrote who marked a written answer
    reference: Point | None = None  # the cost and the error of our solution to an open exercise

    @property
    def physics(self) -> list[Verdict]:
        """The verdicts on the physics checks, all of which must pass for the exercise to work."""
        return [check for check in self.checks if not check.robust]

    @property
    def robust(self) -> list[Verdict]:
        """The verdicts on the robust checks, which try invalid arguments, overflow and NaN."""
        return [check for check in self.checks if check.robust]

    @property
    def tiers(self) -> list[tuple[str, int, int]]:
        """How many checks of each kind pass, and how many there are, such as ("physics", 3, 4)."""
        tiers = [("physics", self.physics), ("robust", self.robust)]
        return [
            (name, sum(check.status == "passed" for check in checks), len(checks))
            for name, checks in tiers
            if checks
        ]

    @property
    def works(self) -> bool:
        """True if all physics checks of the exercise pass, even if robust checks fail."""
        return bool(self.checks) and all(check.status == "passed" for check in self.physics)

    @property
    def state(self) -> str:
        """The status, or "not written yet" or "half written" if that is why checks fail."""
        states = {check.state for check in self.checks if not check.hidden}
        if states == {Kind.UNWRITTEN.value}:
            return Kind.UNWRITTEN.value
        return "half written" if states == {"passed", Kind.UNWRITTEN.value} else self.status

    @property
    def on_chart(self) -> Point | None:
        """The cost and the error of the solution to an open exercise, if a check measured them."""
        return next((check.on_chart for check in self.checks if check.on_chart), None)

    @property
    def place(self) -> str:
        """The place on the chart in words, as in "9 evaluations, error of the result: 0.02"."""
        if self.on_chart is None:
            return ""
        (cost, error), axes = self.on_chart, self.exercise.chart
        return f"{cost:g} {axes[0]}, {axes[1]}: {error:.2g}"


def results_of(chapter: Chapter, verdicts: Iterable[Verdict]) -> list[Result]:
    """Compute the result of every exercise in a chapter from the verdicts on its checks."""
    by_exercise: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        by_exercise.setdefault(verdict.exercise, []).append(verdict)
    results = [result_of(one, by_exercise.get(one.id, [])) for one in chapter.exercises]
    return [replace(result, chapter=chapter.number) for result in results]


def result_of(exercise: Exercise, checks: list[Verdict]) -> Result:
    """Compute the status and points of an exercise from the results of its checks.

    Each kind of check earns its fraction of the points by the weight of those that pass. Robust
    checks affect the status only if all physics checks pass. The score is None, not zero, if there
    are no checks or the grader failed: the student is not at fault.
    """
    if exercise.kind == "written":
        return Result(exercise, "waiting", None, [])
    statuses = {check.status for check in checks}
    if not checks or "error" in statuses:
        return Result(exercise, "error", None, checks)
    earned = whole = 0.0
    for share, robust in ((PHYSICS_SHARE, False), (1.0 - PHYSICS_SHARE, True)):
        if tier := [check for check in checks if check.robust is robust]:
            passed = sum(check.weight for check in tier if check.status == "passed")
            earned += share * passed / sum(check.weight for check in tier)
            whole += share
    open_physics = {check.status for check in checks if not check.robust} - {"passed"}
    order: tuple[Status, ...] = ("failed", "blocked", "inherited", "passed")
    status = next(status for status in order if status in (open_physics or statuses))
    return Result(exercise, status, round(exercise.points * earned / whole, 2), checks)


def total(results: Iterable[Result]) -> tuple[float | None, float]:
    """Return the points that checks earned, or None if one is missing, and the possible points.

    Optional exercises do not count. Extra credit adds only to the points earned.
    """
    checked = [r for r in results if not (r.exercise.kind == "written" or r.exercise.optional)]
    points = possible(result.exercise for result in checked)
    scores = [result.score for result in checked if result.score is not None]
    return (round(sum(scores), 2) if len(scores) == len(checked) else None), points


def possible(exercises: Iterable[Exercise]) -> float:
    """Add up the points of some exercises, leaving out extra credit and optional exercises."""
    return round(sum(e.points for e in exercises if not (e.extra or e.optional)), 2)


def extra_possible(exercises: Iterable[Exercise]) -> float:
    """Add up the points that some exercises can give as extra credit."""
    return round(sum(e.points for e in exercises if e.extra and not e.optional), 2)


def of_possible(score: float | None, points: float, extra: float) -> str:
    """Say how many of the possible points a student has, as in "3 of 5 points"."""
    if extra and not points:
        return f"{shown(score)} of {shown(extra)} points of extra credit"
    return f"{shown(score)} of {shown(points)} points"


def shown(score: float | None) -> str:
    """Format a score for people to read, such as 2.5, or "-" if the score is not known yet."""
    return "-" if score is None else f"{score:.2f}".rstrip("0").rstrip(".")
