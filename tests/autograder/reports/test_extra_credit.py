"""Where only extra credit gives points, the pages and screens say so, and never "of 0 points"."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.analysis.items import histogram
from autograder.grader.class_run import print_class
from autograder.manifest import Chapter, Exercise
from autograder.message import Message
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradescope import gradescope_results
from autograder.reports.report import StudentReport
from autograder.scores import Result
from autograder.student.screen import BAR, points_line
from autograder.text.wrapping import plain_console
from graded import CHAPTERS, check, class_of, report_of, with_exercise

HALF = f"[{'#' * (BAR // 2)}{'.' * (BAR // 2)}]"


def with_extra(
    report: StudentReport, is_extra: Callable[[Exercise], bool]
) -> tuple[StudentReport, list[Chapter]]:
    """Return a report and its chapters, in which some exercises are extra credit."""
    chapters = [
        replace(c, exercises=[replace(e, extra=is_extra(e)) for e in c.exercises]) for c in CHAPTERS
    ]
    results = [
        replace(r, exercise=replace(r.exercise, extra=is_extra(r.exercise))) for r in report.results
    ]
    return replace(report, results=results), chapters


# The checks can give 2 + 4 + 5 points, and the written answer 3 points.
CHECKS, CHAPTERS_OF_CHECKS = with_extra(report_of(points=0), lambda e: e.kind != "written")
ANSWERS, CHAPTERS_OF_ANSWERS = with_extra(report_of(by_hand=2.0), lambda e: e.kind == "written")


def result(score: float | None, kind: str = "build", **options: bool) -> Result:
    exercise = Exercise("B2.1", "Copy", kind, 1, 4, [], [], **options)  # type: ignore[arg-type]
    return Result(exercise, "passed", score, [])


@pytest.mark.parametrize(
    ("results", "line"),
    [
        ([result(2.0, extra=True)], f"{HALF} 2 of 4 points of extra credit"),
        ([result(2.0), result(3.0, extra=True)], f"[{'#' * BAR}] 5 of 4 points"),
        ([result(2.0, optional=True)], "Optional exercises earn no points."),
        ([result(None, "written")], "Points for written answers, marked by a person: 4"),
        (
            [result(None, "written", extra=True)],
            "Points for written answers, marked by a person: 4",
        ),
        (
            [result(2.0, extra=True), result(None, "written")],
            f"{HALF} 2 of 4 points of extra credit, plus 4 for written answers, marked by a person",
        ),
    ],
)
def test_a_student_sees_which_points_there_are(results: list[Result], line: str) -> None:
    assert points_line(results) == line


def test_pages_files_and_screens_name_extra_credit(tmp_path: Path) -> None:
    def read(path: Path) -> str:
        return re.sub("<[^>]*>", "", path.read_text(encoding="utf-8"))

    page = read(write_feedback(tmp_path, CHECKS))
    assert "3 of 11 as extra credit" in page
    assert "8 of 11 as extra credit" in page
    assert "of 0" not in page
    assert "2 of 3 as extra credit" in read(write_feedback(tmp_path, ANSWERS))
    page = read(write_index(tmp_path, CHAPTERS_OF_CHECKS, [CHECKS], class_of()))
    assert "of 11 as extra credit by checks and 3 by hand" in page
    assert "Median score 3 of 11 as extra credit" in page
    assert [low for low, _, count in histogram([CHECKS]) if count] == [20], "3 of 11 points"
    page = read(write_index(tmp_path, CHAPTERS_OF_ANSWERS, [ANSWERS], class_of()))
    assert "of 11 by checks and 3 as extra credit by hand" in page
    assert "checks: 3 of 11 points of extra credit\n" in gradescope_results(CHECKS)["output"]
    assert " 3/11 extra " in printed(100, CHECKS)


def printed(width: int, *reports: StudentReport) -> str:
    """Return what an instructor sees of a class on a screen of some width."""
    screen = io.StringIO()
    print_class(plain_console(screen, width), [*reports])
    return screen.getvalue()


@pytest.mark.parametrize("width", [80, 300])
def test_a_student_takes_two_lines_at_most_on_the_screen(width: int) -> None:
    words = "Your method creates a new vector. " * 5
    long = report_of("Anna Maria Schmidt-Hohenberg und zu Neustadt (7036)")
    checks = [check("test_angle", "failed", Message(likely=words.strip(), wanted="1"))]
    long = with_exercise(long, 1, checks=checks)
    rows = printed(width, long, report_of("bob")).splitlines()[3:-1]
    assert next(i for i, row in enumerate(rows) if row.strip().startswith("bob")) == 2
    assert max(map(len, rows)) <= width
    assert "2.2: Your method" in rows[0]
    assert (words.strip() in rows[0]) == (width == 300)
    assert ("..." in rows[1].rpartition("  ")[2]) == (width == 80)


def test_points_and_states_of_a_rescaled_assignment_are_whole_on_a_narrow_screen() -> None:
    failed = [check("test_angle", "failed", Message(likely="wrong"))]
    report = with_exercise(report_of("Anna Schmidt (7004)"), 1, checks=failed)
    rescaled = replace(report, score=113.04, score_on_given=113.04, points=95.65)
    screen = printed(80, rescaled, replace(rescaled, status="nothing to grade"))
    assert screen.count(" 113.04/95.65 ") == 2
    assert "…" not in screen
