"""Run the student's code in worker processes.

The program starts as a template, a process without student code. The template waits for orders on a
control socket:

- "code" provides the compiled code of modules. The template loads the code but never runs it.
- "start" forks a worker, which enters the sandbox before it imports the submission.
- "stack" makes a worker write a stack trace.
- "status" asks how a worker ended.
- "stop" ends a worker.

The template is trusted. A worker is no longer trusted once it has imported student code.
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
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from autograder.checks.printed import CappedText
from autograder.isolation import sandbox
from autograder.isolation.compiled import CompiledFinder
from autograder.isolation.server import Server
from autograder.isolation.wire import Wire

# Modules that engines often import. The template imports them once for all workers.
PRELOADED = "__future__ math random dataclasses typing collections.abc functools itertools enum "
PRELOADED += "copy heapq"

# The descriptors of each worker, besides 1 and 2 for its output. They are below the limit of 32.
RULES, WIRE, STACK = 29, 30, 31


def main(text: str) -> None:
    """Run the template: fork a worker for each "start" until the control socket is closed."""
    config = json.loads(text)
    # Its number depends on the runner's open files. A low one is none of the numbers above, and
    # workers close it.
    control = socket.socket(fileno=os.dup(config["control"]))
    os.close(config["control"])
    sys.argv[:], sys.orig_argv[:] = [""], []  # these reveal where files are
    level = sandbox.Level(**config["level"])
    sys.path[:] = [path for path in sys.path if path != config["root"]] + config["folders"]
    sys.pycache_prefix = "/nowhere"  # bytecode beside the files that were handed in is not used
    for add in (site.setquit, site.setcopyright, site.sethelper):  # built-ins that python -S lacks
        add()
    for name in PRELOADED.split() if config["preload"] else ():
        importlib.import_module(name)
    for folder in sorted({path.name for f in config["folders"] for path in Path(f).glob("ch??_*")}):
        importlib.import_module(folder)  # has no code; Python then knows its place
        importlib.util.find_spec(f"{folder}.nothing")
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
    """Carry out the orders from ``control`` until the socket is closed.

    ``workers`` contains the process numbers of the running workers and is kept up to date.
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
    """Kill ``worker``.

    Without a sandbox, the worker may have started other processes. These are killed too.
    """
    for kill in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError):  # it may not have its own group yet
            kill(worker, signal.SIGKILL)
    os.waitpid(worker, 0)


def _exit_code(worker: int, seconds: float) -> int | None:
    """Return the exit code of ``worker``, which has closed its wire. It is negative for a signal.

    If the worker does not end within ``seconds``, kill it and return None.
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
    """Run a worker: enter the sandbox, report that it is ready, and serve until the wire is closed.

    Printed output goes to ``log``, and a requested stack trace goes to ``stack``. Every worker has
    two files of its own, so its output cannot be mistaken for that of another worker.
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
