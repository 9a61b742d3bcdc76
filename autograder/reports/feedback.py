"""Write the web pages of a graded class: one per student, and an overview for the instructor.

The pages work offline and contain no scripts. A student's name, error messages and other text from
students are inserted as plain text, so they cannot change a page.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path
from urllib.parse import quote

from autograder.checks.verdict import Status
from autograder.manifest import Chapter
from autograder.reports.class_stats import causes_in, exercise_rates, histogram, most_missed
from autograder.reports.pages import render
from autograder.reports.report import (
    Cause,
    Chart,
    CheckReport,
    ExerciseReport,
    StudentReport,
    for_students,
    tiers,
)
from autograder.reports.scatter import Scatter, scatter
from autograder.reports.texts import check_title, clean_all, replace_file
from autograder.scores import PHYSICS_SHARE, extra_possible, place_on_chart, possible
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import file_name

SYMBOLS = {  # these stand beside the words, so that nobody has to tell a status by its color
    "passed": "✓",
    "failed": "✗",
    "blocked": "⊘",
    "inherited": "↑",
    "error": "!",
    "waiting": "…",
    "marked": "✎",
    "changed": "✎",
    "graded": "✓",
    "error, retry": "!",
    "nothing to grade": "∅",
}
MEANINGS = {
    "passed": "every check passes",
    "failed": "a check found a mistake in it",
    "blocked": "it builds on an exercise that fails: fix that one first",
    "inherited": "the mistake is in an earlier chapter: with given chapters it passes",
    "error": "the grader failed: this does not count as zero and will be graded again",
    "waiting": "a person still has to mark it",
    "marked": "a person has marked it",
    "changed": "it has changed since a person marked it, so the mark may be out of date",
}
TO_FIX = ("failed", "inherited", "blocked")  # students should fix these first to last


@dataclass
class LostChecks:
    """A group of failed checks of one exercise that all have the same message.

    A student's page shows the message only once, together with the titles of the checks. For
    example, a module that cannot be imported makes many checks fail in the same way. The titles of
    hidden checks are not shown. Such checks are only counted.
    """

    status: Status
    message: str
    hidden: bool
    robust: bool
    titles: list[str] = field(default_factory=list)
    count: int = 0


@dataclass(frozen=True, kw_only=True)
class ShownCause(Cause):
    """An exercise of an earlier assignment that blocks graded ones, as shown on a student's page.

    Attributes:
        lost: The failed checks, which are explained on the page.
    """

    anchor: str
    lost: list[LostChecks]


@dataclass(frozen=True, kw_only=True)
class ShownExercise(ExerciseReport):
    """A student's result on one exercise, prepared for the student's feedback page.

    Attributes:
        lost: The failed checks, which are explained on the page.
        passed: The titles of the checks that passed.
        gains: True if our solutions to earlier chapters would earn the student more points.
        uneven: True if some checks of the same kind (physics or robust) have different weights.
    """

    anchor: str
    scatter: Scatter | None
    place: str | None
    gains: bool
    uneven: bool
    tiers: list[tuple[str, int, int]]
    lost: list[LostChecks]
    passed: list[str]


def write_feedback(out: Path, report: StudentReport) -> Path:
    """Write a student's feedback page, feedback/<student>.html, and return its path.

    The page shows the points for each exercise, explains why checks failed, and says which exercise
    to fix first.
    """
    path = out / "feedback" / f"{file_name(report.student)}.html"
    report = clean_all(for_students(report))
    exercises = [_shown(i, e) for i, e in enumerate(report.exercises, start=1)]
    causes = [_shown_cause(i, cause) for i, cause in enumerate(report.causes, start=1)]
    shown: list[ShownExercise | ShownCause] = [*exercises, *causes]
    states = {e.status for e in shown} | {g.status for e in shown for g in e.lost}
    own, given, first = report.score, report.score_on_given, report.first_cause
    page = render(
        "student.html",
        symbols=SYMBOLS,
        report=report,
        chapters=[(n, list(group)) for n, group in groupby(exercises, lambda e: e.chapter)],
        inherited=None if own is None or given is None else round(given - own, 2),
        by_hand_points=_possible([e for e in exercises if e.kind == "written"]),
        by_hand_extra=sum(e.points for e in exercises if e.kind == "written" and e.extra),
        possible=_possible(exercises),
        waiting=[e.id for e in exercises if e.status == "waiting"],
        causes=causes,
        cause=next((cause for cause in causes if cause.id == first.id), None) if first else None,
        next=_first_to_fix(exercises),
        physics_percent=round(100 * PHYSICS_SHARE),
        meanings=[(state, text) for state, text in MEANINGS.items() if state in states],
    )
    replace_file(path, page)
    return path


def write_index(
    out: Path,
    chapters: list[Chapter],
    reports: Sequence[StudentReport],
    people: ClassList,
) -> Path:
    """Write index.html, the instructor's overview of a graded class, and return its path."""
    path = out / "index.html"
    links = [f"feedback/{quote(file_name(report.student))}.html" for report in reports]
    clean = [clean_all(for_students(report)) for report in reports]
    rates = exercise_rates(chapters, clean)
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = [exercise for exercise in exercises if exercise.kind == "written"]
    by_hand_points, by_hand_extra = possible(written), extra_possible(written)
    scores = [report.score for report in clean if report.score is not None]
    page = render(
        "index.html",
        symbols=SYMBOLS,
        reports=[*zip(clean, links, strict=True)],
        missing=people.absent,
        unmatched=people.unmatched,
        nothing=[report for report in clean if report.nothing],
        changed=[(r, e.id) for r in clean for e in r.exercises if e.status == "changed"],
        chapters=chapters,
        late=any(report.late for report in clean),
        errors=sum(report.status == "error, retry" for report in clean),
        points=round(possible(exercises) - by_hand_points, 2),
        extra=round(extra_possible(exercises) - by_hand_extra, 2),
        by_hand_points=by_hand_points,
        by_hand_extra=by_hand_extra,
        median=statistics.median(scores) if scores else None,
        waiting=sum(report.waiting for report in clean),
        seeds=_distinct(report.seed for report in clean),
        isolations=_distinct(report.isolation for report in clean),
        bins=histogram(clean),
        missed=most_missed(rates),
        causes=causes_in(clean),
        charts=_charts(clean),
        rates_of_chapters=[(c, [r for r in rates if r.exercise in c.exercises]) for c in chapters],
    )
    replace_file(path, page)
    return path


def _shown(number_on_page: int, exercise: ExerciseReport) -> ShownExercise:
    checks, chart = exercise.checks, exercise.chart
    own, given = exercise.score, exercise.score_on_given
    return ShownExercise(
        **vars(exercise),
        anchor=f"exercise-{number_on_page}",
        scatter=scatter(exercise, chart, [("yours", chart.own)]) if chart else None,
        place=place_on_chart(chart.axes, chart.own) if chart else None,
        gains=own is not None and given is not None and given > own,
        uneven=len({(check.robust, check.weight) for check in checks}) > len(tiers(checks)),
        tiers=tiers(checks),
        lost=_groups([check for check in checks if check.status != "passed"]),
        passed=[
            "hidden check" if check.hidden else check_title(check.name)
            for check in checks
            if check.status == "passed"
        ],
    )


def _shown_cause(number_on_page: int, cause: Cause) -> ShownCause:
    lost = _groups([check for check in cause.checks if check.status != "passed"])
    return ShownCause(**vars(cause), anchor=f"earlier-{number_on_page}", lost=lost)


def _first_to_fix(exercises: list[ShownExercise]) -> ShownExercise | None:
    """Return the exercise that the student should fix first, or None if every exercise passes.

    Exercises whose physics checks fail come before those that fail only robust checks. Robust
    checks try, for example, invalid arguments.
    """

    def urgency(exercise: ShownExercise) -> tuple[bool, int]:
        works = all(passed == of for tier, passed, of in exercise.tiers if tier == "physics")
        return works, TO_FIX.index(exercise.status)

    return min((e for e in exercises if e.status in TO_FIX), key=urgency, default=None)


def _charts(reports: Sequence[StudentReport]) -> list[Scatter]:
    """Lay out a chart for each open exercise, with a dot for every student of the class.

    An open exercise has more than one good answer, so the chart plots the error of each solution
    against its cost. An exercise gets no chart if no student's solution could be measured.
    """
    found: dict[str, tuple[ExerciseReport, Chart]] = {}
    named: dict[str, list[tuple[str, Sequence[float]]]] = {}
    for report in reports:
        for exercise in report.exercises:
            if chart := exercise.chart:
                found.setdefault(exercise.id, (exercise, chart))
                named.setdefault(exercise.id, []).append((report.student, chart.own))
    return [scatter(exercise, chart, named[key]) for key, (exercise, chart) in found.items()]


def _possible(exercises: Sequence[ExerciseReport]) -> float:
    """Add up the points that the given exercises are worth, without extra credit.

    A student with extra credit can earn more than this total.
    """
    return round(sum(e.points for e in exercises if not e.extra), 2)


def _groups(checks: list[CheckReport]) -> list[LostChecks]:
    """Group an exercise's failed checks by message, so that the student reads each message once.

    For example, a file that cannot be read makes many checks fail with the same message.
    """
    groups: dict[tuple[Status, str, bool, bool], LostChecks] = {}
    for check in checks:
        shared = check.status, str(check.message), check.hidden, check.robust
        group = groups.setdefault(shared, LostChecks(*shared))
        group.count += 1
        if not check.hidden:
            group.titles.append(check_title(check.name))
    return list(groups.values())


def _distinct(values: Iterable[str]) -> list[str]:
    return list(dict.fromkeys(values))
