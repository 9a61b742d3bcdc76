"""The physics tier and the robust tier: which exercises have them, and what each one checks."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.manifest import Chapter, load_chapters
from plain import write_plain_engine

CHAPTERS = load_chapters()
REFUSING = "B2.11"  # the exercise that teaches refusal, and asks for nothing else


@pytest.fixture(scope="module")
def plain_engine(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    return write_plain_engine(tmp_path_factory.mktemp("plain"))


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_an_engine_that_refuses_nothing_has_the_physics_and_lacks_every_robust_tier(
    chapter: Chapter, plain_engine: list[Path]
) -> None:
    """Otherwise students would read about a tier that they pass without knowing it."""
    verdicts = run_checks(chapter, plain_engine, seed="1")
    physics = [verdict for verdict in verdicts if not verdict.robust]
    assert {verdict.exercise for verdict in physics} == {verdict.exercise for verdict in verdicts}
    lost = {v.name: v.message for v in physics if v.status != "passed" and v.exercise != REFUSING}
    assert lost == {}
    robust = [verdict for verdict in verdicts if verdict.robust]
    tested = {verdict.exercise for verdict in robust}
    assert tested == {verdict.exercise for verdict in robust if verdict.status != "passed"}
    said = {exercise.id for exercise in chapter.exercises if exercise.robust}
    assert tested == said, f"add or remove robust in {chapter.name}/chapter.toml: {tested ^ said}"
