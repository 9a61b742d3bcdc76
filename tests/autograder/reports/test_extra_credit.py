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
from autograder.message import Message
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradescope import gradescope_results
from autograder.reports.report import StudentReport
from autograder.scores import Result
from autograder.student.screen import BAR, points_line
from autograder.text.wrapping import plain_console
from graded import CHAPTERS, check, class_of, report_of, with_exercise

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
    assert " 3/11 extra " in printed(100, CHECKS)


def printed(width: int, *reports: StudentReport) -> str:
    """Return what an instructor sees of a class on a screen of some width."""
    screen = io.StringIO()
    print_class(plain_console(screen, width), [*reports])
    return screen.getvalue()


@pytest.mark.parametrize("width", [80, 300])
def test_a_student_takes_two_lines_at_most_on_the_screen(width: int) -> None:
    words = ("Your method creates a new vector. " * 5).strip()
    checks = [check("test_angle", "failed", Message(likely=words, wanted="1"))]
    long = report_of("Anna Maria Schmidt-Hohenberg und zu Neustadt (7036)", points=95.65)
    long = with_exercise(replace(long, score=113.04), 1, checks=checks)
    screen = printed(width, long, report_of("bob"))
    rows = screen.splitlines()[3:-1]
    assert next(i for i, row in enumerate(rows) if row.strip().startswith("bob")) == 2
    assert max(map(len, rows)) <= width
    assert "2.2: Your method" in rows[0]
    assert (words in rows[0]) == (width == 300)
    assert ("..." in rows[1].rpartition("  ")[2]) == (width == 80)
    assert " 113.04/95.65 " in screen, "rescaled points are whole"
