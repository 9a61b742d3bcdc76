"""Start processes that run checks, without importing pytest in each of them.

A process that runs checks is called a judge. Because importing pytest takes a while, a helper
process imports it once and then waits for requests. For each run of checks it forks a judge, which
behaves like a newly started Python process. The helper itself never runs a check, never sees a
submission, and ends with the grader.
"""

from __future__ import annotations

import contextlib
import gc
import json
import os
import socket
import subprocess
import sys
import threading
from pathlib import Path
from typing import IO, Any

_lock = threading.Lock()
_waiting: dict[int, Judges] = {}  # the key is the process ID of the grader that uses it

Order = dict[str, Any]


class Judges:
    """A helper process that has already imported pytest and can quickly fork a process for checks.

    Forking saves the time that it would take to import pytest again for every run of checks.
    """

    def __init__(self, environment: dict[str, str]) -> None:
        self._control, theirs = socket.socketpair()
        self._answers = self._control.makefile("r", encoding="utf-8")
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "autograder.isolation.judges", str(theirs.fileno())],
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                start_new_session=True,  # so that Ctrl-C reaches only the grader
            )

    def ask(self, order: Order, descriptors: list[int]) -> int:
        """Send a request to the helper process that forks check processes, and return its answer.

        The answer to a request to run checks is the process ID of the new check process. The answer
        to a request to wait for a check process is the exit code of that process. ``descriptors``
        are the open files that a new check process uses as its standard streams.
        """
        data = json.dumps(order).encode() + b"\n"
        sent = socket.send_fds(self._control, [data], descriptors)
        self._control.sendall(data[sent:])
        return int(self._answers.readline())

    def close(self) -> None:
        """End the helper process.

        Any check processes that are still running end later, when their standard input closes.
        """
        self._answers.close()
        self._control.close()
        self._process.wait()


class ForkedJudge:
    """A process that runs checks, forked from a helper process that has already imported pytest.

    It provides the methods and attributes of ``subprocess.Popen`` that the grader needs.

    Raises:
        OSError: The helper process has ended.
    """

    def __init__(
        self, config: Path, folder: Path, environment: dict[str, str], stderr: IO[bytes]
    ) -> None:
        (their_input, own_input), (own_output, their_output) = os.pipe(), os.pipe()
        # If this process dies, the pipe closes, and the judge ends too.
        self.stdin = os.fdopen(own_input, "w", encoding="utf-8")
        self.stdout = os.fdopen(own_output, encoding="utf-8")
        order = {"config": str(config), "folder": str(folder), "environment": environment}
        try:
            self.pid = _ask(order, [their_input, their_output, stderr.fileno()])
        finally:
            os.close(their_input)
            os.close(their_output)

    def wait(self) -> int:
        return _ask({"wait": self.pid}, [])


def _ask(order: Order, descriptors: list[int]) -> int:
    """Send a request to the helper process that forks check processes, and return its answer.

    If the helper process is not running yet, start it first.
    """
    own = os.getpid()
    with _lock:
        if own not in _waiting:
            _waiting[own] = Judges(order["environment"])
        try:
            return _waiting[own].ask(order, descriptors)
        except (OSError, ValueError) as error:
            _waiting.pop(own).close()
            raise OSError("the process that starts the judges has ended") from error


def main() -> None:
    """Run the helper process, which forks a check process for each request to run checks.

    It also handles requests to wait until a check process ends. The function returns when the
    grader ends.
    """
    from autograder.checks import pytest_plugin
    from autograder.isolation import in_worker  # noqa: F401 - imported once for all judges
    from autograder.isolation.starting import start_waiting

    start_waiting()

    control = socket.socket(fileno=int(sys.argv[1]))
    gc.freeze()  # so that collecting garbage in a judge does not copy the memory that it shares
    while True:
        try:
            text, descriptors, _, _ = socket.recv_fds(control, 1 << 16, 3)
            while not text.endswith(b"\n"):
                more = control.recv(1 << 16)
                if not more:
                    return  # perhaps in the middle of an order, if the grader was killed
                text += more
        except ConnectionError:
            return
        order = json.loads(text)
        if "wait" in order:
            _, status = os.waitpid(order["wait"], 0)
            answer = os.waitstatus_to_exitcode(status)
        else:
            answer = os.fork()
            if answer == 0:
                control.close()
                _become(order, descriptors)
                pytest_plugin.run_and_exit()
            with contextlib.suppress(OSError):  # the judge may already have done so, or have ended
                os.setpgid(answer, answer)  # the runner may now kill its group
        for descriptor in descriptors:
            os.close(descriptor)
        try:
            control.send(b"%d\n" % answer)
        except ConnectionError:  # the grader was killed
            return


def _become(order: Order, descriptors: list[int]) -> None:
    """Prepare this newly forked process to run the checks that ``order`` requests.

    The process adopts the working folder and the environment variables given in ``order``, and uses
    ``descriptors`` as its standard streams.
    """
    os.setpgid(0, 0)
    for new, old in enumerate(descriptors):
        os.dup2(old, new)
        os.close(old)
    os.chdir(order["folder"])
    os.environ.clear()
    os.environ.update(order["environment"])
    sys.argv[1:] = [order["config"]]
    sys.path[0] = order["folder"]


if __name__ == "__main__":
    main()
