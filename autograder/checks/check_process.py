"""Start the process that runs the checks, read the events it reports, and kill it if it hangs."""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Protocol

from autograder.checks.arrange import Config
from autograder.checks.forked import how_it_ended
from autograder.diagnosis.explain import explain_hang
from autograder.manifest import ROOT
from autograder.message import Kind, Message

if TYPE_CHECKING:
    from autograder.isolation.forked_checks import ForkedChecks

GRACE = 10.0  # seconds beyond a check's limit that we wait for output before we kill the process
MOST_STDERR = 2000  # bytes; of standard error we keep only the end
MISSING = re.compile(r"No module named '(ch\d\d_\w+)'")  # an earlier chapter

_processes: set[subprocess.Popen[str] | ForkedChecks] = set()
_stopping = threading.Event()


@contextlib.contextmanager
def stopping() -> Iterator[None]:
    """Stop the check processes of all threads, and start no new ones inside the ``with`` block."""
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


@dataclass(frozen=True)
class Ending:
    """How a check process ended and, if known, why."""

    stack: str = ""  # a stack trace of what the process was doing, if it ran out of time
    silent: bool = False  # whether the process stopped responding and had to be killed
    code: int = 0
    stderr: str = ""  # the end of it

    def explain(self, time_limit: float, engine: list[Path]) -> Message:
        """Explain to the student why the process ended before the current check had finished."""
        if self.stack or self.silent:
            return explain_hang(self.stack, time_limit, engine)
        return Message(how_it_ended(self.code), kind=Kind.LEFT)

    def why_no_verdict(self, chapter: str) -> str:
        """Explain why the process ended before any check of the chapter had a verdict."""
        if missing := MISSING.search(self.stderr):
            return f"{missing[1]} is missing: put your own folder of that name beside {chapter}"
        words = self.stderr.rpartition("INTERNALERROR>")[2].strip()  # without pytest's traceback
        return f"the check process stopped without a verdict: {words or 'it printed nothing'}"


class Listener(Protocol):
    """Configures a check process and hears its events, as the runner does."""

    restarts: bool  # whether the process must end now
    deadline: float

    def config(self, folder: Path) -> Config: ...

    def hear(self, line: str) -> None: ...


def run_process(run: Listener) -> Ending:
    """Run the checks that have no verdict yet in a new process, while ``run`` hears its events."""
    silent = False
    # On Windows the files of a process stay locked for a moment after its end.
    with tempfile.TemporaryDirectory(prefix="checks-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        config = run.config(folder)
        stack_file = Path(config.stack_file)
        stack_file.touch()
        with (folder / "stderr.txt").open("w+b") as stderr:
            process = _start(config, folder, stderr)
            _processes.add(process)
            if is_stopped():  # stopping() may not have seen this process yet
                _kill(process)
            try:
                for line in _lines(process, config.time_limit, run.deadline):
                    if silent := line is None:
                        break
                    run.hear(line)
                    if run.restarts:
                        break
            finally:
                _processes.discard(process)
                _kill(process)
                code = process.wait()  # stdout stays open, since a stray child may hold it
                if process.stdin:
                    process.stdin.close()
            stderr.seek(max(0, stderr.seek(0, os.SEEK_END) - MOST_STDERR))
            said = stderr.read().decode("utf-8", errors="replace").strip()
        stack = stack_file.read_text(encoding="utf-8", errors="replace")
    return Ending(stack, silent, code, said)


def _start(config: Config, folder: Path, stderr: IO[bytes]) -> subprocess.Popen[str] | ForkedChecks:
    file = folder / "config.pickle"  # too long for a command line; no one else may write to it
    file.write_bytes(pickle.dumps(config))
    if config.level is not None:
        from autograder.isolation.forked_checks import ForkedChecks  # not in handouts

        return ForkedChecks(file, Path(config.root), environment, stderr)
    return subprocess.Popen(
        [sys.executable, "-m", "autograder.checks.pytest_plugin", str(file)],
        cwd=config.root,
        env=environment(),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=stderr,
        encoding="utf-8",
        start_new_session=True,
    )


def _lines(
    process: subprocess.Popen[str] | ForkedChecks, time_limit: float, deadline: float
) -> Iterator[str | None]:
    """Yield each line that a process prints, and None if it is silent for too long."""
    stream = process.stdout
    assert stream is not None
    lines: queue.Queue[str] = queue.Queue()

    def pass_on() -> None:
        with contextlib.suppress(ValueError):  # the stream may be closed while it is read
            for line in stream:
                lines.put(line)
        lines.put("")

    threading.Thread(target=pass_on, daemon=True).start()
    try:
        while line := lines.get(
            timeout=max(0.0, min(deadline - time.monotonic(), time_limit + GRACE))
        ):
            yield line
    except queue.Empty:
        yield None


def _kill(process: subprocess.Popen[str] | ForkedChecks) -> None:
    """Kill a check process and, on systems with process groups, every program that it started."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        if sys.platform == "win32":
            assert isinstance(process, subprocess.Popen)  # Windows has no sandbox
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def environment() -> dict[str, str]:
    """Return the environment variables for a check process."""
    path = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH", "")]))
    return os.environ | {
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # it loads no plugins of the user's machine
        "PYTEST_ADDOPTS": "",
        "PYTHONPATH": path,
        "PYTHONUTF8": "1",
        "MALLOC_ARENA_MAX": "1",  # or the thread of the time limit takes 64 MB of the memory
    }
