"""Where only extra credit gives points, the pages and screens say so, and never "of 0 points"."""

from __future__ import annotations

import io
import re
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.analysis.items import histogram
from autograder.grader.class_run import print_class
from autograder.manifest import Exercise
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradescope import gradescope_results
from autograder.scores import Result
from autograder.student.screen import BAR, points_line
from autograder.text.wrapping import plain_console
from graded import CHAPTERS, class_of, report_of

HALF = f"[{'#' * (BAR // 2)}{'.' * (BAR // 2)}]"


def extra(exercise: Exercise) -> Exercise:
    return replace(exercise, extra=exercise.kind != "written")


# The checks can give 2 + 4 + 5 points, all of them extra credit, and the written answer 3 points.
EXTRA_CHAPTERS = [replace(c, exercises=[*map(extra, c.exercises)]) for c in CHAPTERS]
EXTRA_RESULTS = [replace(r, exercise=extra(r.exercise)) for r in report_of().results]
CHECKS = report_of(points=0, results=EXTRA_RESULTS)


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
    assert "of 0" not in page
    page = read(write_index(tmp_path, EXTRA_CHAPTERS, [CHECKS], class_of()))
    assert "Median score 3 of 11 as extra credit" in page
    assert [low for low, _, count in histogram([CHECKS]) if count] == [20], "3 of 11 points"
    assert "checks: 3 of 11 points of extra credit\n" in gradescope_results(CHECKS)["output"]
    screen = io.StringIO()
    print_class(plain_console(screen, 100), [CHECKS])
    assert " 3/11 extra " in screen.getvalue()
