"""Start a launcher, the process that forks a worker for each check.

Each launcher is a new Python process. Forking it from a process that waits with the same modules
saves no time that can be measured when a whole submission is graded.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import Any

from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT

SYSTEM_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/etc/ld.so.cache", "/dev/null")


def start_process(
    config: dict[str, Any], level: Level, control: socket.socket, log: int
) -> subprocess.Popen[bytes]:
    """Start a launcher, inside bubblewrap if ``level`` includes it.

    The launcher receives its requests on ``control``, and everything it prints goes to the file
    descriptor ``log``. Bubblewrap can isolate a process only when it starts.
    """
    code = f"import sys; sys.path.append({str(ROOT)!r}); "
    code += "from autograder.isolation import worker; worker.main(sys.argv[1])"
    python = os.path.realpath(sys.executable)
    text = json.dumps({**config, "control": control.fileno()})
    command = [python, "-I", "-S", "-B", "-c", code, text]
    if level.bubblewrap:
        command = _bubblewrap([*config["readable"], python, str(ROOT / "autograder")]) + command
    return subprocess.Popen(
        command,
        cwd="/",
        env={"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"},
        stdin=subprocess.DEVNULL,
        stdout=log,
        stderr=log,
        pass_fds=[control.fileno()],
    )


def python_folders() -> list[str]:
    """List the folders and shared libraries of Python, which code in the sandbox must read."""
    paths = {sysconfig.get_path("stdlib"), sysconfig.get_path("platstdlib")}
    if library := sysconfig.get_config_var("LIBDIR"):
        paths |= {str(path) for path in Path(library).glob("libpython*")}
    return sorted(paths)


def _bubblewrap(visible: list[str]) -> list[str]:
    """Build the start of a command line, which runs a program that can read only some paths.

    The program has no network access either.
    """
    program = shutil.which("bwrap") or "bwrap"
    command = [program, "--unshare-all", "--uid", "65534", "--gid", "65534", "--die-with-parent"]
    command += ["--cap-drop", "ALL", "--dev", "/dev", "--chdir", "/"]
    for path in visible:
        command += ["--ro-bind-try", path, path]
    return [*command, "--remount-ro", "/"]
