"""The page's engines say what `make check` says, though Python runs in WebAssembly there."""

from __future__ import annotations

import random
import re
from typing import Any

import pytest

from autograder.checks.verdict import with_needs
from autograder.manifest import Chapter, load_chapters
from autograder.scores import results_of
from autograder.student.failure import failure_of
from autograder.student.screen import Report, first_open
from copies import reference
from in_node import NodeEngines, engines
from ready import ready
from wrong import read_wrong, write_wrong

CHAPTERS = load_chapters()
REFERENCE = reference()
NUMBER = re.compile(r"-?\d+\.\d+(?:e[-+]\d+)?")
ERROR = re.compile(r"\w*(Error|Exception|Exit|Interrupt)\b")

engines = pytest.fixture(scope="module")(engines)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_the_reference_earns_all_points(engines: NodeEngines, chapter: Chapter) -> None:
    report = engines.check(REFERENCE, chapter)
    assert report["failure"] is None
    assert report["passed"]
    assert report["earned"] == report["points"]
    assert report["summary"].startswith("All checks pass.")
    assert report["finish"][0] == f"Well done! Chapter {chapter.number} works: {chapter.title}."


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_stubs_earn_nothing(engines: NodeEngines, chapter: Chapter) -> None:
    report = engines.check({}, chapter)
    assert not report["passed"]
    assert report["earned"] == 0.0
    states = {result["state"] for result in report["results"]}
    assert states <= {"not written yet", "to answer", "failed", "blocked"}
    assert report["failure"]["file"].startswith("ch")


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_wrong_submissions_are_told_as_on_the_command_line(
    engines: NodeEngines, chapter: Chapter, pytestconfig: pytest.Config
) -> None:
    seed = pytestconfig.getoption("seed")
    for wrong in random.Random(f"{seed} {chapter.name}").sample(read_wrong(chapter), 3):
        (exercise,) = (e for e in chapter.exercises if wrong.edit in e.edit)
        waiting = ready(chapter, seed)
        write_wrong(chapter, [wrong], waiting.top)
        changed = {
            f"{chapter.name}/{file.name}": file.read_text(encoding="utf-8")
            for file in waiting.top.glob("*/*")
        }
        report = engines.check(REFERENCE | changed, chapter, exercise.id, seed=seed)
        wanted = with_needs(chapter, [exercise.id])
        verdicts = waiting.run([wrong.edit], wanted)
        results = [r for r in results_of(chapter, verdicts) if r.exercise.id in wanted]
        first = first_open([Report(chapter, results, [], [])], exercise)
        assert first is not None
        failure = failure_of(*first, waiting.engine)
        assert failure is not None
        told = [[check.name, check.status] for r in results for check in r.checks]
        assert told == statuses(report), wrong.mistake
        assert_same_words(report["failure"]["rows"], [list(row) for row in failure.diagnosis])
        assert report["failure"]["heading"] == failure.heading


def statuses(report: dict[str, Any]) -> list[list[str]]:
    """Return the name and the status of each check in a report."""
    return [[c["name"], c["status"]] for result in report["results"] for c in result["checks"]]


def assert_same_words(told: list[list[str]], wanted: list[list[str]]) -> None:
    """Compare rows. These may differ: what another version of Python says of an error, on which
    line of a loop the time was up, and the last digit of a number, as sines have another one there.
    """
    hung = any("did not end" in words for _, words in wanted)
    assert [label for label, _ in told] == [label for label, _ in wanted]
    for (label, got), (_, words) in zip(told, wanted, strict=True):
        if label == "where" and hung:
            continue
        if label == "got" and (error := ERROR.match(words)):
            assert got.startswith(error[0])
        else:
            assert NUMBER.sub("#", got) == NUMBER.sub("#", words)
            numbers = [float(number) for number in NUMBER.findall(words)]
            found = [float(number) for number in NUMBER.findall(got)]
            assert found == pytest.approx(numbers, rel=1e-12, abs=1e-15)
