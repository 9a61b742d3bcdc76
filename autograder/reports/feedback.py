"""Write the web pages of a graded class: one per student, and an overview for the instructor.

The pages work offline and contain no scripts.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any
from urllib.parse import quote

from autograder.analysis.items import causes_in, histogram, items_of, most_missed
from autograder.checks.verdict import Status, Verdict
from autograder.manifest import Chapter, Exercise
from autograder.reports.chart import draw_chart, front
from autograder.reports.pages import render
from autograder.reports.report import StudentReport, for_students
from autograder.reports.texts import clean_all, replace_file
from autograder.scores import PHYSICS_SHARE, Result, extra_possible, possible
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import file_name

TO_FIX = ("failed", "inherited", "blocked")  # students should fix these first to last


def write_feedback(out: Path, report: StudentReport) -> Path:
    """Write a student's feedback page, feedback/<student>.html, and return its path."""
    path = out / "feedback" / f"{file_name(report.student)}.html"
    report = clean_all(for_students(report))
    results = report.results
    every = [*results, *(cause.result for cause in report.causes)]
    lost = {r.exercise.id: _lost(r.checks) for r in every}
    states = {r.state for r in every} | {c[0].state for groups in lost.values() for c in groups}
    own, given = report.score, report.score_on_given
    exercises = [result.exercise for result in results]
    written = [exercise for exercise in exercises if exercise.kind == "written"]
    page = render(
        "student.html",
        report=report,
        chapters=[(n, list(group)) for n, group in groupby(results, lambda r: r.chapter)],
        anchors={r.exercise.id: f"exercise-{i}" for i, r in enumerate(every, start=1)},
        lost_of=lost,
        uneven=[r.exercise.id for r in results if _is_uneven(r)],
        charts={
            r.exercise.id: draw_chart(
                r.exercise.chart, [r.on_chart], r.reference, f"Your work: {r.place}"
            )
            for r in results
            if r.on_chart
        },
        inherited=None if own is None or given is None else round(given - own, 2),
        by_hand_points=possible(written),
        by_hand_extra=extra_possible(written),
        possible=possible(exercises),
        waiting=[r.exercise.id for r in results if r.status == "waiting"],
        next=_first_to_fix(results),
        physics_percent=round(100 * PHYSICS_SHARE),
        states=states,
    )
    replace_file(path, page)
    return path


def write_index(
    out: Path, chapters: list[Chapter], reports: Sequence[StudentReport], people: ClassList
) -> Path:
    """Write index.html, the instructor's overview of a graded class, and return its path."""
    path = out / "index.html"
    links = [f"feedback/{quote(file_name(report.student))}.html" for report in reports]
    clean = [clean_all(for_students(report)) for report in reports]
    items = [(chapter, items_of(chapter, clean)) for chapter in chapters]
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    written = [exercise for exercise in exercises if exercise.kind == "written"]
    by_hand_points, by_hand_extra = possible(written), extra_possible(written)
    scores = [report.score for report in clean if report.score is not None]
    page = render(
        "index.html",
        reports=[*zip(clean, links, strict=True)],
        absent=people.absent,
        unmatched=people.unmatched,
        nothing=[report for report in clean if report.nothing],
        changed=[(report, exercise) for report in clean for exercise in report.changed],
        chapters=chapters,
        late=any(report.late for report in clean),
        errors=sum(report.status == "error, retry" for report in clean),
        points=round(possible(exercises) - by_hand_points, 2),
        extra=round(extra_possible(exercises) - by_hand_extra, 2),
        by_hand_points=by_hand_points,
        by_hand_extra=by_hand_extra,
        median=statistics.median(scores) if scores else None,
        waiting=sum(report.waiting for report in clean),
        seeds=[*dict.fromkeys(report.seed for report in clean)],
        isolations=[*dict.fromkeys(report.isolation for report in clean)],
        bins=histogram(clean),
        missed=most_missed([item for _, some in items for item in some]),
        causes=causes_in(clean),
        charts=[*_charts_of_class(exercises, clean)],
        items=items,
    )
    replace_file(path, page)
    return path


def _lost(checks: Sequence[Verdict]) -> list[list[Verdict]]:
    """Group the checks that did not pass by message, so that the student reads each one once."""
    groups: dict[tuple[Status, str, bool, bool], list[Verdict]] = {}
    for check in checks:
        if check.status != "passed":
            shared = check.status, str(check.message), check.hidden, check.robust
            groups.setdefault(shared, []).append(check)
    return list(groups.values())


def _is_uneven(result: Result) -> bool:
    """Return True if checks of the same kind, physics or robust, have different weights."""
    return len({(check.robust, check.weight) for check in result.checks}) > len(result.tiers)


def _first_to_fix(results: list[Result]) -> Result | None:
    """Return the exercise to fix first, by its physics and then by its status, or None."""
    open_ones = [result for result in results if result.status in TO_FIX]
    return min(open_ones, key=lambda r: (r.works, TO_FIX.index(r.status)), default=None)


def _charts_of_class(
    exercises: Sequence[Exercise], reports: Sequence[StudentReport]
) -> Iterator[dict[str, Any]]:
    """Draw and list the measured solutions of a class to each open exercise, the best one first."""
    for exercise in exercises:
        found = {
            report.student: result
            for report in reports
            for result in report.results
            if result.exercise.id == exercise.id and result.on_chart
        }
        points = [result.on_chart for result in found.values() if result.on_chart]
        if points:
            (cost, error), reference = exercise.chart, next(iter(found.values())).reference
            best = front([*points, *([reference] if reference else [])])
            rows = [(*xy, name, xy in best) for name, xy in zip(found, points, strict=True)]
            rows.sort(key=lambda row: (row[1], *row))
            what = f"The class by {error} over {cost}; the table lists every number"
            svg = draw_chart(exercise.chart, points, reference, what)
            yield {"exercise": exercise, "svg": svg, "rows": rows}
