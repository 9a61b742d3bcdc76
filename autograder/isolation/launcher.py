"""Start and control the launcher, the process that forks a worker for each check.

The workers run the student's code, and the launcher never does. This module is on the trusted side
of both. It sends one request at a time to the launcher, which has at most one worker, and waits for
the answer:

- "start" forks a worker. The answer is its process ID.
- "stack" makes the worker write a stack trace.
- "wait" waits for a worker that has closed its connection. The answer is its exit code or "alive".
- "stop" ends the worker.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import sysconfig
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import IO, Any, NamedTuple, NoReturn

from autograder.checks.forked import how_it_ended
from autograder.diagnosis.faults import GraderFault
from autograder.isolation.handles import Session
from autograder.isolation.sandbox import Level
from autograder.isolation.wire import Wire
from autograder.manifest import ROOT
from autograder.message import Message

START_LIMIT = 20.0  # seconds for our own process to start on a busy machine
END_LIMIT = 1.0  # seconds for it to end
SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/etc/ld.so.cache", "/dev/null")


class LauncherError(GraderFault):
    """Raised when a worker process does not start and the student's code is not the cause."""


class _Worker(NamedTuple):
    """Our end of the connection to a worker, and two files to which it writes."""

    socket: socket.socket
    log: IO[bytes]
    stack: IO[bytes]


class Launcher:
    """A process that forks a worker for each check, but never runs any student code itself.

    A worker looks for modules in the standard library, then in the folders ``engine`` of the
    student's chapters, and then in ``probes``, the helper functions of checks that must run in a
    worker. It may take ``seconds`` to answer. Their bytecode is in ``compiled``, if at all.

    Without seccomp, each worker gets a launcher of its own, because nothing else would keep one
    worker from affecting the next.
    """

    def __init__(
        self,
        level: Level,
        engine: Sequence[str],
        probes: str,
        seconds: float,
        compiled: str = "/nowhere",
    ) -> None:
        self.level = level
        self.engine = engine
        self.folders = [*engine, probes]
        self.seconds = seconds
        self.fresh = not level.seccomp and level.is_sandbox
        self.compiled = compiled
        self._log = self._new_file()  # output of the launcher itself
        self._process: subprocess.Popen[bytes] | None = None
        self._worker: _Worker | None = None
        self._session: Session | None = None

    def start(self) -> None:
        """Start the process if it is not running, without waiting until it is ready."""
        if self._process is not None:
            return
        self._control, theirs = socket.socketpair()
        self._control.settimeout(START_LIMIT)
        config = {
            "control": theirs.fileno(),
            "root": str(ROOT),
            "engine": self.engine,
            "folders": self.folders,
            "compiled": self.compiled,
            "level": vars(self.level),
            "readable": [*SYSTEM_LIBRARIES, *python_folders(), *self.folders, self.compiled],
            "seconds": int(self.seconds) + 2,
        }
        with theirs:
            self._process = subprocess.Popen(
                _command(config, self.level),
                cwd="/",
                env={"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"},
                stdin=subprocess.DEVNULL,
                stdout=self._log,
                stderr=self._log,
                pass_fds=[theirs.fileno()],
            )

    def _ask(self, request: str, *files: IO[bytes] | socket.socket) -> str:
        """Send a request and some open files to the launcher, and return its answer."""
        descriptors = [file.fileno() for file in files]
        socket.send_fds(self._control, [request.encode()], descriptors)
        if not (answer := self._control.recv(100)):
            raise EOFError
        return answer.decode()

    def start_worker(
        self, on_hang: Callable[[], NoReturn], broken: Mapping[str, Message] | None = None
    ) -> Session:
        """Start a session with a worker process that has not run any student code yet.

        Raise LauncherError if it does not start. ``broken`` says why some modules are broken.
        """
        self.stop_worker()
        own, theirs = socket.socketpair()
        worker = self._worker = _Worker(own, self._new_file(), self._new_file())
        try:
            with theirs:
                self.start()
                number = self._ask("start", theirs, worker.log, worker.stack)
            wire = Wire(own.fileno())
            if "ready" not in wire.receive(time.monotonic() + START_LIMIT):
                raise EOFError
        except (OSError, EOFError) as error:
            raise LauncherError(f"a worker did not start: {self._why(error)}") from error
        # Inside bubblewrap, processes have other numbers than outside.
        process = 0 if self.level.bubblewrap else int(number)
        session = Session(wire, self.seconds, on_hang, self.how_it_ended, broken, process)
        self._session = session
        return session

    def _new_file(self) -> IO[bytes]:
        """Create an unnamed temporary file, in memory if possible."""
        if hasattr(os, "memfd_create"):  # saves a tenth of the cost of a worker
            return open(os.memfd_create("output"), "w+b", buffering=0)  # noqa: PTH123
        return tempfile.TemporaryFile(buffering=0)

    def _why(self, error: Exception) -> str:
        """Return what a process printed before it failed, or else the error that we noticed."""
        logs = [self._log] if self._worker is None else [self._worker.log, self._log]
        return next(filter(None, map(_text, logs)), repr(error))

    def stack(self) -> str:
        """Return a stack trace of the student's code, which faulthandler writes in the worker."""
        if self._worker is None:
            return ""
        with contextlib.suppress(OSError, EOFError):  # the launcher is gone
            self._ask("stack")
        for _ in range(20):
            time.sleep(0.01)
            if _text(self._worker.stack):
                break
        time.sleep(0.01)  # wait until the rest is written
        return _text(self._worker.stack)

    def how_it_ended(self) -> str:
        """Explain to the student in one sentence why the worker ended."""
        try:
            answer = self._ask("wait")
        except (OSError, EOFError) as error:
            raise LauncherError(f"the launcher is gone: {self._why(error)}") from error
        if answer == "alive":
            return "the process stopped answering: the code closed its connection to the checks"
        code = int(answer)
        if code == -signal.SIGKILL:
            raise LauncherError("a worker was killed from outside. Is the machine out of memory?")
        if code == -signal.SIGXCPU:
            return "the process ended early: it had used up its processor time"
        return how_it_ended(code)

    def stop_worker(self) -> str:
        """End the current worker, if there is one, and return what the student's code printed."""
        if self._worker is None:
            return ""
        if self._session is not None:
            self._session.end()  # the next worker may get the same descriptors
        worker, self._worker = self._worker, None
        printed = _text(worker.log)
        for end in worker:
            end.close()
        if self._process is not None:
            with contextlib.suppress(OSError, EOFError):  # the launcher and its worker are gone
                self._ask("stop")
        if self.fresh:
            self._end()
        return printed

    def close(self) -> None:
        """End the process and its current worker."""
        self.stop_worker()
        self._end()
        self._log.close()

    def _end(self) -> None:
        """Close the connection to the launcher, which then ends its worker and itself."""
        if self._process is not None:
            with contextlib.suppress(OSError):
                self._control.shutdown(socket.SHUT_RDWR)
            self._control.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(END_LIMIT)
            self._process.kill()
            self._process.wait()
            self._process = None


def _text(file: IO[bytes]) -> str:
    """Return the beginning of what a process has written to a file."""
    written = os.pread(file.fileno(), 8000, 0).replace(b"\0", b"")  # NUL fills gaps in the file
    return written.decode("utf-8", errors="replace").strip()


def _command(config: dict[str, Any], level: Level) -> list[str]:
    """Build the command line of a launcher, inside bubblewrap if ``level`` includes it.

    Bubblewrap can isolate a process only when it starts. The launcher can then read only a few
    paths, and has no network access.
    """
    code = f"import sys; sys.path.append({str(ROOT)!r}); "
    code += "from autograder.isolation import worker; worker.main(sys.argv[1])"
    python = os.path.realpath(sys.executable)
    command = [python, "-I", "-S", "-B", "-c", code, json.dumps(config)]
    if not level.bubblewrap:
        return command
    walls = [shutil.which("bwrap") or "bwrap", "--unshare-all", "--uid", "65534", "--gid", "65534"]
    walls += ["--die-with-parent", "--cap-drop", "ALL", "--dev", "/dev", "--chdir", "/"]
    for path in [*config["readable"], python, str(ROOT / "autograder")]:
        walls += ["--ro-bind-try", path, path]
    return [*walls, "--remount-ro", "/", *command]


def python_folders() -> list[str]:
    """List the folders and shared libraries of Python, which code in the sandbox must read."""
    paths = {sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib")}
    if library := sysconfig.get_config_var("LIBDIR"):
        paths |= {str(path) for path in Path(library).glob("libpython*")}
    return sorted(paths)
