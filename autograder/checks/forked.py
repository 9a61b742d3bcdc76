"""Run checks in a forked copy of this process, so that exercises cannot affect each other.

A check may change a counter or a cache in the student's module, which could affect the result of
the next check. The grader prevents this by starting a new process for each check. On a student's
machine that would take too long, because even a fork for each check doubles the run time. All
checks of an exercise therefore share one forked copy.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import traceback
from collections.abc import Callable

CAN_FORK = hasattr(os, "fork") and sys.platform != "emscripten"  # a browser's fork always fails
DONE = 87  # exit code of a copy that has finished its work


def run_forked(work: Callable[[], object]) -> None:
    """Fork this process, and call ``work`` in the child process.

    If the child ends early, this process ends with the same signal or exit code. The runner of the
    checks notices that, and starts a new process for the remaining checks.
    """
    if sys.platform == "win32":
        raise OSError("Windows cannot fork")
    child = os.fork()
    if child == 0:
        try:
            work()
            os._exit(DONE)
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(1)
    _, status = os.waitpid(child, 0)
    code = os.waitstatus_to_exitcode(status)
    if code < 0:
        with contextlib.suppress(OSError):  # SIGKILL has no handler to reset
            signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    elif code != DONE:
        os._exit(code)


def how_it_ended(code: int) -> str:
    """Explain why the process that ran a student's code ended early, with this exit code."""
    if code < 0:
        name = signal.strsignal(-code) or f"signal {-code}"
        return f"the process ended early: Python crashed ({name})"
    return f"the process ended early, with exit code {code}. Does the code call os._exit?"
