"""Start and control the process from which a worker is forked for every check.

The workers run the student's code. This module is on the trusted side: it starts the template
process, requests workers from it, and ends them.
"""

from __future__ import annotations

import contextlib
import marshal
import os
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, NoReturn

from autograder.checks.forked import how_it_ended
from autograder.diagnosis.faults import GraderFault
from autograder.isolation.handles import Session
from autograder.isolation.patience import Patience
from autograder.isolation.sandbox import Level
from autograder.isolation.starting import (
    SYSTEM_LIBRARIES,
    fork_template,
    python_folders,
    start_process,
)
from autograder.isolation.wire import Wire
from autograder.manifest import ROOT
from autograder.message import Message

START_LIMIT = 20.0  # seconds for our own process to start on a busy machine
END_LIMIT = 1.0  # seconds for it to end


class TemplateError(GraderFault):
    """Raised when a worker process does not start and the student's code is not the cause."""


@dataclass
class _Worker:
    socket: socket.socket
    log: int  # a descriptor
    stack: int  # a descriptor
    number: int = 0  # its process ID, once the template has answered

    def close(self) -> None:
        self.socket.close()
        os.close(self.log)
        os.close(self.stack)


class Template:
    """A process that forks a worker for each check, but never runs any student code itself.

    A worker looks for modules in the standard library, then in ``engine``, and then in ``probes``.
    ``engine`` lists the folders that contain the student's chapters. The folder ``probes`` contains
    the helper functions of checks that must run in a worker. ``folder`` is for temporary files, and
    ``seconds`` is how long a worker may take to answer.

    If ``fresh`` is set, each worker gets a template of its own. That is slower, but without seccomp
    it is the only way to keep one worker from affecting the next.
    """

    def __init__(
        self,
        level: Level,
        engine: Sequence[str],
        probes: str,
        folder: Path,
        seconds: float,
        *,
        fresh: bool = False,
    ) -> None:
        self.level = level
        self.engine = engine
        self.folders = [*engine, probes]
        self.seconds = seconds
        self.fresh = fresh or (not level.seccomp and level.is_sandbox)
        self._own = folder
        self._compiled: dict[str, bytes] = {}
        self._log = self._new_file()  # output of the template itself
        self._process: subprocess.Popen[bytes] | None = None
        self._control: socket.socket | None = None
        self._answers: BinaryIO | None = None
        self._worker: _Worker | None = None
        self._next: _Worker | None = None

    def start_worker(
        self, on_hang: Callable[[], NoReturn], broken: Mapping[str, Message] | None = None
    ) -> Session:
        """Start a session with a worker process that has not run any student code yet.

        Unless ``fresh`` is set, also request the worker for the next check, so that it starts in
        the background. ``broken`` maps each student module that cannot be imported to the reason.

        Raises:
            TemplateError: The worker did not start.
        """
        self.stop_worker()
        try:
            self.warm_up()
            self._worker, self._next = self._numbered_next(), None
            if not self.fresh:
                self.warm_up()
            wire = Wire(self._worker.socket.fileno())
            if "ready" not in wire.receive(time.monotonic() + START_LIMIT):
                raise EOFError
        except (OSError, EOFError, ValueError) as error:
            raise TemplateError(f"a worker did not start: {self.printed() or error!r}") from error
        deadline = time.monotonic() + self.seconds
        patience = Patience(0 if self.level.bubblewrap else self._worker.number, self.seconds)
        return Session(wire, deadline, on_hang, self.how_it_ended, broken, patience)

    def warm_up(self) -> None:
        """Request the next worker process in advance, without waiting until it is ready.

        It then starts in the background, for example while pytest collects the checks.
        """
        if self._control is None:
            self._start()
        if self._next is None:
            self._next = self._order()

    def _order(self) -> _Worker:
        """Ask the template process to fork a worker, without waiting for the answer."""
        assert self._control is not None
        own, theirs = socket.socketpair()
        worker = _Worker(own, self._new_file(), self._new_file())
        with theirs:
            ends = [theirs.fileno(), worker.log, worker.stack]
            socket.send_fds(self._control, [b"start\n"], ends)
        return worker

    def _new_file(self) -> int:
        """Create an unnamed temporary file for a worker's output, and return its file descriptor.

        The file is in memory if the system allows that.
        """
        if hasattr(os, "memfd_create"):  # saves a tenth of the cost of a worker
            return os.memfd_create("output")
        descriptor, path = tempfile.mkstemp(dir=self._own)
        Path(path).unlink()
        return descriptor

    def _numbered_next(self) -> _Worker:
        """Return the worker that was requested in advance, as soon as its process ID is known."""
        assert self._next is not None
        if not self._next.number:
            self._next.number = int(self._answer())
        return self._next

    def _answer(self) -> bytes:
        assert self._answers is not None
        return self._answers.readline().strip()

    def hand_over(self, compiled: Mapping[str, bytes]) -> None:
        """Pass the bytecode of the student's modules to all workers that start from now on.

        The workers can then import these modules without compiling them again.
        """
        self._compiled = dict(compiled)
        if self._control is not None:
            self._discard_next()  # because it was forked without this code
            self._send_code()

    def _send_code(self) -> None:
        assert self._control is not None
        with os.fdopen(self._new_file(), "w+b") as file:
            marshal.dump(self._compiled, file)
            file.seek(0)
            socket.send_fds(self._control, [b"code\n"], [file.fileno()])

    def _discard_next(self) -> None:
        if self._next is not None:
            worker, self._next = self._numbered_next(), None
            self._release(worker)

    def _release(self, worker: _Worker) -> None:
        worker.close()
        assert self._control is not None
        with contextlib.suppress(OSError):
            self._control.send(b"stop %d\n" % worker.number)

    def printed(self) -> str:
        """Return what the student's code has printed in the current worker process.

        If no worker is running, return the output of the template process, which forks the workers.
        That output may contain an error message.
        """
        log = self._log if self._worker is None else self._worker.log
        printed = os.pread(log, 8000, 0).replace(b"\0", b"")  # NUL fills gaps in the file
        return printed.decode("utf-8", errors="replace").strip()

    def stack(self) -> str:
        """Return a stack trace of the student's code, to show where it is stuck.

        Python's faulthandler writes the trace in the worker process.
        """
        assert self._control is not None
        assert self._worker is not None
        self._control.send(b"stack %d\n" % self._worker.number)
        for _ in range(20):
            time.sleep(0.01)
            if os.pread(self._worker.stack, 1, 0):
                break
        time.sleep(0.01)  # wait until the rest is written
        return os.pread(self._worker.stack, 8000, 0).decode("utf-8", errors="replace")

    def how_it_ended(self) -> str:
        """Explain to the student in one sentence why the process that ran the student's code ended.

        For example, the code may have exceeded its limit on processor time.

        Raises:
            TemplateError: The worker was killed from outside, perhaps because the machine ran out
                of memory. Code inside the sandbox cannot cause this.
        """
        assert self._control is not None
        assert self._worker is not None
        try:
            if self._next is not None:
                self._numbered_next()  # the template answers in order
            self._control.send(b"status %d\n" % self._worker.number)
            answer = self._answer()
            code = 0 if answer == b"alive" else int(answer)
        except (OSError, ValueError) as error:
            raise TemplateError(f"the template is gone: {self.printed() or error!r}") from error
        if code == -signal.SIGKILL:
            raise TemplateError("a worker was killed from outside. Is the machine out of memory?")
        if answer == b"alive":
            return "the process stopped answering: the code closed its connection to the checks"
        if code == -signal.SIGXCPU:
            return "the process ended early: it had used up its processor time"
        return how_it_ended(code)

    def stop_worker(self) -> None:
        """End the worker process of the current check, if one is running."""
        if self._worker is None:
            return
        worker, self._worker = self._worker, None
        self._release(worker)
        if self.fresh:
            self._end()

    def close(self) -> None:
        """End the template process, which forks the workers, and its current worker."""
        self.stop_worker()
        self._end()
        os.close(self._log)

    def _start(self) -> None:
        self._control, theirs = socket.socketpair()
        self._control.settimeout(START_LIMIT)
        self._answers = self._control.makefile("rb")
        config = {
            "root": str(ROOT),
            "engine": self.engine,
            "folders": self.folders,
            "level": vars(self.level),
            "readable": [*SYSTEM_LIBRARIES, *python_folders(), *self.folders],
            "seconds": int(self.seconds) + 2,
            "preload": not self.fresh,
        }
        with theirs:
            forked = not self.fresh and not self.level.bubblewrap
            if not (forked and fork_template(config, theirs, self._log)):
                self._process = start_process(config, self.level, theirs, self._log)
        if self._compiled:
            self._send_code()

    def _end(self) -> None:
        if self._next is not None:
            self._next.close()
            self._next = None
        if self._control is None:
            return
        assert self._answers is not None
        self._control.settimeout(END_LIMIT)
        with contextlib.suppress(OSError):
            self._control.shutdown(socket.SHUT_WR)  # the template then ends its worker and itself
            while self._control.recv(1024):  # until it has done so
                pass
        self._answers.close()
        self._control.close()
        self._control = None
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None
