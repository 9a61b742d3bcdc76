"""Run checks in a copy of this process, so that they find nothing that others have left behind.

A grader starts a fresh process for each check. A counter or a cache in a module then begins anew.
At home a copy serves the checks of a whole exercise: a copy for each check would take twice as long
as all of the checks together.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import traceback
from collections.abc import Callable

CAN_COPY = hasattr(os, "fork") and sys.platform != "emscripten"  # which has it, but only fails
DONE = 87  # the exit code of a copy that has done all of its work


def run_in_a_copy(work: Callable[[], object]) -> None:
    """Do the work in a copy of this process. If the copy breaks off, this process ends as it did.

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
        with contextlib.suppress(OSError):  # SIGKILL is always its own
            signal.signal(-code, signal.SIG_DFL)
        os.kill(os.getpid(), -code)
    elif code != DONE:
        os._exit(code)


def how_it_ended(code: int) -> str:
    """Return a sentence on a process that ended while it ran a student's code."""
    if code < 0:
        name = signal.strsignal(-code) or f"signal {-code}"
        return f"the process ended in the middle: Python crashed ({name})"
    return f"the process ended in the middle, with exit code {code}: is there an os._exit?"
