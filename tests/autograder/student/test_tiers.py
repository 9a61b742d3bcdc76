"""The two tiers of an exercise: the physics unlocks and earns most, the robust checks the rest."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import Chapter, load_chapter
from autograder.reports.feedback import write_feedback
from autograder.reports.gradescope import gradescope_results
from autograder.scores import Result, result_of, results_of
from autograder.student.chapter_results import ChapterResults
from autograder.student.screen import print_report
from copies import edit
from graded import check, exercise_of, report_of
from small import CHECKS, RIGHT, hand_in

REFUSES = """

@pytest.mark.exercise("B90.1")
@pytest.mark.robust
def test_a_text_is_refused():
    with pytest.raises(TypeError):
        small.double("2")


@pytest.mark.exercise("B90.1")
def test_double_of_minus_one():
    assert small.double(-1) == -2, "double of minus one is minus two"
"""


@pytest.fixture
def chapter(root: Path) -> Chapter:
    """A small chapter whose first exercise has a robust check above a physics one."""
    (root / "tests/ch90_small/test_small.py").write_text(CHECKS + REFUSES, encoding="utf-8")
    return load_chapter(root / "chapters/ch90_small")


@pytest.fixture
def results_by_id(chapter: Chapter, root: Path) -> Callable[..., dict[str, Result]]:
    def run(*changes: str) -> dict[str, Result]:
        shutil.rmtree(root / "engine", ignore_errors=True)
        hand_in(root, "engine", RIGHT)
        edit(root / "engine/ch90_small/small.py", *changes)
        verdicts = run_checks(chapter, [root / "engine"], seed="1", root=root)
        return {result.exercise.id: result for result in results_of(chapter, verdicts)}

    return run


QUINTUPLE, TRIPLE = ("return 4 * x", "return 5 * x"), ("return x + x", "return 3 * x")


def test_physics_comes_first_earns_85_percent_and_unlocks_what_builds_on_it(
    results_by_id: Callable[..., dict[str, Result]],
) -> None:
    results = results_by_id()
    names = [check.name for check in results["B90.1"].checks]
    assert names.index("test_double_of_minus_one") < names.index("test_a_text_is_refused")
    assert results["B90.1"].score == pytest.approx(0.85 * 4)
    assert results["B90.1"].status == "failed"
    assert results["B90.1"].works
    assert results["90.1"].status == "passed"


def test_only_failing_physics_blocks_what_builds_on_it(
    results_by_id: Callable[..., dict[str, Result]],
) -> None:
    assert results_by_id(*QUINTUPLE)["90.1"].status == "failed"
    assert results_by_id(*QUINTUPLE, *TRIPLE)["90.1"].status == "blocked"


def verdict(tier: str, status: str, weight: float = 1.0) -> Verdict:
    return Verdict(f"test_{tier}", "B90.1", weight, status, "", robust=tier == "robust")


EXERCISE = exercise_of("B90.1", "Double", "build", 10)


@pytest.mark.parametrize(
    ("passing", "points"), [("", 0.0), ("physics", 8.5), ("robust", 1.5), ("physics robust", 10.0)]
)
def test_points_by_tier_whatever_the_number_of_checks(passing: str, points: float) -> None:
    physics, robust = ("passed" if tier in passing else "failed" for tier in ("physics", "robust"))
    alone = [verdict("robust", robust, 0.5)] * 7
    assert result_of(EXERCISE, [verdict("physics", physics), *alone]).score == pytest.approx(points)
    assert result_of(EXERCISE, alone).score == (10.0 if "robust" in passing else 0.0)


@pytest.mark.parametrize(
    ("physics", "robust", "status"),
    [
        ("inherited", "failed", "inherited"),
        ("blocked", "failed", "blocked"),
        ("passed", "failed", "failed"),
        ("passed", "passed", "passed"),
    ],
)
def test_an_exercise_is_in_the_state_of_its_physics_first(
    physics: str, robust: str, status: str
) -> None:
    checks = [verdict("physics", physics), verdict("robust", robust)]
    assert result_of(EXERCISE, checks).status == status


def test_the_screen_shows_physics_before_robust_checks(
    chapter: Chapter,
    results_by_id: Callable[..., dict[str, Result]],
    root: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    report = ChapterResults(chapter, [*results_by_id(*QUINTUPLE).values()], [], [])
    assert not print_report([report], None, [root / "engine"], [])
    screen = capsys.readouterr().out
    assert re.search(r"B90\.1 .* works +3/3 +0/1 +3\.4/4", screen)
    assert re.search(r"90\.1 .* failed +1/2 +1/2", screen)
    assert "quadruple must quadruple" in screen
    assert "test_a_text_is_refused" not in screen


def test_reports_show_both_tiers(tmp_path: Path) -> None:
    report = report_of()
    report.results[1].checks.append(check("test_refuses", "failed", "got 1", robust=True))
    page = write_feedback(tmp_path, report).read_text(encoding="utf-8")
    assert "physics 1 of 3, robust 0 of 1" in page
    told = gradescope_results(report)["tests"][1]["output"]
    assert "physics 1 of 3, robust 0 of 1" in told
    assert "robust, failed: refuses" in told
