"""Launchers and their workers end together with the grader that started them."""

from __future__ import annotations

import multiprocessing
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.isolation.launcher import Launcher
from autograder.isolation.probe import best_level
from autograder.isolation.sandbox import Level

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has /proc")

NUMBER = "import os\n\n\ndef number():\n    return os.getpid()\n"


def hang() -> NoReturn:
    raise TimeoutError("hangs")


def state_of(process: int) -> list[str]:
    """Return what Linux says about a process: its state, its parent and more."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except OSError:
        return ["gone"]
    return text.rpartition(")")[2].split()


def end(*processes: int) -> bool:
    """Return whether all processes end. A process that nobody waits for remains as a zombie."""
    for _ in range(500):
        if all(state_of(process)[0] in ("gone", "Z") for process in processes):
            return True
        time.sleep(0.02)
    return False


def start_workers(level: Level, folder: Path) -> list[list[int]]:
    """Start two launchers in a grader, and return each one's process ID and that of its worker.

    The first launcher forks two workers, of which the first has ended, and the third is closed.
    """
    found = []
    launchers = [Launcher(level, [str(folder)], str(folder), folder, 5.0) for _ in range(3)]
    for launcher in (launchers[0], *launchers):
        worker = launcher.start_worker(hang).ask("name", "ch91_own.own", "number")()
        found.append([int(state_of(worker)[1]), worker])
    launchers[2].close()
    assert end(found[0][1], *found[3])
    assert {state_of(launcher)[1] for launcher, _ in found[1:3]} == {str(os.getpid())}
    return found[:3]


def test_nothing_outlives_its_grader(tmp_path: Path) -> None:
    level = replace(best_level(), bubblewrap=False)  # it hides the process IDs of workers
    if not level.seccomp:
        pytest.skip("without seccomp every worker has a launcher of its own")
    (tmp_path / "ch91_own").mkdir()
    (tmp_path / "ch91_own/own.py").write_text(NUMBER, encoding="utf-8")
    with ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as grader:
        first, again, other = grader.submit(start_workers, level, tmp_path).result(60.0)
        assert first[0] == again[0] != other[0]
        assert len({*again, *other, first[1]}) == 5
        assert {state_of(process)[0] for process in (*again, *other)} <= {"R", "S"}
    assert end(*again, *other)
