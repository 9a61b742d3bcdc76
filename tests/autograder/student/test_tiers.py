"""The two tiers of an exercise: the physics unlocks and earns most, the robust checks the rest."""

from __future__ import annotations

import re
import shutil
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
from graded import check, exercise_of, report_of
from small import CHECKS, RIGHT, make_root

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
def chapter(tmp_path: Path) -> Chapter:
    """A small chapter whose first exercise has a robust check above a physics one."""
    root = make_root(tmp_path / "root")
    (root / "tests/ch90_small/test_small.py").write_text(CHECKS + REFUSES, encoding="utf-8")
    return load_chapter(root / "chapters/ch90_small")


def verdicts_of(chapter: Chapter, tmp_path: Path, code: str) -> list[Verdict]:
    engine = tmp_path / "engine"
    shutil.rmtree(engine, ignore_errors=True)
    (engine / chapter.name).mkdir(parents=True)
    (engine / chapter.name / "small.py").write_text(code, encoding="utf-8")
    return run_checks(chapter, [engine], seed="1", root=tmp_path / "root")


def results_by_id(chapter: Chapter, tmp_path: Path, code: str) -> dict[str, Result]:
    results = results_of(chapter, verdicts_of(chapter, tmp_path, code))
    return {result.exercise.id: result for result in results}


def test_the_physics_of_an_exercise_runs_before_its_robust_checks(
    chapter: Chapter, tmp_path: Path
) -> None:
    names = [verdict.name for verdict in verdicts_of(chapter, tmp_path, RIGHT)]
    assert names.index("test_double_of_minus_one") < names.index("test_a_text_is_refused")
    assert names.index("test_a_text_is_refused") < names.index("test_quadruple")


def test_physics_alone_earns_85_percent_and_unlocks_what_builds_on_it(
    chapter: Chapter, tmp_path: Path
) -> None:
    results = results_by_id(chapter, tmp_path, RIGHT)
    assert results["B90.1"].score == pytest.approx(0.85 * 4)
    assert results["B90.1"].status == "failed"
    assert results["B90.1"].works
    assert results["90.1"].status == "passed"


def test_only_failing_physics_blocks_what_builds_on_it(chapter: Chapter, tmp_path: Path) -> None:
    wrong = RIGHT.replace("return 4 * x", "return 5 * x")
    assert results_by_id(chapter, tmp_path, wrong)["90.1"].status == "failed"
    both_wrong = wrong.replace("return x + x", "return 3 * x")
    assert results_by_id(chapter, tmp_path, both_wrong)["90.1"].status == "blocked"


@pytest.mark.parametrize(
    ("passing", "points"), [("", 0.0), ("physics", 8.5), ("robust", 1.5), ("physics robust", 10.0)]
)
def test_points_by_tier_whatever_the_number_of_checks(passing: str, points: float) -> None:
    exercise = exercise_of("B90.1", "Double", "build", 10)
    tiers = {"physics": 1, "robust": 7}
    checks = [
        Verdict(
            f"{tier} {number}",
            exercise.id,
            0.5 if tier == "robust" else 1,
            "passed" if tier in passing else "failed",
            "",
            robust=tier == "robust",
        )
        for tier, count in tiers.items()
        for number in range(count)
    ]
    assert result_of(exercise, checks).score == pytest.approx(points)
    alone = [check for check in checks if check.robust]
    assert result_of(exercise, alone).score == (10.0 if "robust" in passing else 0.0)


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
    exercise = exercise_of("B3.1", "Mass", "build", 5)
    checks = [
        Verdict("a", exercise.id, 1, physics, ""),
        Verdict("b", exercise.id, 1, robust, "", robust=True),
    ]
    assert result_of(exercise, checks).status == status


def test_the_screen_shows_physics_before_robust_checks(
    chapter: Chapter, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = RIGHT.replace("return 4 * x", "return 5 * x")
    report = ChapterResults(chapter, list(results_by_id(chapter, tmp_path, wrong).values()), [], [])
    engine = [tmp_path / "engine"]
    assert not print_report([report], None, engine, [])
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
