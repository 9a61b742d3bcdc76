"""Run checks in a copy of this process, so that the effects of a check do not reach other checks.

A grader starts a fresh process for each check, so a counter or a cache in a module starts over. On
a student's machine, one copy serves all checks of an exercise, because making a copy for each check
would take twice as long as running all of the checks.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import traceback
from collections.abc import Callable

CAN_COPY = hasattr(os, "fork") and sys.platform != "emscripten"  # there it always fails
DONE = 87  # exit code of a copy that has finished its work


def run_in_a_copy(work: Callable[[], object]) -> None:
    """Do the work in a copy of this process. If the copy dies, end this process in the same way.

    The runner then continues with the other checks in a new process.
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
    """Return a sentence that explains how a process ended while it ran a student's code."""
    if code < 0:
        name = signal.strsignal(-code) or f"signal {-code}"
        return f"the process ended early: Python crashed ({name})"
    return f"the process ended early, with exit code {code}. Does the code call os._exit?"
