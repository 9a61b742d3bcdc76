"""Start a template: the process from which workers for student code are forked.

A new Python process needs 70 ms to start and to import the modules of a template. The grader needs
a template for each chapter and submission. To save time, it starts one helper process that imports
these modules and then forks a template for each request. The helper never runs any student code. It
ends once every process that could send it requests has ended. Where forking is not possible, the
template is started as a new Python process.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import socket
import subprocess
import sys
import sysconfig
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT

SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/etc/ld.so.cache", "/dev/null")

# The connection to the waiting process. Judges inherit it when they are forked.
_waiting: list[socket.socket] = []


def start_waiting() -> None:
    """Start a helper process that forks a template process for each request it receives.

    Each template in turn forks the workers that run student code. The requests arrive on a socket
    that preserves message boundaries. If the system has no such sockets, no helper process is
    started. Each template is then started as a new Python process.
    """
    with contextlib.suppress(OSError, AttributeError):
        own, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            _start(_python("start_templates", str(theirs.fileno())), theirs, subprocess.DEVNULL)
        _waiting.append(own)


def fork_template(config: dict[str, Any], control: socket.socket, log: int) -> bool:
    """Ask the waiting helper process to fork a template, the process that later forks workers.

    ``control`` is the socket on which the template will receive its requests. ``log`` is the file
    descriptor to which the template's output goes.

    Returns:
        True if the request was sent. If not, no helper process is waiting, and the template must be
        started in another way.
    """
    for waiting in _waiting:
        with contextlib.suppress(OSError):
            socket.send_fds(waiting, [json.dumps(config).encode()], [control.fileno(), log])
            return True
    return False


def start_process(
    config: dict[str, Any], level: Level, control: socket.socket, log: int
) -> subprocess.Popen[bytes]:
    """Start a template as a new Python process, inside bubblewrap if ``level`` asks for it.

    A template forks the workers that run student code. Starting a new process takes longer than
    forking one, but a process can enter bubblewrap only when it starts.
    """
    command = _python("main", json.dumps({**config, "control": control.fileno()}))
    if level.bubblewrap:
        visible = [*config["readable"], command[0], str(ROOT / "autograder")]
        command = [*_bubblewrap(visible), *command]
    return _start(command, control, log)


def python_folders() -> list[str]:
    """List the standard library's folders and the shared libraries that Python needs.

    A student's code must be able to read them inside the sandbox.
    """
    paths = {sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib")}
    if library := sysconfig.get_config_var("LIBDIR"):
        paths |= {str(path) for path in Path(library).glob("libpython*")}
    return sorted(paths)


def _start(command: list[str], end: socket.socket, output: int) -> subprocess.Popen[bytes]:
    """Start a trusted helper process that is connected to this one by a socket.

    ``end`` is the helper's end of the socket, and ``output`` receives everything that it prints.
    """
    return subprocess.Popen(
        command,
        cwd="/",
        env={"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"},
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=output,
        pass_fds=[end.fileno()],
    )


def _python(function: str, argument: str) -> list[str]:
    """Build the command that calls a function of the module ``worker`` in a new Python process."""
    code = f"import sys; sys.path.append({str(ROOT)!r}); "
    code += f"from autograder.isolation import worker; worker.{function}(sys.argv[1])"
    return [os.path.realpath(sys.executable), "-I", "-S", "-B", "-c", code, argument]


def _bubblewrap(visible: Sequence[str]) -> list[str]:
    """Build the command-line prefix that runs a program inside bubblewrap.

    The program can read only the ``visible`` paths, and it has no network access.
    """
    program = shutil.which("bwrap") or "bwrap"
    command = [program, "--unshare-all", "--uid", "65534", "--gid", "65534", "--die-with-parent"]
    command += ["--cap-drop", "ALL", "--dev", "/dev", "--chdir", "/"]
    for path in visible:
        command += ["--ro-bind-try", path, path]
    return [*command, "--remount-ro", "/"]
