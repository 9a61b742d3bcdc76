"""The process that holds the student's code.

A template without student code waits for orders on a control socket: "start" forks a worker, which
goes behind its walls and only then imports what was handed in; "stack" has one write its stack;
"status" asks how one ended by itself, "stop" ends it. The template is trusted; from the import on,
a worker is not.
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
from pathlib import Path
from typing import Any

from autograder.checks.printed import CappedText
from autograder.isolation import sandbox
from autograder.isolation.server import Server
from autograder.isolation.wire import Wire

# What engines tend to import: once in the template, rather than in every worker.
PRELOADED = "math random dataclasses typing collections.abc functools itertools enum copy heapq"


def main(text: str) -> None:
    """Be the template: fork a worker at every "start", until the control socket ends."""
    config = json.loads(text)
    sys.argv[:], sys.orig_argv[:] = [""], []  # they tell where everything lies
    level = sandbox.Level(**config["level"])
    sys.path[:] = [path for path in sys.path if path != config["root"]] + config["folders"]
    sys.pycache_prefix = config["bytecode"]
    for add in (site.setquit, site.setcopyright, site.sethelper):  # what every Python has built in
        add()
    for name in PRELOADED.split() if config["preload"] else ():
        importlib.import_module(name)
    for folder in sorted({path.name for f in config["folders"] for path in Path(f).glob("ch??_*")}):
        importlib.import_module(folder)  # a folder without code of its own; its place is then known
        importlib.util.find_spec(f"{folder}.nothing")
    rules = sandbox.landlock_rules(config["readable"]) if level.landlock else None
    for name in [name for name in sys.modules if name.partition(".")[0] == "autograder"]:
        del sys.modules[name]  # it is not there for those who import it
    gc.freeze()
    control = socket.socket(fileno=config["control"])
    workers: set[int] = set()
    while True:
        orders, descriptors, _, _ = socket.recv_fds(control, 1024, 3)
        for order in orders.splitlines():  # each comes whole: they are short
            what, _, number = order.partition(b" ")
            if what == b"start":
                worker = os.fork()
                if worker == 0:
                    work(config, level, rules, *descriptors)
                workers.add(worker)
                for descriptor in descriptors:
                    os.close(descriptor)
                control.send(b"%d\n" % worker)
            elif what == b"stack":
                os.kill(int(number), signal.SIGUSR1)
            elif what == b"status":
                code = _exit_code(int(number), config["seconds"])
                control.send(b"alive\n" if code is None else b"%d\n" % code)
                workers.remove(int(number))
            elif int(number) in workers:
                workers.remove(int(number))
                _kill(int(number))
        if not orders:
            for worker in workers:
                _kill(worker)
            return


def _kill(worker: int) -> None:
    """End a worker, and what it may have started where no wall keeps it from that."""
    for kill in (os.killpg, os.kill):
        with contextlib.suppress(ProcessLookupError):  # it may have no group of its own yet
            kill(worker, signal.SIGKILL)
    os.waitpid(worker, 0)


def _exit_code(worker: int, seconds: float) -> int | None:
    """Return the exit code of a worker that has closed its wire, a signal as a negative number.

    Return None for one that does not end within a second; it is killed.
    """
    for _ in range(100):
        ended, status, used = os.wait4(worker, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            # Beyond its limit of processor time a process is killed: that was its own doing.
            out_of_time = used.ru_utime + used.ru_stime >= seconds
            return -signal.SIGXCPU if code == -signal.SIGKILL and out_of_time else code
        time.sleep(0.01)
    _kill(worker)
    return None


def work(
    config: dict[str, Any],
    level: sandbox.Level,
    rules: int | None,
    wire_end: int,
    log: int,
    stack: int,
) -> None:
    """Be a worker: go behind the walls, say so, and serve until the wire ends.

    What it prints goes to the log, and its stack to the other file, when it is asked for: both are
    this worker's own, so that nothing of it can be taken for another's.
    """
    try:
        os.setsid()
        os.dup2(log, 1)
        os.dup2(log, 2)
        _close_all_but(wire_end, stack, rules)
        sys.stdout = sys.stderr = CappedText(_log)
        faulthandler.register(signal.SIGUSR1, file=stack, all_threads=False)
        wire = Wire(wire_end)
        sandbox.enter(level, rules, config["seconds"])
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    try:
        wire.send({"ready": True})
        Server(wire, [Path(folder) for folder in config["engine"]]).serve()
    finally:
        os._exit(0)  # nothing that the student's code has left to be done at the end is done


def _close_all_but(*kept: int | None) -> None:
    first = 3
    for descriptor in sorted(number for number in kept if number is not None):
        os.closerange(first, descriptor)
        first = descriptor + 1
    os.closerange(first, 256)


def _log(text: str) -> None:
    os.write(1, text.encode("utf-8", errors="backslashreplace"))
