"""Run the checks of a student's code in a separate process.

This module starts the process, reads what it prints, and kills it if it hangs.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Generator, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Protocol

from autograder.checks.apart import how_it_ended
from autograder.checks.arrange import Behind, Config, root_of_checks
from autograder.diagnosis.explain import explain_hang
from autograder.files import is_full
from autograder.manifest import ROOT
from autograder.message import Kind, Message

if TYPE_CHECKING:
    from autograder.isolation.judges import ForkedJudge

GRACE = 10.0  # seconds beyond a check's limit that we wait for output before we kill the process
MOST_STDERR = 2000  # bytes; of standard error we keep only the end

_processes: set[subprocess.Popen[str] | ForkedJudge] = set()
_stopping = threading.Event()


@contextlib.contextmanager
def stopping() -> Iterator[None]:
    """Stop the check processes of all threads, and start no new ones inside the ``with`` block.

    Every run of checks that is stopped in this way raises GraderError.
    """
    _stopping.set()
    for process in list(_processes):
        _kill(process)
    try:
        yield
    finally:
        _stopping.clear()


def is_stopped() -> bool:
    """Return True if no check process may run at the moment, because a thread uses ``stopping``."""
    return _stopping.is_set()


class SilentError(Exception):
    """Raised when a check process prints nothing for too long, perhaps because it hangs."""


class Judge:
    """A process that runs the checks described in a configuration file.

    Attributes:
        code: The exit code, once the process has ended.
        stderr: The last part of the process's standard error, once the process has ended.
    """

    def __init__(self, config: Path, folder: Path, *, behind: bool) -> None:
        self.config = config
        self.folder = folder
        self.behind = behind
        self.stderr = ""
        self.code = 0

    def lines(self, silence: float, deadline: float) -> Generator[str]:
        """Run the check process, and yield each line of its output as soon as it is printed.

        If the caller stops reading early, the process is killed.

        Raises:
            SilentError: The process printed nothing for ``silence`` + GRACE seconds, or was still
                running at the deadline.
        """
        with (self.config.parent / "stderr.txt").open("w+b") as stderr:
            process = self._start(stderr)
            _processes.add(process)
            if is_stopped():  # stopping() may not have seen this process yet
                _kill(process)
            try:
                yield from _lines(process, silence, deadline)
            finally:
                _processes.discard(process)
                _kill(process)
                self.code = process.wait()  # stdout stays open, since a stray child may hold it
                if process.stdin:
                    process.stdin.close()
                stderr.seek(max(0, stderr.seek(0, os.SEEK_END) - MOST_STDERR))
                self.stderr = stderr.read().decode("utf-8", errors="replace").strip()
                if not self.stderr and is_full(self.config.parent):
                    self.stderr = f"the disk of {self.config.parent.parent} is full"

    def _start(self, stderr: IO[bytes]) -> subprocess.Popen[str] | ForkedJudge:
        if self.behind:
            from autograder.isolation.judges import ForkedJudge  # not in handouts

            return ForkedJudge(self.config, self.folder, environment(), stderr)
        return subprocess.Popen(
            [sys.executable, "-m", "autograder.checks.verdicts", str(self.config)],
            cwd=self.folder,
            env=environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=stderr,
            encoding="utf-8",
            start_new_session=True,
        )


@dataclass(frozen=True)
class Ending:
    """How a check process ended and, if known, why.

    Attributes:
        stack: A stack trace of what the process was doing, if it ran out of time.
        silent: True if the process stopped responding and had to be killed.
        code: The exit code.
        stderr: The last part of the process's standard error.
    """

    stack: str = ""
    silent: bool = False
    code: int = 0
    stderr: str = ""

    def explain(self, time_limit: float, engine: list[Path]) -> Message:
        """Explain to the student why the process ended before the current check had finished."""
        if self.stack or self.silent:
            return explain_hang(self.stack, time_limit, engine)
        return Message(how_it_ended(self.code), kind=Kind.LEFT)


class Listener(Protocol):
    """What a run of checks tells the process, and how it hears of the events."""

    root: Path
    behind: Behind | None
    restarts: bool
    deadline: float

    @property
    def limit(self) -> float: ...

    def config(self, folder: Path) -> Config: ...

    def hear(self, line: str) -> None: ...


def judge(run: Listener) -> Ending:
    """Run the checks that have no verdict yet in a new process, and report how the process ended.

    The process prints one line per event, such as the start of a check. Each line is passed to
    ``run`` as soon as it arrives.
    """
    silent = False
    # On Windows the files of a process stay locked for a moment after its end.
    with tempfile.TemporaryDirectory(prefix="checks-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        config = folder / "config.pickle"  # too long for a command line
        arranged = run.config(folder)
        stack_file = Path(arranged.stack_file)
        stack_file.touch()
        config.write_bytes(pickle.dumps(arranged))  # no one else may write to this folder
        place = root_of_checks(folder, run.root, run.behind)
        process = Judge(config, place, behind=run.behind is not None)
        try:
            with contextlib.closing(process.lines(run.limit, run.deadline)) as lines:
                for line in lines:
                    run.hear(line)
                    if run.restarts:
                        break
        except SilentError:
            silent = True
        stack = stack_file.read_text(encoding="utf-8", errors="replace")
    return Ending(stack, silent, process.code, process.stderr)


def _lines(
    process: subprocess.Popen[str] | ForkedJudge, silence: float, deadline: float
) -> Iterator[str]:
    assert process.stdout is not None
    lines: queue.Queue[str] = queue.Queue()
    threading.Thread(target=_pass_on, args=(process.stdout, lines), daemon=True).start()
    while True:
        left = deadline - time.monotonic()
        try:
            line = lines.get(timeout=max(0.0, min(left, silence + GRACE)))
        except queue.Empty:
            raise SilentError from None
        if not line:
            return
        yield line


def _pass_on(stream: IO[str], lines: queue.Queue[str]) -> None:
    with contextlib.suppress(ValueError):  # the stream may be closed while it is read
        for line in stream:
            lines.put(line)
    lines.put("")


def _kill(process: subprocess.Popen[str] | ForkedJudge) -> None:
    """Kill a check process and, on systems with process groups, every program that it started."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        if sys.platform == "win32":
            assert isinstance(process, subprocess.Popen)  # Windows cannot fork judges
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def environment() -> dict[str, str]:
    """Return the environment variables for a check process.

    They keep pytest from loading any plugins or options that are set up on the user's machine,
    because these could change how the checks run.
    """
    path = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH", "")]))
    return os.environ | {
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        "PYTHONPATH": path,
        "PYTHONUTF8": "1",
        "PYTEST_ADDOPTS": "",
    }
