"""Run checks in a forked copy of this process, so that exercises cannot affect each other.

A check may change a counter or a cache in the student's module. In the grader, each check therefore
has its own process. At home, that would double the run time, so an exercise's checks share one.
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
    """Call ``work`` in a fork. If it ends early, so does this process, for the runner to notice."""
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
