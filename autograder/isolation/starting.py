"""Start template processes, which fork the workers that run student code.

The grader needs a template for each chapter and submission. A new Python process needs 70 ms to
start and to import the modules of a template. To save time, the grader starts one helper process
that imports these modules once and then forks a template for each request. The helper process never
runs any student code, and it ends when nobody can send it requests anymore. On a system where it
cannot be used, each template is started as a new Python process.
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
    """Ask the helper process to fork a template, which later forks the workers for student code.

    ``control`` is the socket on which the template receives its requests. ``log`` is the file
    descriptor for the template's output.

    Returns:
        True if the request was sent, or False if no helper process is available. In that case,
        start the template in another way.
    """
    for waiting in _waiting:
        with contextlib.suppress(OSError):
            socket.send_fds(waiting, [json.dumps(config).encode()], [control.fileno(), log])
            return True
    return False


def start_process(
    config: dict[str, Any], level: Level, control: socket.socket, log: int
) -> subprocess.Popen[bytes]:
    """Start a template, a new Python process that later forks the workers for student code.

    If ``level`` includes bubblewrap, the template runs inside it. Forking a template would be
    faster, but bubblewrap can isolate a process only when it starts.
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
