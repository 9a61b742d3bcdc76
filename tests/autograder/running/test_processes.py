"""Workers, launchers and check processes: how much time they get, and that they end."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.checks.check_process import environment
from autograder.isolation.forked_checks import ForkedChecks
from autograder.isolation.handles import Session, WorkerFailure, extra_time
from autograder.isolation.launcher import Launcher, LauncherError
from autograder.isolation.probe import best_level
from autograder.manifest import ROOT

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has /proc")
LEVEL = replace(best_level(), bubblewrap=False)  # it hides the process ID of a worker
NUMBER = "import os\n\n\ndef number():\n    return os.getpid()\n"


def hang() -> NoReturn:
    raise TimeoutError("hangs")


def number(session: Session) -> int:
    return session.ask("name", "ch91_own.own", "number")()


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


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "ch91_own").mkdir()
    (tmp_path / "ch91_own/own.py").write_text(NUMBER, encoding="utf-8")
    return tmp_path


def start(folder: Path, seconds: float = 5.0) -> Launcher:
    return Launcher(LEVEL, [str(folder)], str(folder), seconds)


@pytest.fixture
def launch(folder: Path) -> Iterator[Callable[..., Launcher]]:
    """Starts launchers over a module that knows its process ID."""
    started: list[Launcher] = []

    def launcher(**options: float) -> Launcher:
        started.append(start(folder, **options))
        return started[-1]

    yield launcher
    for one in started:
        one.close()


def test_a_worker_that_did_not_get_the_processor_gets_more_time_once(
    launch: Callable[..., Launcher],
) -> None:
    """A stopped worker is one that a busy machine leaves no time for."""
    session = launch(seconds=1.0).start_worker(hang)
    worker = number(session)
    os.kill(worker, signal.SIGSTOP)
    threading.Timer(1.3, os.kill, (worker, signal.SIGCONT)).start()
    assert session.ask("length", [1, 2, 3]) == 3
    os.kill(worker, signal.SIGSTOP)
    with pytest.raises(TimeoutError):
        session.ask("length", [])


def test_a_worker_that_had_the_processor_gets_no_more_time() -> None:
    begun = time.process_time()
    while time.process_time() - begun < 0.3:
        pass
    used = sum(os.times()[:2])
    assert extra_time(os.getpid(), 1.9 * used) == 0.0
    assert extra_time(os.getpid(), 3.0 * used) == pytest.approx(2.0 * used, abs=0.1)
    assert extra_time(0, 1.0) == 0.0


def test_a_worker_that_the_machine_kills_is_no_fault_of_the_student(
    launch: Callable[..., Launcher],
) -> None:
    launcher = launch()
    session = launcher.start_worker(hang)
    os.kill(number(session), signal.SIGKILL)
    with pytest.raises(LauncherError, match="killed from outside") as caught:
        session.ask("show", 1)
    assert not isinstance(caught.value, Exception), "no check can expect it"
    with pytest.raises(WorkerFailure, match="has ended"):
        session.ask("show", 1)
    assert launcher.start_worker(hang).ask("show", 1) == "1"


def test_without_seccomp_each_worker_has_a_launcher_of_its_own(
    launch: Callable[..., Launcher],
) -> None:
    launcher = launch()
    launcher.fresh = True  # as it is in a sandbox without seccomp
    parents = {state_of(number(launcher.start_worker(hang)))[1] for _ in range(2)}
    assert len(parents) == 2


def start_workers(folder: Path) -> list[list[int]]:
    """Return the process IDs of two launchers, of which the first has two workers, and of these."""
    found = []
    launchers = [start(folder) for _ in range(3)]
    for launcher in (launchers[0], *launchers):
        worker = number(launcher.start_worker(hang))
        found.append([int(state_of(worker)[1]), worker])
    launchers[2].close()
    assert end(found[0][1], *found[3])
    assert {state_of(launcher)[1] for launcher, _ in found[1:3]} == {str(os.getpid())}
    return found[:3]


@pytest.mark.skipif(not LEVEL.seccomp, reason="every worker has a launcher of its own")
def test_nothing_outlives_its_grader(folder: Path) -> None:
    with ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as grader:
        first, again, other = grader.submit(start_workers, folder).result(60.0)
        assert first[0] == again[0] != other[0]
        assert len({*again, *other, first[1]}) == 5
        assert {state_of(process)[0] for process in (*again, *other)} <= {"R", "S"}
    assert end(*again, *other)


@pytest.fixture
def fork(tmp_path: Path) -> Iterator[Callable[..., ForkedChecks]]:
    """Starts check processes with a configuration, which by default is none."""
    (tmp_path / "config.pickle").write_text("{}", encoding="utf-8")
    started: list[ForkedChecks] = []
    with (tmp_path / "stderr.txt").open("w+b") as stderr:
        rest = tmp_path, environment, stderr

        def fork(config: str = "config.pickle") -> ForkedChecks:
            started.append(ForkedChecks(Path(config), *rest))
            return started[-1]

        yield fork
    for one in started:
        one.stdin.close()


def test_a_check_process_has_its_own_folder_output_and_exit_code(
    fork: Callable[..., ForkedChecks], tmp_path: Path
) -> None:
    one = fork()
    assert one.stdout.read() == ""
    assert os.getpgid(one.pid) == one.pid, "the runner ends its whole group"
    assert one.wait() == 1
    assert "UnpicklingError" in (tmp_path / "stderr.txt").read_text(encoding="utf-8")


def test_a_check_process_that_is_killed_at_once_is_waited_for(
    fork: Callable[..., ForkedChecks], tmp_path: Path
) -> None:
    os.mkfifo(tmp_path / "config")  # it waits for this configuration
    one = fork("config")
    os.killpg(one.pid, signal.SIGKILL)
    assert one.wait() == -signal.SIGKILL


def test_after_the_helper_has_ended_the_next_fork_gets_another(
    fork: Callable[..., ForkedChecks],
) -> None:
    first = fork()
    os.kill(int(state_of(first.pid)[1]), signal.SIGKILL)
    with pytest.raises(OSError, match="has ended"):
        first.wait()
    assert fork().wait() == 1


# A grader that prints the process ID of its child, which forks check processes, and then leaves.
GRADER = """
import contextlib, os, sys
from pathlib import Path
from autograder.isolation.forked_checks import ForkedChecks

ForkedChecks(Path("none"), Path(sys.argv[1]), lambda: dict(os.environ), open(os.devnull, "w+b"))
for status in Path("/proc").glob("[0-9]*/stat"):
    with contextlib.suppress(OSError):  # a process that has just ended
        if status.read_text().rpartition(")")[2].split()[1] == str(os.getpid()):
            print(status.parent.name, flush=True)
os._exit(0)
"""


def test_the_process_that_starts_them_ends_with_its_grader(tmp_path: Path) -> None:
    command = [sys.executable, "-c", GRADER, str(tmp_path)]
    grader = subprocess.run(command, cwd=ROOT, capture_output=True, check=True, timeout=60)
    assert end(int(grader.stdout))
