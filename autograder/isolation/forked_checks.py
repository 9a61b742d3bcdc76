"""Fork check processes, the processes that run checks, without importing pytest in each of them.

A helper process imports pytest once, which takes a while, and then forks a check process for each
request. It never runs a check, never sees a submission, and ends with the grader. The forkserver of
``multiprocessing`` does not fit: a thread that starts a process there can take away the exit code
for which another thread waits, and it cannot put a check process into its own process group before
the grader may have to kill that group.
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
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any, NoReturn

_lock = threading.Lock()
_helpers: dict[int, _Helper] = {}  # the key is the process ID of the grader that uses it


class ForkedChecks:
    """A check process, forked from a helper process that has already imported pytest.

    It provides the methods and attributes of ``subprocess.Popen`` that the grader needs, which
    raise OSError if the helper process has ended. All have the ``environment`` of the first.
    """

    def __init__(
        self,
        config: Path,
        folder: Path,
        environment: Callable[[], dict[str, str]],
        stderr: IO[bytes],
    ) -> None:
        with _lock:
            if os.getpid() not in _helpers:
                _helpers[os.getpid()] = _Helper(environment())
            self._helper = _helpers[os.getpid()]
        (their_input, own_input), (own_output, their_output) = os.pipe(), os.pipe()
        # If this process dies, the pipe closes, and the check process ends too.
        self.stdin = os.fdopen(own_input, "w", encoding="utf-8")
        self.stdout = os.fdopen(own_output, encoding="utf-8")
        order = {"config": str(config), "folder": str(folder)}
        try:
            self.pid = self._helper.ask(order, [their_input, their_output, stderr.fileno()])
        finally:
            os.close(their_input)
            os.close(their_output)

    def wait(self) -> int:
        return self._helper.ask({"wait": self.pid}, [])


class _Helper:
    """The connection to a helper process that forks check processes."""

    def __init__(self, environment: dict[str, str]) -> None:
        self._lock = threading.Lock()
        self._control, theirs = socket.socketpair()
        self._answers = self._control.makefile("r", encoding="utf-8")
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "autograder.isolation.forked_checks", str(theirs.fileno())],
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                start_new_session=True,  # so that Ctrl-C reaches only the grader
            )

    def ask(self, order: dict[str, Any], descriptors: list[int]) -> int:
        """Return the ID of a new check process with these streams or, for "wait", its exit code."""
        try:
            with self._lock:
                socket.send_fds(self._control, [json.dumps(order).encode()], descriptors)
                return int(self._answers.readline())
        except (OSError, ValueError) as error:
            with _lock:
                if _helpers.get(os.getpid()) is self:  # the next check process gets another helper
                    del _helpers[os.getpid()]
            self._process.kill()
            self._process.wait()
            raise OSError("the process that starts the check processes has ended") from error


def main() -> None:
    """Run the helper process until the grader ends."""
    from autograder.checks import pytest_plugin
    from autograder.isolation import in_worker  # noqa: F401 - imported once for all forks

    control = socket.socket(fileno=int(sys.argv[1]))
    gc.freeze()  # so that collecting garbage in a fork does not copy the memory that it shares
    # The grader has ended, perhaps in the middle of an order.
    with contextlib.suppress(ConnectionError, json.JSONDecodeError):
        while True:
            text, descriptors, _, _ = socket.recv_fds(control, 1 << 16, 3)
            order = json.loads(text)
            if "wait" in order:
                _, status = os.waitpid(order["wait"], 0)
                answer = os.waitstatus_to_exitcode(status)
            else:
                answer = os.fork()
                if answer == 0:
                    control.close()
                    _run_checks(order, descriptors, pytest_plugin.run_and_exit)
                with contextlib.suppress(OSError):  # the fork may have done so, or have ended
                    os.setpgid(answer, answer)  # the runner may now kill its group
            for descriptor in descriptors:
                os.close(descriptor)
            control.send(b"%d\n" % answer)


def _run_checks(
    order: dict[str, Any], descriptors: list[int], run: Callable[[], NoReturn]
) -> NoReturn:
    """Run checks in this forked process, as a new Python process with these streams would do."""
    try:
        os.setpgid(0, 0)
        for new, old in enumerate(descriptors):
            os.dup2(old, new)
            os.close(old)
        os.chdir(order["folder"])
        sys.argv[1:] = [order["config"]]
        sys.path[0] = order["folder"]
        run()
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(1)


if __name__ == "__main__":
    main()
