"""A template that is forked from the waiting process works like one in a new Python process.

Each test has a grader of its own, a process that has ended before the test looks at what is left.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.isolation.probe import best_level
from autograder.isolation.sandbox import Level
from autograder.isolation.starting import start_waiting
from autograder.isolation.template import Template

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="orders need SOCK_SEQPACKET")

NUMBER = "import os\n\n\ndef number():\n    return os.getpid()\n"
Task = Callable[[Template, Template], list[int]]


def hang() -> NoReturn:
    raise TimeoutError("hangs")


def worker_of(template: Template) -> int:
    """Start a worker, and return its process ID, which code in it reports."""
    return int(template.start_worker(hang).ask("name", "ch91_own.own", "number")())


def state_of(process: int) -> list[str]:
    """Return what Linux says about a process: its state, its parent and more."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except OSError:
        return ["gone"]
    return text.rpartition(")")[2].split()


def parent_of(process: int) -> int:
    return int(state_of(process)[1])


def end(*processes: int) -> bool:
    """Return whether all processes end. A process that nobody waits for remains as a zombie."""
    for _ in range(500):
        if all(state_of(process)[0] in ("gone", "Z") for process in processes):
            return True
        time.sleep(0.02)
    return False


@pytest.fixture
def in_a_grader(tmp_path: Path) -> Callable[[Task], list[int]]:
    """Return a function that gives a task two templates in a grader, and returns what it finds.

    The grader does not use bubblewrap, which would hide the process IDs of workers.
    """
    level = replace(best_level(), bubblewrap=False)
    if not level.seccomp:
        pytest.skip("without seccomp every worker has a template of its own")
    (tmp_path / "ch91_own").mkdir()
    (tmp_path / "ch91_own/own.py").write_text(NUMBER, encoding="utf-8")

    def run(task: Task) -> list[int]:
        with ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as grader:
            return grader.submit(_with_templates, task, level, tmp_path).result(60.0)

    return run


def _with_templates(task: Task, level: Level, folder: Path) -> list[int]:
    start_waiting()
    first, second = (Template(level, [str(folder)], str(folder), folder, 5.0) for _ in range(2))
    return task(first, second)


def forked(first: Template, second: Template) -> list[int]:
    workers = [worker_of(first), worker_of(first), worker_of(second)]
    templates = [parent_of(worker) for worker in workers[1:]]
    starters = [*map(parent_of, templates)]
    second.close()
    assert end(workers[-1], templates[-1])
    return [*workers, *templates, *starters, os.getpid()]


def test_workers_have_forked_templates_and_nothing_outlives_its_grader(
    in_a_grader: Callable[[Task], list[int]],
) -> None:
    *processes, waiting, other, grader = in_a_grader(forked)
    assert len({*processes, grader}) == 3 + 2 + 1
    assert waiting == other != grader
    assert end(*processes, waiting)


def without_the_waiting_process(first: Template, second: Template) -> list[int]:
    waiting = parent_of(parent_of(worker_of(first)))
    os.kill(waiting, signal.SIGKILL)
    assert end(waiting)
    workers = [worker_of(first), worker_of(second)]
    return [*workers, *map(parent_of, workers), parent_of(parent_of(workers[1])), os.getpid()]


def test_templates_outlive_the_waiting_process_and_others_are_started_without_it(
    in_a_grader: Callable[[Task], list[int]],
) -> None:
    *processes, starter, grader = in_a_grader(without_the_waiting_process)
    assert starter == grader
    assert len({*processes}) == 4
    assert end(*processes)
