"""Convert the verdicts on checks to the points of exercises."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from autograder.checks.verdict import Point, Status, Verdict
from autograder.manifest import Chapter, Exercise

ExerciseStatus = Status | Literal["waiting", "marked"]  # "marked" means that a person gave points
PHYSICS_SHARE = 0.85  # of an exercise's points, if it also has robust checks


@dataclass(frozen=True)
class Result:
    """The result of an exercise, with the verdicts on its checks.

    The score is None while it is unknown. It is unknown if nobody has marked a written answer yet,
    or if the grader failed on the exercise.
    """

    exercise: Exercise
    status: ExerciseStatus
    score: float | None
    checks: list[Verdict]

    @property
    def physics(self) -> list[Verdict]:
        """The verdicts on the physics checks. Only these can block later exercises."""
        return [check for check in self.checks if not check.robust]

    @property
    def robust(self) -> list[Verdict]:
        """The verdicts on the robust checks, which test bad arguments, overflow and NaN."""
        return [check for check in self.checks if check.robust]

    @property
    def works(self) -> bool:
        """Whether all physics checks pass, regardless of the robust checks."""
        return bool(self.checks) and all(check.status == "passed" for check in self.physics)

    @property
    def on_chart(self) -> Point | None:
        """The submission's position on the chart, or None if no check has reported one."""
        return next((check.on_chart for check in self.checks if check.on_chart), None)


def results_of(chapter: Chapter, verdicts: Iterable[Verdict]) -> list[Result]:
    """Return the result of each exercise in the chapter."""
    by_exercise: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        by_exercise.setdefault(verdict.exercise, []).append(verdict)
    return [result_of(exercise, by_exercise.get(exercise.id, [])) for exercise in chapter.exercises]


def result_of(exercise: Exercise, checks: list[Verdict]) -> Result:
    """Compute the result of ``exercise``. The points depend on the weights of the passing checks.

    If the exercise has both tiers, the physics checks earn PHYSICS_SHARE of the points and the
    robust checks earn the rest. The status depends only on the physics checks until all of them
    pass. If an exercise has no checks, this is an error of the grader, so the score is not zero.
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
    """Return the weight of the passing checks as a fraction of the total weight."""
    passed = sum(check.weight for check in checks if check.status == "passed")
    return passed / sum(check.weight for check in checks)


def total(results: Iterable[Result]) -> tuple[float | None, float]:
    """Return the points earned and the possible points. Written answers are not included.

    If the grader failed on an exercise, the points earned are unknown, so they are None. Extra
    credit adds to the points earned but not to the possible points. Optional exercises do not
    count.
    """
    checked = [r for r in results if not (r.exercise.kind == "written" or r.exercise.optional)]
    points = possible(result.exercise for result in checked)
    scores = [result.score for result in checked if result.score is not None]
    return (round(sum(scores), 2) if len(scores) == len(checked) else None), points


def possible(exercises: Iterable[Exercise]) -> float:
    """Return the points that these exercises can give, without extra credit."""
    counted = [e.points for e in exercises if not (e.extra or e.optional)]
    return round(sum(counted), 2)


def shown(score: float | None) -> str:
    """Format a score for people to read, such as 2.5. If there is no score, return a dash."""
    return "-" if score is None else f"{score:.2f}".rstrip("0").rstrip(".")


def place_on_chart(axes: Sequence[str], point: Sequence[float]) -> str:
    """Format a position on a chart for people to read. ``axes`` names the cost and the error."""
    return f"{point[0]:g} {axes[0]}, {axes[1]}: {point[1]:.2g}"
