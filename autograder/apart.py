"""Run a check in a copy of this process, so that it finds nothing that another has left behind.

A grader starts a fresh process for each check. A counter or a cache in a module then begins anew.
"""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable

CAN_COPY = hasattr(os, "fork")
DONE = 87  # the exit code of a copy that has reported its verdict


def run_in_a_copy(work: Callable[[], object]) -> int:
    """Do the work in a copy of this process and return its exit code, DONE if the work ended."""
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
    return os.waitstatus_to_exitcode(status)


def how_it_ended(code: int) -> str:
    """Return a sentence on a process that ended while it ran a student's code."""
    if code < 0:
        name = signal.strsignal(-code) or f"signal {-code}"
        return f"the process ended in the middle: Python crashed ({name})"
    return f"the process ended in the middle, with exit code {code}: is there an os._exit?"
