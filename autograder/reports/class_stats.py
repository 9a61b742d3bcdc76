"""Compute the statistics of a graded class, such as the pass rate of each exercise.

The instructor sees them on the overview page of the class, index.html.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from autograder.manifest import Chapter, Exercise
from autograder.reports.report import ExerciseReport, StudentReport
from autograder.reports.texts import check_title

MOST_MISSED = 5
BINS = 10


@dataclass(frozen=True)
class ExerciseRate:
    """How many students of a class pass an exercise, and how many points they earn on average.

    ``counted`` is the number of students who have a score for the exercise. Students have no score
    if the grader failed on their submission, or as long as nobody has marked their written answer.
    """

    exercise: Exercise
    counted: int
    passed: int
    mean: float | None
    first_lost: str  # the check that most students fail

    @property
    def share(self) -> float | None:
        """The fraction of students who pass every check of the exercise, among those with a score.

        It is None for a written exercise, which has no checks, and if no student has a score yet.
        """
        if self.exercise.kind == "written" or not self.counted:
            return None
        return self.passed / self.counted


@dataclass(frozen=True)
class Bin:
    """A bar in the histogram of a class's scores.

    ``count`` students have a score of at least ``low`` and less than ``high`` percent of the
    points. The last bar includes full marks.
    """

    low: int
    high: int
    count: int


def exercise_rates(chapters: list[Chapter], reports: Sequence[StudentReport]) -> list[ExerciseRate]:
    """Compute the pass rate of each exercise from the reports on all students of a class.

    The exercises are in the same order as in the chapters' manifests.
    """
    results: dict[str, list[ExerciseReport]] = {}
    for report in reports:
        for exercise in report.exercises:
            results.setdefault(exercise.id, []).append(exercise)
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    return [_rate(exercise, results.get(exercise.id, [])) for exercise in exercises]


def most_missed(rates: list[ExerciseRate]) -> list[ExerciseRate]:
    """Find the five exercises with the lowest pass rates in a class, hardest first.

    An exercise that every student passes is left out, so the list may be shorter or empty.
    """
    missed = [rate for rate in rates if rate.share is not None and rate.share < 1]
    return sorted(missed, key=_pass_share_then_points)[:MOST_MISSED]


def histogram(reports: Sequence[StudentReport]) -> list[Bin]:
    """Count the students of a class by score, in bins of 10 percent, for a histogram.

    A full score, or a higher one due to extra credit, goes into the last bin. Students without a
    score are not counted.
    """
    counts: Counter[int] = Counter()
    for report in reports:
        if report.score is not None and report.points:
            tenths = round(BINS * report.score / report.points, 6)
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
