"""Write a student's grade as results.json, in the format that Gradescope reads.

Gradescope calls an exercise a "test". The file contains only plain text, without HTML or Markdown,
and students do not see what the grader prints while it runs.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from autograder.checks.verdict import Verdict
from autograder.manifest import Exercise
from autograder.records import to_json
from autograder.reports.report import StudentReport, for_students
from autograder.reports.texts import check_title, clean_all, number, replace_file
from autograder.scores import Result, of_possible
from autograder.submissions.find import file_name
from autograder.text.clean import clean_line

BY_HAND = ("marked", "changed")
FORM = {
    "output_format": "text",
    "test_output_format": "text",
    "test_name_format": "text",
    "visibility": "visible",
    "stdout_visibility": "hidden",
}
OURS = "grader error, please retry: this is not the submission's fault and does not count as zero"


def write_gradescope(out: Path, report: StudentReport) -> Path:
    """Write a student's grade to gradescope/<student>/results.json, and return its path."""
    path = out / "gradescope" / file_name(report.student) / "results.json"
    replace_file(path, as_text(gradescope_results(report)))
    return path


def as_text(results: dict[str, Any]) -> str:
    """Convert a student's results to JSON, the format in which Gradescope reads them."""
    return json.dumps(to_json(results), indent=1, allow_nan=False) + "\n"


def gradescope_results(report: StudentReport) -> dict[str, Any]:
    """Convert a student's report to what Gradescope shows, without a score if the grader failed."""
    report = clean_all(for_students(report))
    if report.status == "nothing to grade":  # without a score, Gradescope would report an error
        summary = _summary(report, failed=False)
        return _results(summary, [], score=0.0, execution_time=report.seconds)
    failed = report.status != "graded" or report.score is None
    tests = [_test(result) for result in report.results]
    for cause in report.causes:
        needed = f"This earns no points here, but is needed for {', '.join(cause.blocks)}."
        output = "\n\n".join([needed, *_lost(cause.result.checks)])
        where = f" ({cause.assignment or 'not graded'})"
        tests.append({**_entry(cause.result.exercise, 0, output, where), "status": "failed"})
    score = None if failed else report.total
    summary = _summary(report, failed)
    return _results(summary, tests, score=score, execution_time=report.seconds)


def ungraded_results(reason: str) -> dict[str, Any]:
    """Build the results, without a score, for a submission that could not be graded."""
    return _results(f"{OURS}\n{clean_all(reason)}", [])


def _results(output: str, tests: list[dict[str, Any]], **numbers: float | None) -> dict[str, Any]:
    known = {name: number for name, number in numbers.items() if number is not None}
    return {"output": output, **FORM, "tests": tests, **known}


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


def _entry(exercise: Exercise, most: float, output: str, where: str = "") -> dict[str, Any]:
    return {
        "number": clean_line(exercise.id),
        "name": clean_line(exercise.title + where),
        "max_score": most,
        "output": output,
        "visibility": "visible",
    }


def _test(result: Result) -> dict[str, Any]:
    """Convert the result of an exercise, without a score if nobody has given one yet."""
    exercise, status = result.exercise, result.status
    most = 0 if exercise.extra else exercise.points  # they add up to the possible points
    entry = _entry(exercise, most, _output(result))
    if result.score is not None and status not in ("error", "waiting"):
        entry["score"] = result.score
        if status not in BY_HAND:  # people give no verdict
            entry["status"] = "passed" if status == "passed" else "failed"
    return entry


def _output(result: Result) -> str:
    """State the result of an exercise, and explain each check that did not pass."""
    status = result.status
    if status == "waiting":
        return f"waiting for a person to mark it: up to {number(result.exercise.points)} points"
    if status in BY_HAND:
        words = "marked by a person" + (", and changed since" if status == "changed" else "")
        return f"{words}\n{result.comment}".strip()
    blocks = [OURS] if status == "error" else []
    passing = ", ".join(f"{tier} {passed} of {of}" for tier, passed, of in result.tiers)
    blocks.append(f"{result.state}: {passing} checks pass")
    if status == "inherited":
        blocks.append("the mistake is in an earlier chapter: with given chapters this passes")
    if result.place:
        blocks.append(f"your work: {result.place}")
    return "\n\n".join([*blocks, *_lost(result.checks)])


def _lost(checks: Sequence[Verdict]) -> Iterator[str]:
    for check in checks:
        if check.status != "passed":
            title = "a hidden check" if check.hidden else check_title(check.name)
            tier = "robust, " if check.robust else ""
            yield f"{tier}{check.state}: {title}\n{check.message}".strip()
