"""The physics tier and the robust tier: which exercises have them, and what each one checks."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import Chapter, load_chapters
from plain import write_plain_engine

CHAPTERS = load_chapters()
REFUSING = "B2.11"  # the exercise that teaches refusal, and asks for nothing else


@pytest.fixture(scope="module")
def plain_engine(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    return write_plain_engine(tmp_path_factory.mktemp("plain"))


@pytest.fixture(scope="module", params=CHAPTERS, ids=lambda chapter: chapter.name)
def checked(
    request: pytest.FixtureRequest, plain_engine: list[Path]
) -> tuple[Chapter, list[Verdict]]:
    """Return a chapter, and the verdicts on an engine that refuses nothing."""
    return request.param, run_checks(request.param, plain_engine, seed="1")


def test_an_engine_that_refuses_nothing_has_all_of_the_physics(
    checked: tuple[Chapter, list[Verdict]],
) -> None:
    physics = [v for v in checked[1] if not v.robust and v.exercise != REFUSING]
    assert {v.name: v.message for v in physics if v.status != "passed"} == {}


def test_every_robust_tier_asks_for_more_than_the_physics(
    checked: tuple[Chapter, list[Verdict]],
) -> None:
    """Otherwise students would read about a tier that they pass without knowing it."""
    _, verdicts = checked
    robust = [verdict for verdict in verdicts if verdict.robust]
    lost = {verdict.exercise for verdict in robust if verdict.status != "passed"}
    assert lost == {verdict.exercise for verdict in robust}


def test_every_exercise_has_physics_and_the_manifest_says_why_wherever_there_are_robust_checks(
    checked: tuple[Chapter, list[Verdict]],
) -> None:
    chapter, verdicts = checked
    said = {exercise.id for exercise in chapter.exercises if exercise.robust}
    tested = {verdict.exercise for verdict in verdicts if verdict.robust}
    physics = {verdict.exercise for verdict in verdicts if not verdict.robust}
    assert physics == {verdict.exercise for verdict in verdicts}
    assert tested == said, f"add or remove robust in {chapter.name}/chapter.toml: {tested ^ said}"
