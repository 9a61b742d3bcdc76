"""Give a student's code the surroundings that it has where it is graded.

It works in the root folder, without arguments and without the user's environment variables. It has
as much memory as there, and its calls may be nested as deeply.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

VARIABLES = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
NEEDED = ("SYSTEMROOT",)  # by Python itself, on Windows
# Bytes beyond what the process has now. A grader has 512 MB in all, of which Python needs some 30;
# here the thread that watches the time has a stack of 8 more.
MEMORY = 490 << 20
_ARENA_MAX = -8  # in malloc.h
DEPTH = 1000  # nested calls in a grader's process
FIRST_CALLS = 9  # of those, the grader's own around a student's code


def leave_home() -> None:
    """Take the user's surroundings away from this process, for good, and limit its memory."""
    sys.argv[:], sys.orig_argv[:] = [""], []
    kept = {name: os.environ[name] for name in NEEDED if name in os.environ}
    os.environ.clear()
    os.environ |= VARIABLES | kept
    os.chdir("/")
    if sys.platform == "linux":  # elsewhere such a limit stops the interpreter itself
        import ctypes
        import resource

        # A thread's own heap reserves 64 MB, and two may overlap for a moment: all share one.
        set_option = getattr(ctypes.CDLL(None), "mallopt", None)  # glibc alone has it, and heaps
        if set_option:
            set_option(_ARENA_MAX, 1)
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = pages * resource.getpagesize() + MEMORY
        if most == resource.RLIM_INFINITY or limit < most:
            resource.setrlimit(resource.RLIMIT_AS, (limit, most))


class Depth:
    """Lets a student's code nest as many calls as a grader does, however deep the stack is here."""

    def __init__(self, deepest: int = DEPTH) -> None:
        self.deepest = deepest
        self.limit = sys.getrecursionlimit()

    def adapt(self, more: int) -> None:
        """Set the recursion limit for code that runs ``more`` calls deeper than our caller.

        A limit that the student's code has set itself stays.
        """
        if sys.getrecursionlimit() != self.limit:
            return
        frame, depth = sys._getframe(), 0
        while frame is not None:
            frame, depth = frame.f_back, depth + 1  # type: ignore[assignment]
        self.limit = self.deepest + depth + more - FIRST_CALLS
        sys.setrecursionlimit(self.limit)
