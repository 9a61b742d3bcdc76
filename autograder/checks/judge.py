"""A process that runs checks, seen from the runner: started, followed line by line, and ended."""

from __future__ import annotations

import contextlib
import json
import os
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
from typing import IO, TYPE_CHECKING

from autograder.checks.apart import how_it_ended
from autograder.checks.arrange import root_of_checks
from autograder.checks.explain import explain_hang
from autograder.manifest import ROOT
from autograder.message import Kind, Message
from autograder.records import to_json

if TYPE_CHECKING:
    from autograder.checks.runner import Run

GRACE = 10.0  # seconds of silence beyond a check's limit, then the process is ended from outside
MOST_STDERR = 2000  # bytes at the end of what a process says of itself

_processes: set[subprocess.Popen[str]] = set()
_stopping = threading.Event()


@contextlib.contextmanager
def stopping() -> Iterator[None]:
    """End the runs in all threads, each of which raises GraderError; let none begin in here."""
    _stopping.set()
    for process in list(_processes):
        _kill(process)
    try:
        yield
    finally:
        _stopping.clear()


def is_stopped() -> bool:
    """Say whether runs are being ended."""
    return _stopping.is_set()


class SilentError(Exception):
    """The process has said nothing for too long."""


class Judge:
    """A process of verdicts.py over one configuration; it is ended at the latest here.

    ``stderr`` is the end of what it says of itself, and ``code`` its exit code, once it has ended.
    """

    def __init__(self, config: Path, folder: Path, *, holds_input: bool) -> None:
        self.config = config
        self.folder = folder
        self.holds_input = holds_input
        self.stderr = ""
        self.code = 0

    def lines(self, silence: float, deadline: float) -> Generator[str]:
        """Run the process and yield what it tells, a line at a time, until it ends.

        Raises SilentError where no line comes for ``silence`` seconds and GRACE, or until the
        deadline.
        """
        with (self.config.parent / "stderr.txt").open("w+b") as stderr:
            process = subprocess.Popen(
                [sys.executable, "-m", "autograder.checks.verdicts", str(self.config)],
                cwd=self.folder,
                env=environment(),
                # A judge that outlives us would judge for nobody: it sees the pipe end.
                stdin=subprocess.PIPE if self.holds_input else subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=stderr,
                encoding="utf-8",
                start_new_session=True,
            )
            _processes.add(process)
            if is_stopped():  # it has been started behind the back of who ends them all
                _kill(process)
            try:
                yield from _lines(process, silence, deadline)
            finally:
                _processes.discard(process)
                _kill(process)
                self.code = process.wait()  # a stray child may hold on to its output: it stays open
                if process.stdin:
                    process.stdin.close()
                stderr.seek(max(0, stderr.seek(0, os.SEEK_END) - MOST_STDERR))
                self.stderr = stderr.read().decode("utf-8", errors="replace").strip()


@dataclass(frozen=True)
class Ending:
    """How a process of the checks has ended.

    Where its time was up, ``stack`` says what it was doing. It is ``silent`` where it had to be
    ended from outside. ``stderr`` is the end of what it said of itself.
    """

    stack: str = ""
    silent: bool = False
    code: int = 0
    stderr: str = ""

    def explain(self, time_limit: float, engine: list[Path]) -> Message:
        """Return what a check says in which the process ended."""
        if self.stack or self.silent:
            return explain_hang(self.stack, time_limit, engine)
        return Message(how_it_ended(self.code), kind=Kind.LEFT)


def judge(run: Run) -> Ending:
    """Start a process for the checks of a run that have no verdict yet; follow it to its end."""
    order, silent = run.order, False
    # Windows holds on to the files of a process for a moment after its end.
    with tempfile.TemporaryDirectory(prefix="checks-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        config = folder / "config.json"  # it may be longer than a command line
        arranged = run.config(folder)
        stack_file = Path(arranged.stack_file)
        stack_file.touch()
        config.write_text(json.dumps(to_json(arranged)), encoding="utf-8")
        place = root_of_checks(folder, order.root, order.behind)
        process = Judge(config, place, holds_input=order.behind is not None)
        try:
            with contextlib.closing(process.lines(run.limit, run.deadline)) as lines:
                for line in lines:
                    run.hear(line)
        except SilentError:
            silent = True
        stack = stack_file.read_text(encoding="utf-8", errors="replace")
    return Ending(stack, silent, process.code, process.stderr)


def _lines(process: subprocess.Popen[str], silence: float, deadline: float) -> Iterator[str]:
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
    with contextlib.suppress(ValueError):  # the stream is closed under our hands at the end
        for line in stream:
            lines.put(line)
    lines.put("")


def _kill(process: subprocess.Popen[str]) -> None:
    """Kill a process and, where the system has process groups, all that it has started."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def environment() -> dict[str, str]:
    """Return the environment of a checking process: ours, with no plugins loaded of themselves."""
    path = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH", "")]))
    return os.environ | {
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        "PYTHONPATH": path,
        "PYTHONUTF8": "1",
        "PYTEST_ADDOPTS": "",
    }
