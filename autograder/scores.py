"""Compute how many points a student earns on each exercise from the results of its checks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from autograder.checks.verdict import Point, Status, Verdict
from autograder.manifest import Chapter, Exercise

# "marked" means that a person gave points, and "changed" that the answer is a new one since then.
ExerciseStatus = Status | Literal["waiting", "marked", "changed"]
PHYSICS_SHARE = 0.85  # the physics checks' part of the points, if there are robust checks too


@dataclass(frozen=True)
class Result:
    """A student's result on one exercise: its status, its points and the verdicts on its checks.

    The score is None if the exercise is a written answer that nobody has marked yet, or if the
    grader itself failed on it.
    """

    exercise: Exercise
    status: ExerciseStatus
    score: float | None
    checks: list[Verdict]

    @property
    def physics(self) -> list[Verdict]:
        """The verdicts on the physics checks, all of which must pass for the exercise to work."""
        return [check for check in self.checks if not check.robust]

    @property
    def robust(self) -> list[Verdict]:
        """The verdicts on the robust checks, which try invalid arguments, overflow and NaN."""
        return [check for check in self.checks if check.robust]

    @property
    def works(self) -> bool:
        """True if all physics checks of the exercise pass, even if robust checks fail."""
        return bool(self.checks) and all(check.status == "passed" for check in self.physics)

    @property
    def on_chart(self) -> Point | None:
        """The cost and the error of the student's solution, or None if no check measured them.

        They are the coordinates of the solution on the chart of an open exercise.
        """
        return next((check.on_chart for check in self.checks if check.on_chart), None)


def results_of(chapter: Chapter, verdicts: Iterable[Verdict]) -> list[Result]:
    """Compute the result of every exercise in a chapter from the verdicts on its checks."""
    by_exercise: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        by_exercise.setdefault(verdict.exercise, []).append(verdict)
    return [result_of(exercise, by_exercise.get(exercise.id, [])) for exercise in chapter.exercises]


def result_of(exercise: Exercise, checks: list[Verdict]) -> Result:
    """Compute the status and points of an exercise from the results of its checks.

    The physics checks are worth PHYSICS_SHARE of the points, and the robust checks are worth the
    rest. If an exercise has only one kind of check, that kind is worth all the points. Within each
    kind, a student earns points in proportion to the total weight of the checks that pass. Robust
    checks affect the status only if all physics checks pass.

    The score is None if an exercise has no checks, or if the grader itself failed during a check.
    It is not zero, because the student is not at fault.
    """
    if exercise.kind == "written":
        return Result(exercise, "waiting", None, [])
    statuses = {check.status for check in checks}
    if not checks or "error" in statuses:
        return Result(exercise, "error", None, checks)
    tiers = [
        (PHYSICS_SHARE, [check for check in checks if not check.robust]),
        (1.0 - PHYSICS_SHARE, [check for check in checks if check.robust]),
    ]
    tiers = [(share, tier) for share, tier in tiers if tier]
    earned = sum(share * _passing(tier) for share, tier in tiers)
    score = exercise.points * earned / sum(share for share, _ in tiers)
    open_physics = {check.status for check in checks if not check.robust} - {"passed"}
    order: tuple[Status, ...] = ("failed", "blocked", "inherited", "passed")
    status = next(status for status in order if status in (open_physics or statuses))
    return Result(exercise, status, round(score, 2), checks)


def _passing(checks: Sequence[Verdict]) -> float:
    """Compute the weighted fraction of checks that pass."""
    passed = sum(check.weight for check in checks if check.status == "passed")
    return passed / sum(check.weight for check in checks)


def total(results: Iterable[Result]) -> tuple[float | None, float]:
    """Return the points that a student has earned, and the points that were possible.

    Written answers and optional exercises do not count. Extra credit adds to the points earned, but
    not to the points possible. If an exercise could not be graded, the points earned are None.
    """
    checked = [r for r in results if not (r.exercise.kind == "written" or r.exercise.optional)]
    points = possible(result.exercise for result in checked)
    scores = [result.score for result in checked if result.score is not None]
    return (round(sum(scores), 2) if len(scores) == len(checked) else None), points


def possible(exercises: Iterable[Exercise]) -> float:
    """Add up the points of some exercises, leaving out extra credit and optional exercises."""
    counted = [e.points for e in exercises if not (e.extra or e.optional)]
    return round(sum(counted), 2)


def extra_possible(exercises: Iterable[Exercise]) -> float:
    """Add up the points that some exercises can give as extra credit."""
    return round(sum(e.points for e in exercises if e.extra and not e.optional), 2)


def of_possible(score: float | None, points: float, extra: float) -> str:
    """Say how many of the possible points a student has, as in "3 of 5 points".

    ``extra`` is the possible extra credit. It is named only if there are no other points, since
    "4 of 0 points" would make no sense.
    """
    if extra and not points:
        return f"{shown(score)} of {shown(extra)} points of extra credit"
    return f"{shown(score)} of {shown(points)} points"


def shown(score: float | None) -> str:
    """Format a score for people to read, such as 2.5, or "-" if the score is not known yet."""
    return "-" if score is None else f"{score:.2f}".rstrip("0").rstrip(".")


def place_on_chart(axes: Sequence[str], point: Sequence[float]) -> str:
    """Format the cost and the error of a student's solution to an open exercise.

    ``axes`` contains the names of the two quantities, and ``point`` contains their values. An
    example of the result is "120 contacts resolved, error of the range: 0.02".
    """
    return f"{point[0]:g} {axes[0]}, {axes[1]}: {point[1]:.2g}"
