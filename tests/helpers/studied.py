"""Run a command of studies or lab in a process that has already imported matplotlib.

A new Python process takes most of a second to import matplotlib, and the tests run dozens of such
commands. So one process imports it once and forks for each command. On a system that cannot fork,
such as Windows, each command runs in a new process.

This file is also the program of the waiting process, which reads one request per line.
"""

from __future__ import annotations

import atexit
import importlib
import json
import os
import subprocess
import sys
import tempfile
import traceback
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENT = os.environ | {"MPLBACKEND": "Agg", "PYTHONPATH": str(ROOT)}


def study(
    *arguments: str,
    package: str = "studies",
    settings: dict[str, int] | None = None,
    only: tuple[str, ...] = (),
) -> subprocess.CompletedProcess:
    """Run `python -m` with the package and these arguments.

    ``settings`` replaces constants of the module that records scenes, as in {"STEPS_A_PICTURE": 6}.
    If ``only`` names plots, a chapter's other plots are left out where processes can fork.
    """
    if not hasattr(os, "fork"):
        command = [sys.executable, "-m", package, *arguments]
        return subprocess.run(
            command, cwd=ROOT, env=ENVIRONMENT, capture_output=True, encoding="utf-8", check=False
        )
    with tempfile.TemporaryDirectory(prefix="study-") as folder:
        out, err = Path(folder) / "out", Path(folder) / "err"
        request = {"package": package, "arguments": arguments, "set": settings or {}, "only": only}
        request |= {"out": str(out), "err": str(err)}
        waiting = _waiting()
        print(json.dumps(request), file=waiting.stdin, flush=True)
        status = int(waiting.stdout.readline())
        texts = (path.read_text(encoding="utf-8") for path in (out, err))
        return subprocess.CompletedProcess(arguments, status, *texts)


@cache
def _waiting() -> subprocess.Popen[str]:
    """Return the process that waits for requests, which all tests of a process share."""
    waiting = subprocess.Popen(
        [sys.executable, __file__],
        cwd=ROOT,
        env=ENVIRONMENT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    atexit.register(waiting.stdin.close)  # the process ends when its input is closed
    return waiting


def _wait() -> None:
    """Import the slow modules, fork for each request, and print the exit code of the copy."""
    sys.path[0] = str(ROOT)
    import lab.__main__
    import lab.record  # noqa: F401
    import plots.__main__
    import plots.draw  # noqa: F401

    for line in sys.stdin:
        process = os.fork()
        if not process:
            os._exit(_run(json.loads(line)))
        print(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), flush=True)


def _run(request: dict) -> int:
    """Run one command in this copy, and return its exit status."""
    for number, name in ((1, "out"), (2, "err")):
        os.dup2(os.open(request[name], os.O_WRONLY | os.O_CREAT), number)
    sys.argv = [request["package"], *request["arguments"]]
    module = sys.modules["lab.record"]
    for name, value in request["set"].items():
        assert hasattr(module, name), name
        setattr(module, name, value)
    if only := request["only"]:
        plots = sys.modules["plots.draw"]
        draw = plots.draw
        plots.draw = lambda plot, folder: plot.__name__ not in only or draw(plot, folder)
    try:
        status = importlib.import_module(f"{request['package']}.__main__").main()
    except SystemExit as end:
        status = end.code
    except BaseException:
        traceback.print_exc()
        status = 1
    if isinstance(status, str):
        print(status, file=sys.stderr)
    sys.stdout.flush()
    sys.stderr.flush()
    return 1 if isinstance(status, str) else status or 0


if __name__ == "__main__":
    _wait()
