"""The page's engines say what `make check` says, though Python runs in WebAssembly there."""

from __future__ import annotations

import json
import random
import re

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.scores import result_of
from autograder.student.failure import failure_of
from copies import reference
from in_node import NodeEngines
from ready import ready
from typed import typed
from wrong import read_wrong, write_wrong

SEED = 1  # of the wrong submissions that are drawn
CHAPTERS = load_chapters()
REFERENCE = reference()

EACH = [  # only the first one is quick
    pytest.param(chapter, id=chapter.name, marks=[pytest.mark.slow] if chapter.number > 2 else [])
    for chapter in CHAPTERS
]


@pytest.fixture(scope="module")
def checks() -> dict[str, list[str]]:
    """Return the names of all graded checks of each chapter, as pytest finds them on CPython."""
    folders = [f"tests/{chapter.name}" for chapter in CHAPTERS]
    done = typed("pytest", "--collect-only", "-q", "-n", "0", *folders)
    assert done.returncode == 0, done.stdout + done.stderr
    found: dict[str, list[str]] = {chapter.name: [] for chapter in CHAPTERS}
    for line in filter(lambda line: "::" in line, done.stdout.splitlines()):
        path, _, name = line.partition("::")
        found[path.split("/")[1]].append(name)
    return found


@pytest.mark.parametrize("chapter", EACH)
def test_the_reference_earns_all_points(
    engines: NodeEngines, checks: dict[str, list[str]], chapter: Chapter
) -> None:
    """All checks of all chapters pass in one interpreter, which takes 25 s on an idle machine."""
    report = engines.check(REFERENCE, chapter)
    run = [check for result in report["results"] for check in result["checks"]]
    assert {check["status"] for check in run} == {"passed"}
    assert sorted(check["name"] for check in run) == sorted(checks[chapter.name])
    assert report["failure"] is None
    assert report["passed"]
    assert report["earned"] == report["points"]
    assert report["summary"].startswith("All checks pass.")
    assert report["finish"][0] == f"Well done! Chapter {chapter.number} works: {chapter.title}."


def test_the_checks_run_on_the_python_that_the_readme_names(engines: NodeEngines) -> None:
    """The student's code says which one it is."""
    file = "ch02_vectors/vector.py"
    asks = "import sys\nraise RuntimeError(sys.version)\n"
    report = engines.check(REFERENCE | {file: asks}, CHAPTERS[0])
    readme = (ROOT / "web" / "README.md").read_text(encoding="utf-8")
    (named,) = re.findall(r"The browser runs Python (\d\.\d+)", readme)
    assert f"RuntimeError: {named}." in json.dumps(report["failure"]["rows"])


@pytest.mark.parametrize("chapter", EACH[::4])
def test_stubs_earn_nothing(engines: NodeEngines, chapter: Chapter) -> None:
    report = engines.check({}, chapter)
    assert not report["passed"]
    assert report["earned"] == 0.0
    states = {result["state"] for result in report["results"]}
    assert states <= {"not written yet", "to answer", "failed", "blocked"}
    assert report["failure"]["file"].startswith("ch")


@pytest.mark.parametrize("chapter", EACH)
def test_a_mistake_is_told_as_on_the_command_line(engines: NodeEngines, chapter: Chapter) -> None:
    """The page gets what make check would print. test_site_solving shows that it shows this."""
    for wrong in random.Random(f"{SEED} {chapter.name}").sample(read_wrong(chapter), 3):
        exercise = next(e for e in chapter.exercises if wrong.edit in e.edit)
        waiting = ready(chapter)
        write_wrong(chapter, [wrong], waiting.top)
        result = result_of(exercise, waiting.run([wrong.edit], [exercise.id]))
        expected = failure_of(chapter, result, waiting.engine)
        file = f"{chapter.name}/{wrong.edit.partition('.')[0]}.py"
        mine = {file: (waiting.top / file).read_text(encoding="utf-8")}
        told = engines.check(REFERENCE | mine, chapter, exercise.id)["failure"]
        assert told["heading"] == expected.heading
        assert [newer(*row) for row in told["rows"]] == [newer(*row) for row in expected.diagnosis]
        assert told["printed"] == expected.printed


def newer(label: str, words: str) -> tuple[str, str]:
    """Return a row as the site has it. Its newer Python words some messages in another way."""
    wider = r"expected a (?:number in range from -1 up to 1|nonnegative input), got \S+"
    words = re.sub(wider, "math domain error", words)
    words = words.replace("max() arg is an empty sequence", "max() iterable argument is empty")
    return label, words.replace("float division by zero", "division by zero")
