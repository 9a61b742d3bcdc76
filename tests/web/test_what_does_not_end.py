"""What does not end costs one worker of the page, and is told in the words of `make check`."""

from __future__ import annotations

from typing import Any

import pytest

from autograder.manifest import load_chapters
from copies import reference
from in_node import NodeEngines

CHAPTER = load_chapters()[0]
FILE = "ch02_vectors/vector.py"
RIGHT = reference()
LINE = "        return math.hypot(self.x, self.y, self.z)"
LENGTH, NORMALIZE = "B2.2", "B2.4"


def with_length(*lines: str) -> dict[str, str]:
    """Return the reference with another body of Vector3.magnitude."""
    assert RIGHT[FILE].count(LINE) == 1
    body = "\n".join(f"        {line}" for line in lines)
    return RIGHT | {FILE: RIGHT[FILE].replace(LINE, body)}


def with_zero(*lines: str) -> dict[str, str]:
    """Return the reference with another body of Vector3.normalize for the vector zero alone."""
    before = "        if length == 0.0:\n            return\n"
    assert RIGHT[FILE].count(before) == 1
    body = "".join(f"            {line}\n" for line in lines)
    return RIGHT | {FILE: RIGHT[FILE].replace(before, f"        if length == 0.0:\n{body}")}


def ask(engines: NodeEngines, files: dict[str, str], exercise: str = LENGTH) -> dict[str, Any]:
    """Return all that the page hears of a check."""
    asked = {"files": files, "chapter": CHAPTER.name, "exercise": exercise}
    return engines.ask("check", asked=asked)


def test_an_endless_loop_is_told_in_four_seconds_with_its_line(engines: NodeEngines) -> None:
    right = ask(engines, RIGHT, NORMALIZE)
    assert right["report"]["passed"]
    files = with_zero("while True:", "    pass")
    answer = ask(engines, files, NORMALIZE)
    (trouble,) = answer["troubles"]
    # The loop begins within the time that a right answer takes.
    assert trouble["after"] < 4.0 + right["seconds"]
    line = 1 + files[FILE].partition("while True:")[0].count("\n")
    for failure in (trouble["failure"], answer["report"]["failure"]):
        *_, (_, words), (label, place) = failure["rows"]
        assert words == "did not finish within 3 seconds. Is there an endless loop?"
        assert (label, failure["file"]) == ("where", FILE)
        assert place == f"{FILE}, line {failure['line']}, in normalize"
        assert failure["line"] in (line, line + 1)
    results = {result["id"]: result for result in answer["report"]["results"]}
    assert results[LENGTH]["state"] == "passed", "what was found before the loop is kept"
    assert 0.0 < results[NORMALIZE]["score"] < results[NORMALIZE]["points"], "and what comes after"


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (["sum(iter(int, 1))"], "within 3 seconds"),  # a loop in C, which only the page can end
        (["import os", "os._exit(3)"], "exit code 3"),
    ],
)
def test_a_worker_that_hangs_in_c_or_leaves_python_is_told(
    engines: NodeEngines, lines: list[str], words: str
) -> None:
    rows = ask(engines, with_zero(*lines), NORMALIZE)["report"]["failure"]["rows"]
    assert any(words in said for _, said in rows)


def test_a_module_that_does_not_end_is_told_as_such(engines: NodeEngines) -> None:
    report = ask(engines, RIGHT | {FILE: "while True:\n    pass\n"})["report"]
    told = " ".join(said for _, said in report["failure"]["rows"])
    assert f"{FILE} cannot be imported: " in told
    assert "within 3 seconds" in told


@pytest.mark.parametrize(
    "line",
    [
        "return self.magnitude()",
        "return [v.magnitude() for v in sorted([self, self], key=lambda u: u.magnitude())][0]",
    ],
)
def test_what_calls_itself_is_a_recursion_error(engines: NodeEngines, line: str) -> None:
    """The calls of the second go through C, and fewer of those fit on a browser's stack."""
    rows = dict(ask(engines, with_length(line))["report"]["failure"]["rows"])
    assert rows["got"] == "RecursionError: maximum recursion depth exceeded"
    assert rows["likely"].startswith("A function calls itself")
    assert line in rows["where"]


def test_calls_may_be_nested_as_deeply_as_where_work_is_graded(engines: NodeEngines) -> None:
    deep = "deep = lambda n: n and 1 + deep(n - 1)"
    report = ask(engines, with_length(deep, "assert deep(900) == 900", LINE.strip()))["report"]
    assert report["passed"]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("import numpy", "ModuleNotFoundError: No module named 'numpy'"),
        ("import js", "ModuleNotFoundError: No module named 'js'"),
        ("open('/x', 'w')", "PermissionError: [Errno 13] Permission denied: '/x'"),
        ("open('x')", "FileNotFoundError: [Errno 2] No such file or directory: 'x'"),
        ("import os; os.fork()", "PermissionError: [Errno 1] Operation not permitted"),
        ("input()", "EOFError: EOF when reading a line"),
        ("raise SystemExit", "SystemExit"),
    ],
)
def test_code_may_do_no_more_than_where_work_is_graded(
    engines: NodeEngines, line: str, words: str
) -> None:
    rows = dict(ask(engines, with_length(line))["report"]["failure"]["rows"])
    assert rows["got"] == words


def test_nothing_of_a_check_is_left_for_the_next(engines: NodeEngines) -> None:
    spoils = with_length("import math as m", "m.pi = 3.0", "self.__class__.seen = 1", LINE.strip())
    ask(engines, spoils)
    files = with_length("assert not hasattr(Vector3, 'seen')", LINE.strip())
    assert ask(engines, files)["report"]["passed"]
    assert ask(engines, RIGHT)["report"]["passed"]


def test_what_cannot_be_run_is_a_clear_error(engines: NodeEngines) -> None:
    asked = {"files": RIGHT, "chapter": "ch03_laws_of_motion", "given": [2]}
    assert "chapter 2 cannot be given" in engines.ask("check", asked=asked)["error"]
    asked = {"files": {"../x.py": ""}, "chapter": CHAPTER.name}
    words = engines.ask("check", asked=asked)["error"]
    assert words == "a file's path must be chNN_name/name, got '../x.py'"
