"""The program that runs in template processes and in the workers for student code.

The program starts as a template, without any student code, and waits for requests on a control
socket:

- "code" passes the bytecode of some modules to the template, which loads it but never runs it.
- "start" forks a worker, which enters the sandbox before it imports the submission.
- "stack" makes a worker write a stack trace.
- "status" asks how a worker ended.
- "stop" ends a worker.

The template is trusted. A worker is trusted only until it imports the student's code.
"""

from __future__ import annotations

import contextlib
import faulthandler
import gc
import importlib
import importlib.util
import json
import marshal
import os
import signal
import site
import socket
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from autograder.at_home.restrictions import StudentsCode, restrict
from autograder.checks.printed import CappedText
from autograder.diagnosis.faults import GOING_FURTHER
from autograder.isolation import sandbox
from autograder.isolation.compiled import CompiledFinder
from autograder.isolation.server import Server
from autograder.isolation.wire import Wire

# Engines often import these modules, so the template imports them once for all workers.
PRELOADED = "__future__ math random dataclasses typing collections.abc functools itertools enum "
PRELOADED += "copy heapq"

# A worker has these descriptors, besides 1 and 2 for its output. The limit is 32.
RULES, WIRE, STACK = 29, 30, 31


def start_templates(number: str) -> None:
    """Wait for requests on a socket, and fork a template process for each of them.

    A template forks the workers that run student code. ``number`` is the socket's file descriptor,
    written as a string. The function returns when every sender has closed the socket.
    """
    orders = socket.socket(fileno=int(number))
    _preload()
    gc.freeze()  # so that collecting garbage in a template does not copy the memory that it shares
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for templates
    while True:
        text, descriptors, _, _ = socket.recv_fds(orders, 1 << 16, 2)
        if not text:
            return
        if os.fork() == 0:
            orders.close()
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            control, log = descriptors
            for output in (1, 2):
                os.dup2(log, output)
            os.close(log)
            try:
                run_template({**json.loads(text), "control": control})
            except BaseException:
                traceback.print_exc()
            finally:
                os._exit(0)  # at once, because nobody waits for its exit code
        for descriptor in descriptors:
            os.close(descriptor)


def _preload() -> None:
    for name in PRELOADED.split():
        importlib.import_module(name)


def _packages(folders: Sequence[str]) -> list[str]:
    """List the packages in the folders: the chapters, and what goes further in them."""
    below = [(Path(folder), pattern) for folder in folders for pattern in ("", f"/{GOING_FURTHER}")]
    found = {
        ".".join(path.relative_to(folder).parts)
        for folder, pattern in below
        for path in folder.glob(f"ch??_*{pattern}")
    }
    return sorted(found)


def main(text: str) -> None:
    """Run this process as a template, which forks the workers for student code.

    ``text`` is the configuration of the template as JSON.
    """
    run_template(json.loads(text))


def run_template(config: dict[str, Any]) -> None:
    """Run this process as a template, which forks a worker for student code on each request.

    The template restricts itself before it forks the first worker, so that all workers inherit the
    restrictions. It ends when the control socket closes.
    """
    # The number of this descriptor depends on the files that the runner has open. We replace it by
    # a low one, because that cannot be one of the numbers above, and because workers close it.
    control = socket.socket(fileno=os.dup(config["control"]))
    os.close(config["control"])
    sys.argv[:], sys.orig_argv[:] = [""], []  # these reveal where files are
    level = sandbox.Level(**config["level"])
    sys.path[:] = [path for path in sys.path if path != config["root"]] + config["folders"]
    sys.pycache_prefix = "/nowhere"  # bytecode beside the files that were handed in is not used
    for add in (site.setquit, site.setcopyright, site.sethelper):  # built-ins that python -S lacks
        add()
    if config["preload"]:
        _preload()
    for package in _packages(config["folders"]):
        importlib.import_module(package)  # it has no code, but Python then remembers where it is
        importlib.util.find_spec(f"{package}.nothing")
    restrict(StudentsCode(map(Path, config["engine"]), {}))
    if level.landlock:
        os.dup2(sandbox.landlock_rules(config["readable"]), RULES)
    sandbox.confine(level, RULES if level.landlock else None)
    faulthandler.register(signal.SIGUSR1, file=STACK, all_threads=False)
    work = partial(_work, config, level, sandbox.Filter() if level.seccomp else None)
    for name in [name for name in sys.modules if name.partition(".")[0] == "autograder"]:
        del sys.modules[name]  # student code must not find it
    gc.freeze()
    workers: set[int] = set()
    try:
        _obey(control, work, config["seconds"], workers)
    except ConnectionError:
        pass  # the runner was killed
    finally:
        for worker in workers:
            _kill(worker)


def _obey(
    control: socket.socket, work: Callable[..., None], seconds: float, workers: set[int]
) -> None:
    """Carry out requests to the template process until the control socket closes.

    For example, the request "start" forks a worker for student code. The set ``workers`` is updated
    to contain the process IDs of the running workers.
    """
    while True:
        orders, descriptors, _, _ = socket.recv_fds(control, 1024, 3)
        for order in orders.splitlines():  # a short order arrives whole
            what, _, number = order.partition(b" ")
            if what == b"start":
                worker = os.fork()
                if worker == 0:
                    work(*descriptors)
                workers.add(worker)
                for descriptor in descriptors:
                    os.close(descriptor)
                control.send(b"%d\n" % worker)
            elif what == b"code":
                with os.fdopen(descriptors[0], "rb") as file:
                    sys.meta_path.insert(0, CompiledFinder(marshal.load(file)))
                gc.freeze()
            elif what == b"stack":
                os.kill(int(number), signal.SIGUSR1)
            elif what == b"status":
                workers.remove(int(number))
                code = _exit_code(int(number), seconds)
                control.send(b"alive\n" if code is None else b"%d\n" % code)
            elif int(number) in workers:
                workers.remove(int(number))
                _kill(int(number))
        if not orders:
            return


def _kill(worker: int) -> None:
    """Kill a worker process, along with any processes that the student's code has started.

    Student code can start processes only if there is no sandbox.
    """
    for kill in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError):  # it may not have its own group yet
            kill(worker, signal.SIGKILL)
    os.waitpid(worker, 0)


def _exit_code(worker: int, seconds: float) -> int | None:
    """Wait for a worker that has closed its connection to the checks, and return its exit code.

    If a signal ended the worker, return the negated signal number. If the worker does not end
    within a second, kill it and return None.
    """
    for _ in range(100):
        ended, status, used = os.wait4(worker, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            # The kernel kills a process that exceeds its processor time.
            out_of_time = used.ru_utime + used.ru_stime >= seconds
            return -signal.SIGXCPU if code == -signal.SIGKILL and out_of_time else code
        time.sleep(0.01)
    _kill(worker)
    return None


def _work(
    config: dict[str, Any],
    level: sandbox.Level,
    allowed: sandbox.Filter | None,
    wire_end: int,
    log: int,
    stack: int,
) -> None:
    """Turn this forked process into a worker, which enters the sandbox and then serves the checks.

    What the student's code prints goes to the file ``log``, and a stack trace goes to ``stack``.
    Each worker has its own two files, so the output of different workers is never mixed.
    """
    try:
        os.setsid()
        for old, new in ((log, 1), (log, 2), (wire_end, WIRE), (stack, STACK)):
            os.dup2(old, new)
        os.closerange(3, RULES if level.landlock else WIRE)
        os.closerange(STACK + 1, 256)
        sys.stdout = sys.stderr = CappedText(_log)
        wire = Wire(WIRE, patient=True)
        sandbox.enter(RULES if level.landlock else None, allowed, config["seconds"])
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    try:
        wire.send({"ready": True})
        Server(wire, [Path(folder) for folder in config["engine"]]).serve()
    finally:
        os._exit(0)  # without the exit handlers of the student's code


def _log(text: str) -> None:
    os.write(1, text.encode("utf-8", errors="backslashreplace"))
