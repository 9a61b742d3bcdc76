"""Compute the statistics of a graded class, such as the pass rate of each exercise.

The instructor sees them on the overview page of the class, index.html.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from autograder.manifest import Chapter, Exercise
from autograder.reports.report import Cause, ExerciseReport, StudentReport
from autograder.reports.texts import check_title

MOST_MISSED = 5
BINS = 10


@dataclass(frozen=True)
class ExerciseRate:
    """The pass rate of an exercise in a class, and the average number of points.

    A student has no score if grading failed, or while a written answer is still waiting to be
    marked.

    Attributes:
        counted: The number of students who have a score for the exercise.
        passed: The number of students who pass the exercise.
        mean: The average score in points, or None if nobody has a score.
        first_lost: The check that most students fail.
    """

    exercise: Exercise
    counted: int
    passed: int
    mean: float | None
    first_lost: str  # the check that most students fail

    @property
    def share(self) -> float | None:
        """The fraction of students who pass every check of the exercise, such as 0.75.

        Students without a score are not counted. The fraction is None if nobody has a score. It is
        also None for a written exercise, which has no checks.
        """
        if self.exercise.kind == "written" or not self.counted:
            return None
        return self.passed / self.counted


@dataclass(frozen=True)
class Bin:
    """One bar in the histogram of a class's scores, such as the bar from 70 to 80 percent.

    Attributes:
        low: The lower limit in percent. A score equal to this limit is counted in the bar.
        high: The upper limit in percent. A score equal to this limit is counted in the next bar,
            unless the limit is 100.
        count: The number of students counted in the bar.
    """

    low: int
    high: int
    count: int


def exercise_rates(chapters: list[Chapter], reports: Sequence[StudentReport]) -> list[ExerciseRate]:
    """Compute the pass rate and the average points of each exercise from the reports on a class.

    The result lists the exercises in the order of ``chapters``.
    """
    results: dict[str, list[ExerciseReport]] = {}
    for report in reports:
        for exercise in report.exercises:
            results.setdefault(exercise.id, []).append(exercise)
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    return [_rate(exercise, results.get(exercise.id, [])) for exercise in exercises]


def most_missed(rates: list[ExerciseRate]) -> list[ExerciseRate]:
    """Find the five exercises with the lowest pass rates in a class, hardest first.

    Exercises that everybody passes and written exercises are left out, so there may be fewer than
    five.
    """
    missed = [rate for rate in rates if rate.share is not None and rate.share < 1]
    return sorted(missed, key=_pass_share_then_points)[:MOST_MISSED]


def causes_in(reports: Sequence[StudentReport]) -> list[tuple[Cause, int]]:
    """List the exercises of earlier assignments that students have to fix first.

    Each is returned with the number of students whose graded exercises it blocks, most first.
    """
    found: dict[str, Cause] = {}
    counts: Counter[str] = Counter()
    for cause in (cause for report in reports for cause in report.causes):
        if cause.status == "failed":
            counts[cause.id] += 1
            known = found.setdefault(cause.id, cause)
            blocks = dict.fromkeys([*known.blocks, *cause.blocks])
            found[cause.id] = replace(known, blocks=[*blocks])
    return [(found[name], count) for name, count in counts.most_common()]


def histogram(reports: Sequence[StudentReport]) -> list[Bin]:
    """Count how many students of a class score 0 to 10 percent, 10 to 20 percent, and so on.

    Full marks go into the last bin, and so do higher scores due to extra credit. Students without a
    score are not counted.
    """
    counts: Counter[int] = Counter()
    for report in reports:
        most = report.points or report.extra  # an assignment's checks may give only extra credit
        if report.score is not None and most:
            tenths = round(BINS * report.score / most, 6)
            counts[min(int(tenths), BINS - 1)] += 1
    step = 100 // BINS
    return [Bin(step * i, step * (i + 1), counts[i]) for i in range(BINS)]


def _pass_share_then_points(rate: ExerciseRate) -> tuple[float, float]:
    return rate.share or 0.0, (rate.mean or 0.0) / rate.exercise.points


def _rate(exercise: Exercise, results: list[ExerciseReport]) -> ExerciseRate:
    scores = [result.score for result in results if result.score is not None]
    lost = Counter(
        "a hidden check" if check.hidden else check_title(check.name)
        for result in results
        for check in result.checks
        if check.status in ("failed", "blocked", "inherited")
    )
    return ExerciseRate(
        exercise,
        len(scores),
        sum(result.status == "passed" for result in results),
        round(sum(scores) / len(scores), 2) if scores else None,
        lost.most_common(1)[0][0] if lost else "",
    )
