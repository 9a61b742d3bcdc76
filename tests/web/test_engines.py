"""The page's engines say what `make check` says, though Python runs in WebAssembly there."""

from __future__ import annotations

import pytest

from autograder.manifest import Chapter, load_chapters
from copies import reference
from in_node import NodeEngines, engines

CHAPTERS = load_chapters()
REFERENCE = reference()

engines = pytest.fixture(scope="module")(engines)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_the_reference_earns_all_points(engines: NodeEngines, chapter: Chapter) -> None:
    report = engines.check(REFERENCE, chapter)
    assert report["failure"] is None
    assert report["passed"]
    assert report["earned"] == report["points"]
    assert report["summary"].startswith("All checks pass.")
    assert report["finish"][0] == f"Well done! Chapter {chapter.number} works: {chapter.title}."


@pytest.mark.parametrize("chapter", CHAPTERS[::4], ids=lambda chapter: chapter.name)
def test_stubs_earn_nothing(engines: NodeEngines, chapter: Chapter) -> None:
    report = engines.check({}, chapter)
    assert not report["passed"]
    assert report["earned"] == 0.0
    states = {result["state"] for result in report["results"]}
    assert states <= {"not written yet", "to answer", "failed", "blocked"}
    assert report["failure"]["file"].startswith("ch")
