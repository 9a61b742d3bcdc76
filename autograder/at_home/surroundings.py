"""Give a student's code the same environment at home as in the grader.

The code runs in the root folder /, without command-line arguments or the user's environment
variables. Memory and recursion depth are limited as in the grader. A program that exceeds these
limits therefore fails at home too.
"""

from __future__ import annotations

import os
import sys
import threading
from pathlib import Path

VARIABLES = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
# The first is needed by Python itself on Windows, and the second turns breakpoint() off.
NEEDED = ("SYSTEMROOT", "PYTHONBREAKPOINT")
# The student's code may use this many bytes on top of what the process uses already. The grader
# allows 512 MB in all, of which Python needs about 30 MB. Here the thread for the time limit needs
# another 8 MB for its stack.
MEMORY = 490 << 20
ROOM = 100 << 20  # bytes of these, which are left to explain what happened
LOOK_EVERY = 0.02  # s between two looks at the memory
SMALL_STACK = 256 << 10  # bytes, for the thread that looks
_ARENA_MAX = -8  # M_ARENA_MAX in malloc.h
DEPTH = 1000  # recursion limit of a process in the grader
FIRST_CALLS = 8  # how many of these calls the grader's own code uses up


def leave_home() -> None:
    """Replace the environment of this process with a neutral one, and limit its memory.

    The command-line arguments are removed, the user's environment variables are replaced with a
    minimal set, and the working directory becomes /. These changes cannot be undone. The memory
    limit works only on Linux.
    """
    sys.argv[:], sys.orig_argv[:] = [""], []
    kept = {name: os.environ[name] for name in NEEDED if name in os.environ}
    os.environ.clear()
    os.environ |= VARIABLES | kept
    os.chdir("/")
    if sys.platform == "linux":  # elsewhere this limit stops Python itself
        import ctypes
        import resource

        # A heap per thread would reserve 64 MB for each of up to two threads, so they share one.
        set_option = getattr(ctypes.CDLL(None), "mallopt", None)  # only glibc has such heaps
        if set_option:
            set_option(_ARENA_MAX, 1)
        pages = _pages_in_use()
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = pages * resource.getpagesize() + MEMORY
        if most == resource.RLIM_INFINITY or limit < most:
            resource.setrlimit(resource.RLIMIT_AS, (limit, most))


class MemoryWatch:
    """Raises MemoryError in a check shortly before the memory limit is reached.

    At the limit itself, Python may not even have the memory to explain what happened. A check is
    therefore ended a little earlier than in the grader, never later. Without a limit, which only
    Linux has, the watch does nothing.
    """

    def __init__(self) -> None:
        self.ended = threading.Event()

    def start(self) -> None:
        """Begin to watch the memory, on behalf of the thread that calls this method."""
        if sys.platform != "linux":
            return
        import resource

        limit, _ = resource.getrlimit(resource.RLIMIT_AS)
        if limit == resource.RLIM_INFINITY:
            return
        self.ended = threading.Event()
        threading.stack_size(SMALL_STACK)
        pages = (limit - ROOM) // resource.getpagesize()
        watch = threading.Thread(target=self._watch, args=(threading.get_ident(), pages))
        watch.daemon = True
        watch.start()

    def stop(self) -> None:
        """Stop watching, because the check has ended."""
        self.ended.set()

    def _watch(self, thread: int, most: int) -> None:
        import ctypes

        while not self.ended.wait(LOOK_EVERY):
            if _pages_in_use() > most:
                raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc
                raise_in(ctypes.c_ulong(thread), ctypes.py_object(MemoryError))
                return


def _pages_in_use() -> int:
    return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])


class Depth:
    """Lets a student's code recurse exactly as deeply at home as in the grader.

    Python's recursion limit counts all calls on the stack. At home, the stack may already contain
    more calls when the student's code starts. The limit is therefore raised by the difference.
    """

    def __init__(self, deepest: int = DEPTH) -> None:
        self.deepest = deepest
        self.limit = sys.getrecursionlimit()

    def adapt(self, more: int) -> None:
        """Adjust the recursion limit to the stack's depth before a check calls the student's code.

        ``more`` is the number of calls that will be added to the stack before the student's code
        starts. If the student's code has changed the limit, this method does nothing.
        """
        if sys.getrecursionlimit() != self.limit:
            return
        frame, depth = sys._getframe(), 0
        while frame is not None:
            frame, depth = frame.f_back, depth + 1  # type: ignore[assignment]
        self.limit = self.deepest + depth + more - FIRST_CALLS
        sys.setrecursionlimit(self.limit)
