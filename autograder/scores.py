"""Turn the verdicts of checks into the points of exercises."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from autograder.checks.verdict import Point, Status, Verdict
from autograder.manifest import Chapter, Exercise

ExerciseStatus = Status | Literal["waiting", "marked"]  # marked is what a person has done
PHYSICS_SHARE = 0.85  # of the points of an exercise, where it has robust checks as well


@dataclass(frozen=True)
class Result:
    """An exercise with the verdicts of its checks.

    A written answer waits for a person. The score is None while nobody can tell it: waiting, or
    error.
    """

    exercise: Exercise
    status: ExerciseStatus
    score: float | None
    checks: list[Verdict]

    @property
    def physics(self) -> list[Verdict]:
        """The checks of the physics tier, which unlocks what builds on the exercise."""
        return [check for check in self.checks if not check.robust]

    @property
    def robust(self) -> list[Verdict]:
        """The checks of the robust tier: bad arguments, overflow and NaN."""
        return [check for check in self.checks if check.robust]

    @property
    def works(self) -> bool:
        """Whether the physics passes, whatever the robust checks say."""
        return bool(self.checks) and all(check.status == "passed" for check in self.physics)

    @property
    def on_chart(self) -> Point | None:
        """Where the work lies on the chart of an open exercise; None where no check has put it."""
        return next((check.on_chart for check in self.checks if check.on_chart), None)


def results_of(chapter: Chapter, verdicts: Iterable[Verdict]) -> list[Result]:
    """Return a result for every exercise of the chapter that has verdicts or is written."""
    by_exercise: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        by_exercise.setdefault(verdict.exercise, []).append(verdict)
    return [result_of(exercise, by_exercise.get(exercise.id, [])) for exercise in chapter.exercises]


def result_of(exercise: Exercise, checks: list[Verdict]) -> Result:
    """Return the result of one exercise: its points, times the weight of the checks that pass.

    Where it has both tiers, PHYSICS_SHARE of the points are for the physics and the rest for the
    robust checks. Its status is that of its physics until that passes. An exercise without
    checks is an error of ours, not a zero.
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
    """Return the weight of the checks that pass as a fraction of the weight of all of them."""
    passed = sum(check.weight for check in checks if check.status == "passed")
    return passed / sum(check.weight for check in checks)


def total(results: Iterable[Result]) -> tuple[float | None, int]:
    """Return the points earned and the points that checks can give, written answers left out.

    Where the grader failed on an exercise, nobody can tell what was earned: None.
    """
    checked = [result for result in results if result.exercise.kind != "written"]
    points = sum(result.exercise.points for result in checked)
    scores = [result.score for result in checked if result.score is not None]
    return (round(sum(scores), 2) if len(scores) == len(checked) else None), points


def shown(score: float | None) -> str:
    """Return a score as people read it: 2.5, or - where there is none."""
    return "-" if score is None else f"{score:.2f}".rstrip("0").rstrip(".")


def place_on_chart(axes: Sequence[str], point: Sequence[float]) -> str:
    """Return a place on a chart as people read it; ``axes`` say what its cost and its error are."""
    return f"{point[0]:g} {axes[0]}, {axes[1]}: {point[1]:.2g}"
