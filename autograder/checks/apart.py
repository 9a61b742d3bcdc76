"""Run checks in a forked copy of this process, so that one exercise cannot affect another.

A student's module may contain a counter or a cache. Without a copy, its contents would leak from
one check into the next. The grader avoids this by starting a new process for each check. On a
student's machine, a copy for each check would double the time of the run, so all checks of an
exercise share one copy.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import traceback
from collections.abc import Callable

CAN_COPY = hasattr(os, "fork") and sys.platform != "emscripten"  # where fork always fails
DONE = 87  # exit code of a copy that has finished its work


def run_in_a_copy(work: Callable[[], object]) -> None:
    """Call ``work`` in a forked copy of this process.

    If the copy crashes, this process ends in the same way. The runner then starts a new process for
    the remaining checks.
    """
    if sys.platform == "win32":
        raise OSError("Windows cannot copy a process")
    copy = os.fork()
    if copy == 0:
        try:
            work()
            os._exit(DONE)
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(1)
    _, status = os.waitpid(copy, 0)
    code = os.waitstatus_to_exitcode(status)
    if code < 0:
        with contextlib.suppress(OSError):  # SIGKILL has no handler to reset
            signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    elif code != DONE:
        os._exit(code)


def how_it_ended(code: int) -> str:
    """Explain how a process ended while it ran a student's code. ``code`` is its exit code."""
    if code < 0:
        name = signal.strsignal(-code) or f"signal {-code}"
        return f"the process ended early: Python crashed ({name})"
    return f"the process ended early, with exit code {code}. Does the code call os._exit?"
