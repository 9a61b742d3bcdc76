"""The program that runs in launchers and in the workers for student code.

It starts as a launcher, without any student code, and answers the requests that are described in
``launcher``. A worker is forked from it and enters the sandbox before it imports the submission.
The launcher is trusted. A worker is trusted only until it imports the student's code.
"""

from __future__ import annotations

import contextlib
import faulthandler
import gc
import importlib
import importlib.util
import json
import os
import signal
import site
import socket
import sys
import time
import traceback
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from autograder.at_home.restrictions import StudentsCode, restrict
from autograder.checks.printed import CappedText
from autograder.diagnosis.faults import GOING_FURTHER
from autograder.isolation import sandbox
from autograder.isolation.student_side import StudentSide
from autograder.isolation.wire import Wire

# Engines often import these modules, so the launcher imports them once for all workers.
PRELOADED = "math random dataclasses typing collections.abc functools itertools enum copy heapq"

# A worker has these descriptors, besides 1 and 2 for its output. The limit is 32.
RULES, WIRE, STACK = 29, 30, 31


def main(text: str) -> None:
    """Run this process as a launcher until the control socket closes.

    ``text`` is its configuration as JSON. It restricts itself before it forks the first worker, so
    that all workers inherit the restrictions.
    """
    config = json.loads(text)
    # The number of this descriptor depends on the files that the runner has open. We replace it by
    # a low one, because that cannot be one of the numbers above, and because workers close it.
    control = socket.socket(fileno=os.dup(config["control"]))
    os.close(config["control"])
    level = sandbox.Level(**config["level"])
    _prepare_python(config)
    rules = RULES if level.landlock else None
    if rules:
        os.dup2(sandbox.landlock_rules(config["readable"]), rules)
    sandbox.confine(level, rules)
    faulthandler.register(signal.SIGUSR1, file=STACK, all_threads=False)
    for name in [name for name in sys.modules if name.partition(".")[0] == "autograder"]:
        del sys.modules[name]  # student code must not find it
    gc.freeze()
    with contextlib.suppress(ConnectionError):  # the runner was killed
        _answer(control, partial(_work, config, level, rules), config["seconds"])


def _prepare_python(config: dict[str, Any]) -> None:
    """Import what all workers need, and limit imports and operations as at home."""
    sys.argv[:], sys.orig_argv[:] = [""], []  # these reveal where files are
    sys.path[:] = [path for path in sys.path if path != config["root"]] + config["folders"]
    for add in (site.setquit, site.setcopyright, site.sethelper):  # built-ins that python -S lacks
        add()
    for name in PRELOADED.split():
        importlib.import_module(name)
    for folder in map(Path, config["folders"]):
        for path in sorted([*folder.glob("ch??_*"), *folder.glob(f"ch??_*/{GOING_FURTHER}")]):
            package = ".".join(path.relative_to(folder).parts)
            importlib.import_module(package)  # it has no code, but Python remembers where it is
            importlib.util.find_spec(f"{package}.nothing")
    sys.pycache_prefix = config["compiled"]  # bytecode beside the students' files is never used
    restrict(StudentsCode(map(Path, config["engine"]), {}))


def _answer(control: socket.socket, work: Callable[..., None], seconds: float) -> None:
    """Answer requests to the launcher until the control socket closes, then end the worker."""
    worker: int | None = None
    try:
        while True:
            request, descriptors, _, _ = socket.recv_fds(control, 100, 3)
            answer = "done"
            match request:
                case b"start":
                    worker = os.fork()
                    if worker == 0:
                        work(*descriptors)
                    answer = str(worker)
                case b"stack" if worker:
                    os.kill(worker, signal.SIGUSR1)
                case b"wait" if worker:
                    answer, worker = _exit_code(worker, seconds), None
                case b"stop" if worker:
                    _kill(worker)
                    worker = None
                case b"":
                    return
            for descriptor in descriptors:
                os.close(descriptor)
            control.send(answer.encode())
    finally:
        if worker:
            _kill(worker)


def _kill(worker: int) -> None:
    """Kill a worker process, and what the student's code has started if there is no sandbox."""
    for kill in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError):  # it may not have its own group yet
            kill(worker, signal.SIGKILL)
    os.waitpid(worker, 0)


def _exit_code(worker: int, seconds: float) -> str:
    """Wait for a worker that has closed its connection to the checks, and return its exit code.

    It is the negated number of a signal that ended the worker. If the worker does not end within a
    second, kill it and return "alive".
    """
    for _ in range(100):
        ended, status, used = os.wait4(worker, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            # The kernel kills a process that exceeds its processor time.
            out_of_time = used.ru_utime + used.ru_stime >= seconds
            return str(-signal.SIGXCPU if code == -signal.SIGKILL and out_of_time else code)
        time.sleep(0.01)
    _kill(worker)
    return "alive"


def _work(
    config: dict[str, Any],
    level: sandbox.Level,
    rules: int | None,
    wire_end: int,
    log: int,
    stack: int,
) -> None:
    """Turn this forked process into a worker, which enters the sandbox and then serves the checks.

    What the student's code prints goes to the file ``log``, and a stack trace goes to ``stack``.
    """
    try:
        os.setsid()
        for old, new in ((log, 1), (log, 2), (wire_end, WIRE), (stack, STACK)):
            os.dup2(old, new)
        os.closerange(3, rules or WIRE)
        os.closerange(STACK + 1, 256)
        sys.stdout = sys.stderr = CappedText(
            lambda text: os.write(1, text.encode("utf-8", errors="backslashreplace"))
        )
        wire = Wire(WIRE, patient=True)
        sandbox.enter(level, rules, config["seconds"])
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    try:
        wire.send({"ready": True})
        StudentSide(wire, [Path(folder) for folder in config["engine"]]).serve()
    finally:
        os._exit(0)  # without the exit handlers of the student's code
