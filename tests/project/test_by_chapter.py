"""`make test CH=6` runs the tests that are about chapter 6, and no others."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

import tiers
from autograder.manifest import ROOT, load_chapters
from by_chapter import chapters_of

CHAPTERS = load_chapters()


@pytest.mark.parametrize(
    ("file", "parameters", "chapters"),
    [
        ("ch06_springs/test_steps.py", {}, {6}),
        ("reference/test_links.py", {"name": "ch06"}, {7}),  # it also imports chapters 2, 5 and 6
        ("studies/test_charts_results.py", {}, {6}),  # because of the studies that it imports
        ("plots/test_engines.py", {}, {9}),  # because of the names in its text
        ("project/test_proofs.py", {"chapter": CHAPTERS[2]}, {4}),
        (
            "reference/everywhere/test_examples.py",
            {"path": ROOT / "solutions/ch05_forces/forces.py"},
            {5},
        ),
        ("project/test_structure.py", {}, set()),
        ("lab/test_scenes.py", {}, set()),  # it names no chapter
        ("web/test_site_solving.py", {"chapter": CHAPTERS[2]}, set()),
    ],
)
def test_a_test_is_about_the_chapter_of_its_parameters_or_of_its_file(
    file: str, parameters: dict[str, object], chapters: set[int]
) -> None:
    callspec = SimpleNamespace(params=parameters)
    item = SimpleNamespace(path=ROOT / "tests" / file, callspec=callspec)
    assert chapters_of(item) == chapters


@pytest.mark.parametrize(("chapter", "runs"), [(2, True), (None, False)])
def test_some_tests_are_slow_only_if_no_chapter_is_chosen(chapter: int | None, runs: bool) -> None:
    mark = pytest.mark.slow(but_for="chapter").mark
    path = ROOT / "tests/project/test_proofs.py"
    items: list[Any] = [SimpleNamespace(path=path, nodeid="", get_closest_marker=lambda _: mark)]
    options = {"tier": "quick", "chapter": chapter}
    config: Any = SimpleNamespace(
        getoption=lambda name, _=None: options[name],
        hook=SimpleNamespace(pytest_deselected=dict),
    )
    tiers.pytest_collection_modifyitems(config, items)
    assert bool(items) == runs
