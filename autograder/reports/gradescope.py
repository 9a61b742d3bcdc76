"""Write a student's grade as results.json, in the format that Gradescope reads."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from autograder.records import to_json
from autograder.reports.report import (
    Cause,
    CheckReport,
    ExerciseReport,
    StudentReport,
    for_students,
    tiers,
)
from autograder.reports.texts import check_title, clean_all, number, replace_file
from autograder.scores import of_possible, place_on_chart
from autograder.submissions.find import file_name
from autograder.text.clean import clean_line

BY_HAND = ("marked", "changed")
OURS = "grader error, please retry: this is not the submission's fault and does not count as zero"


@dataclass(frozen=True)
class ExerciseResult:
    """The result of one exercise in Gradescope's format, which calls an exercise a "test".

    The score is None if grading failed, or if an instructor still has to mark the answer.
    """

    number: str
    name: str
    max_score: float
    output: str
    visibility: Literal["visible"]
    score: float | None = None
    status: Literal["passed", "failed"] | None = None


@dataclass(frozen=True)
class GradescopeResults:
    """The contents of results.json, the file from which Gradescope shows a student's grade.

    The file contains only plain text, without HTML or Markdown. Students do not see what the grader
    prints while it runs.
    """

    output: str
    output_format: Literal["text"]
    test_output_format: Literal["text"]
    test_name_format: Literal["text"]
    visibility: Literal["visible"]
    stdout_visibility: Literal["hidden"]
    tests: list[ExerciseResult]
    score: float | None = None
    execution_time: float | None = None


def write_gradescope(out: Path, report: StudentReport) -> Path:
    """Write a student's grade to a JSON file for Gradescope, and return the path of the file.

    The path is gradescope/<student>/results.json inside ``out``.
    """
    path = out / "gradescope" / file_name(report.student) / "results.json"
    replace_file(path, as_text(gradescope_results(report)))
    return path


def as_text(results: GradescopeResults) -> str:
    """Convert a student's results to JSON, the format in which Gradescope reads them."""
    return json.dumps(to_json(results), indent=1, allow_nan=False) + "\n"


def gradescope_results(report: StudentReport) -> GradescopeResults:
    """Convert a student's report to Gradescope's format, in which an exercise is called a "test".

    If the grader itself failed, the submission gets no score at all, because neither zero nor full
    marks would be fair.
    """
    report = clean_all(for_students(report))
    if report.status == "nothing to grade":  # without a score, Gradescope would report an error
        return _results(_summary(report, failed=False), [], 0.0, report.seconds)
    failed = report.status != "graded" or report.score is None
    return _results(
        _summary(report, failed),
        [
            *(_exercise_result(exercise) for exercise in report.exercises),
            *(_cause_result(cause) for cause in report.causes),
        ],
        score=None if failed or report.total is None else round(report.total, 2),
        execution_time=report.seconds,
    )


def ungraded_results(reason: str) -> GradescopeResults:
    """Build the results for a submission that could not be graded.

    The submission gets no score. Instead, Gradescope shows the student the reason, and a note that
    the submission is not at fault.
    """
    return _results(f"{OURS}\n{clean_all(reason)}", [])


def _results(
    output: str,
    tests: list[ExerciseResult],
    score: float | None = None,
    execution_time: float | None = None,
) -> GradescopeResults:
    return GradescopeResults(
        output=output,
        output_format="text",
        test_output_format="text",
        test_name_format="text",
        visibility="visible",
        stdout_visibility="hidden",
        tests=tests,
        score=score,
        execution_time=execution_time,
    )


def _summary(report: StudentReport, failed: bool) -> str:
    lines = [OURS] if failed else []
    if report.nothing:
        lines.append(f"nothing to grade: {report.nothing}")
    elif not failed:
        lines.append(f"checks: {of_possible(report.score, report.points, report.extra)}")
    if cause := report.first_cause:
        lines.append(f"{cause.name} {cause.advice}")
    if report.score_on_given is not None:
        lines.append(
            f"on given chapters: {number(report.score_on_given)} points, with the reference's "
            "earlier chapters in place of your own"
        )
    if report.by_hand is not None:
        lines.append(f"by hand: {number(report.by_hand)} points")
    if report.waiting:
        lines.append(f"waiting for a person: {number(report.waiting)} points")
    if report.late:
        lines.append(f"late penalty: {number(report.penalty)} points. {report.about_lateness}")
        earned, total = number(report.earned), number(report.total)
        lines.append(f"total: {earned} - {number(report.penalty)} = {total} points")
    lines += [f"note: {clean_line(note)}" for note in report.notes]
    lines.append(f"seed: {clean_line(report.seed)}")
    lines.append(f"isolation: {clean_line(report.isolation)}")
    return "\n".join(lines)


def _exercise_result(exercise: ExerciseReport) -> ExerciseResult:
    status = exercise.status
    has_score = exercise.score is not None and status not in ("error", "waiting")
    verdict: Literal["passed", "failed"] = "passed" if status == "passed" else "failed"
    return ExerciseResult(
        number=clean_line(exercise.id),
        name=clean_line(exercise.title),
        max_score=0 if exercise.extra else exercise.points,  # they add up to the possible points
        output=_output(exercise),
        visibility="visible",
        score=exercise.score if has_score else None,
        status=verdict if has_score and status not in BY_HAND else None,  # people give no verdict
    )


def _cause_result(cause: Cause) -> ExerciseResult:
    """Convert an exercise of an earlier assignment that blocks graded ones, and earns no points."""
    needed = f"This earns no points here, but is needed for {', '.join(cause.blocks)}."
    return ExerciseResult(
        number=clean_line(cause.id),
        name=clean_line(f"{cause.title} ({cause.assignment or 'not graded'})"),
        max_score=0,
        output="\n\n".join([needed, *_lost(cause.checks)]),
        visibility="visible",
        status="failed",
    )


def _output(exercise: ExerciseReport) -> str:
    """Write the text that Gradescope shows below an exercise.

    The text states the result of the exercise, and explains each check that did not pass.
    """
    status, checks = exercise.status, exercise.checks
    if status == "waiting":
        return f"waiting for a person to mark it: up to {number(exercise.points)} points"
    if status in BY_HAND:
        words = "marked by a person" + (", and changed since" if status == "changed" else "")
        return f"{words}\n{exercise.comment}".strip()
    blocks = [OURS] if status == "error" else []
    passing = ", ".join(f"{tier} {passed} of {of}" for tier, passed, of in tiers(checks))
    blocks.append(f"{status}: {passing} checks pass")
    if status == "inherited":
        blocks.append("the mistake is in an earlier chapter: with given chapters this passes")
    if chart := exercise.chart:
        blocks.append(f"your work: {place_on_chart(chart.axes, chart.own)}")
    return "\n\n".join([*blocks, *_lost(checks)])


def _lost(checks: Sequence[CheckReport]) -> Iterator[str]:
    """Explain each of the checks that did not pass."""
    for check in checks:
        if check.status != "passed":
            title = "a hidden check" if check.hidden else check_title(check.name)
            tier = "robust, " if check.robust else ""
            yield f"{tier}{check.status}: {title}\n{check.message}".strip()
