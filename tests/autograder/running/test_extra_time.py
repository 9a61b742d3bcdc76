"""A worker gets more time if the machine was busy, once, and only then."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.isolation.handles import extra_time
from autograder.isolation.launcher import Launcher
from autograder.isolation.probe import best_level

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has /proc")
NUMBER = "import os\n\n\ndef number():\n    return os.getpid()\n"


def hang() -> NoReturn:
    raise TimeoutError("hangs")


def test_a_worker_that_did_not_get_the_processor_gets_more_time_once(
    tmp_path: Path,
) -> None:
    """A stopped worker is one that a busy machine leaves no time for."""
    (tmp_path / "ch91_own").mkdir()
    (tmp_path / "ch91_own/own.py").write_text(NUMBER, encoding="utf-8")
    level = replace(best_level(), bubblewrap=False)  # it hides the process ID of a worker
    launcher = Launcher(level, [str(tmp_path)], str(tmp_path), tmp_path, seconds=1.0)
    session = launcher.start_worker(hang)
    worker = session.ask("name", "ch91_own.own", "number")()
    os.kill(worker, signal.SIGSTOP)
    threading.Timer(1.3 * launcher.seconds, os.kill, (worker, signal.SIGCONT)).start()
    assert session.ask("length", [1, 2, 3]) == 3
    os.kill(worker, signal.SIGSTOP)
    with pytest.raises(TimeoutError):
        session.ask("length", [])
    launcher.close()


def test_a_worker_that_had_the_processor_gets_no_more_time() -> None:
    begun = time.process_time()
    while time.process_time() - begun < 0.3:
        pass
    used = sum(os.times()[:2])
    assert extra_time(os.getpid(), 1.9 * used) == 0.0
    assert extra_time(os.getpid(), 3.0 * used) == pytest.approx(2.0 * used, abs=0.1)
    assert extra_time(0, 1.0) == 0.0
