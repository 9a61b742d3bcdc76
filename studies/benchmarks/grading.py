"""Measure how long students wait for `make check`, and what isolation costs in grading.

For comparison, one process imports the students' code itself and runs the same checks.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from autograder.checks.arrange import SandboxSettings
from autograder.checks.runner import run_checks
from autograder.isolation.probe import best_level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.submissions.class_list import read_class
from autograder.submissions.stage import stage
from scenes.timing import Measurement, Target, Timer, both, timer, versus

ENGINE = [ROOT / "solutions", ROOT / "chapters"]
AT_A_TIME = 2


def lines() -> list[Measurement]:
    """Set up the benchmarks of a check and of a sample class."""
    sandbox = SandboxSettings(vars(best_level()))
    _, second, *_, last = load_chapters()
    # The target was set for chapter 3. Later chapters import more modules and do more work.
    checks = [_one_check(second, sandbox, Target("at most", 8)), _one_check(last, sandbox, None)]
    return [*checks, _sample_class(sandbox)]


def _one_check(chapter: Chapter, sandbox: SandboxSettings, target: Target | None) -> Measurement:
    """Measure the extra time per check in an isolated worker, with its start, in ms."""

    def checked(where: SandboxSettings | None) -> int:
        return len(run_checks(chapter, ENGINE, seed="1", sandbox=where))

    count = checked(None)
    checked(sandbox)

    def extra() -> float:
        inside, beside = both(timer(partial(checked, sandbox)), timer(partial(checked, None)))
        return (inside - beside) / count * 1000

    what = (
        f"extra time per check of chapter {chapter.number} in an isolated worker, in milliseconds"
    )
    return Measurement(what, extra, 9, target)


def _sample_class(sandbox: SandboxSettings) -> Measurement:
    """Grade a class with and without workers. Its endless loops run until the time limit."""
    submissions = read_class(ROOT / "sample_class").submissions
    chapters = load_chapters()

    def grade(where: SandboxSettings | None) -> None:
        with ThreadPoolExecutor(AT_A_TIME) as pool:
            for _ in pool.map(lambda one: grade_one(one.path, where), submissions):
                pass

    def grade_one(path: Path, where: SandboxSettings | None) -> None:
        with tempfile.TemporaryDirectory() as box:
            stage(path, chapters, Path(box))
            for chapter in chapters:
                run_checks(chapter, [Path(box)], seed="1", sandbox=where)

    what = "the sample class: in isolated workers / in the process of the checks"
    figure = versus(timer(partial(grade, sandbox)), timer(partial(grade, None)))
    return Measurement(what, figure, 1)  # it takes a minute or two


def line_of_check() -> Measurement:
    """Set up the benchmark that compares `make check` for one chapter with importing pytest."""
    check = _running("-m", "autograder", "check", "--chapter", "2")
    for _ in range(2):  # the first run compiles the modules
        check()
    what = "make check CH=2 / importing pytest"
    figure = versus(check, _running("-c", "import pytest"))
    return Measurement(what, figure, 15, Target("at most", 3))


def _running(*command: str) -> Timer:
    """Return a function that runs Python with these arguments and returns the time taken, in s."""
    call = [sys.executable, *command]
    return timer(lambda: subprocess.run(call, cwd=ROOT, stdout=subprocess.DEVNULL, check=False))
