"""What a student's code finds around it is here what it is where work is graded.

No folder to work in, no arguments, no variables of the user's, nothing to type, and as much memory
and depth of calls as there.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

VARIABLES = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
NEEDED = ("SYSTEMROOT",)  # by Python itself, on Windows
# Bytes on top of what is used: a grader's 512 MB, less Python, more what the clock's thread takes.
MEMORY = 560 << 20
DEPTH = 1000  # calls in each other, of which a grader uses up the first few
FIRST_CALLS = 9  # of a grader's own, above those of a student's code


def leave_home() -> None:
    """Take what is the user's away from this process, for good, and limit its memory."""
    sys.argv[:], sys.orig_argv[:] = [""], []
    kept = {name: os.environ[name] for name in NEEDED if name in os.environ}
    os.environ.clear()
    os.environ |= VARIABLES | kept
    os.chdir("/")
    if sys.platform == "linux":  # elsewhere such a limit stops the interpreter itself
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = pages * resource.getpagesize() + MEMORY
        if most == resource.RLIM_INFINITY or limit < most:
            resource.setrlimit(resource.RLIMIT_AS, (limit, most))


class Depth:
    """Leaves a student's code as many calls in each other as a grader does, however deep we are."""

    def __init__(self) -> None:
        self.limit = sys.getrecursionlimit()

    def adapt(self, more: int) -> None:
        """Set the limit for code that is called ``more`` calls below our caller's.

        A limit that the student's code has set stays.
        """
        if sys.getrecursionlimit() != self.limit:
            return
        frame, depth = sys._getframe(), 0
        while frame is not None:
            frame, depth = frame.f_back, depth + 1  # type: ignore[assignment]
        self.limit = DEPTH + depth + more - FIRST_CALLS
        sys.setrecursionlimit(self.limit)
