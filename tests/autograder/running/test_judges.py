"""The process that starts the judges of a grader, and the judges themselves."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from autograder.checks.check_process import environment
from autograder.isolation.judges import ForkedJudge
from autograder.manifest import ROOT

BROKEN = "{}"  # no configuration


def test_a_judge_has_its_own_folder_output_and_exit_code(tmp_path: Path) -> None:
    (tmp_path / "config.pickle").write_text(BROKEN, encoding="utf-8")
    with (tmp_path / "stderr.txt").open("w+b") as stderr:
        judge = ForkedJudge(Path("config.pickle"), tmp_path, environment(), stderr)
        assert judge.stdout.read() == ""
        assert os.getpgid(judge.pid) == judge.pid, "the runner ends its whole group"
        assert judge.wait() == 1
        judge.stdin.close()
    assert "UnpicklingError" in (tmp_path / "stderr.txt").read_text(encoding="utf-8")


def test_a_judge_that_is_killed_at_once_is_waited_for(tmp_path: Path) -> None:
    with (tmp_path / "stderr.txt").open("w+b") as stderr:
        os.mkfifo(tmp_path / "config")  # it waits for this configuration
        judge = ForkedJudge(tmp_path / "config", tmp_path, environment(), stderr)
        os.killpg(judge.pid, signal.SIGKILL)
        assert judge.wait() == -signal.SIGKILL
        judge.stdin.close()


def test_after_the_helper_has_ended_the_next_judge_gets_another(tmp_path: Path) -> None:
    (tmp_path / "config.json").write_text(BROKEN, encoding="utf-8")
    with (tmp_path / "stderr.txt").open("w+b") as stderr:
        first = ForkedJudge(Path("config.json"), tmp_path, environment(), stderr)
        status = Path(f"/proc/{first.pid}/stat").read_text(encoding="utf-8")
        os.kill(int(status.rpartition(")")[2].split()[1]), signal.SIGKILL)
        with pytest.raises(OSError, match="has ended"):
            first.wait()
        second = ForkedJudge(Path("config.json"), tmp_path, environment(), stderr)
        assert second.wait() == 1
        for judge in (first, second):
            judge.stdin.close()


# A grader that prints the process ID of its child, which starts the judges, and then leaves.
GRADER = """
import contextlib, os, sys
from pathlib import Path
from autograder.isolation.judges import ForkedJudge

ForkedJudge(Path("none"), Path(sys.argv[1]), dict(os.environ), open(os.devnull, "w+b"))
for status in Path("/proc").glob("[0-9]*/stat"):
    with contextlib.suppress(OSError):  # a process that has just ended
        if status.read_text().rpartition(")")[2].split()[1] == str(os.getpid()):
            print(status.parent, flush=True)
os._exit(0)
"""


def test_the_process_that_starts_judges_ends_with_its_grader(tmp_path: Path) -> None:
    grader = subprocess.run(
        [sys.executable, "-c", GRADER, str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        check=True,
        timeout=60,
        encoding="utf-8",
    )
    (waiting,) = map(Path, grader.stdout.split())
    for _ in range(500):
        if not waiting.exists():
            return
        time.sleep(0.02)
    pytest.fail("the waiting process is still there")
