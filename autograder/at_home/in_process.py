"""Run the checks and the student's code in one process, which is fast but not secure.

This is how checks run on a student's own machine. The student's code has the imports, operations,
memory and recursion depth that the grader allows, so that it does not fail only when it is graded.
"""

from __future__ import annotations

import faulthandler
import gc
import importlib
import os
import signal
import sys
import traceback
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from types import FrameType

from autograder.at_home.restrictions import StudentsCode, restrict
from autograder.checks.arrange import Config
from autograder.checks.events import Event, Imported, Importing
from autograder.checks.forked import CAN_FORK
from autograder.checks.printed import CappedText
from autograder.diagnosis.explain import explain_import
from autograder.diagnosis.faults import fault_of
from autograder.diagnosis.undefined import MissingNameError, answer_for_missing, broken_module
from autograder.message import Message

Send = Callable[[Event], None]  # sends an event to the runner
VARIABLES = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
# The first is needed by Python itself on Windows, and the second turns breakpoint() off.
NEEDED = ("SYSTEMROOT", "PYTHONBREAKPOINT")
DEPTH = 1000  # nested calls, which is the recursion limit of a process in the grader
MEMORY = 490 << 20  # bytes on top of what is in use; the grader allows 512 MB, Python included
ROOM = 100 << 20  # bytes of these, which are left to explain what happened
LOOK_EVERY = 0.02  # s of processor time between two looks at the memory


class InProcess:
    """Runs the student's code in the same process as the checks."""

    forks = CAN_FORK  # whether each exercise runs in a forked copy of the process
    depth = DEPTH

    def __init__(self, config: Config) -> None:
        self.config = config
        self.engine = [Path(folder).resolve() for folder in config.engine]
        self.stack_file = Path(config.stack_file).open("wb")  # noqa: SIM115 - open until the end
        self.printed: list[str] = []
        self.streams = sys.stdin, sys.stdout, sys.stderr
        self.recursion_limit = sys.getrecursionlimit()
        self.memory_limit = 0  # bytes, or 0 if there is none

    def open(self, modules: list[str], broken: Mapping[str, Message], send: Send) -> None:
        """Import the student's modules one by one, before pytest imports the checks."""
        self.surround()
        for module, message in broken.items():
            sys.modules[module] = broken_module(module, message)
        for module in modules:
            if module not in sys.modules:
                send(Importing(module))
                self.start()
                self._import(module)
                self.stop()
                send(Imported())
        # If a name is missing, only the checks get a placeholder for it. If another module of the
        # student's imports it, that raises ImportError, here as well as in the sandbox.
        for imported in filter(None, map(sys.modules.get, modules)):
            imported.__dict__.setdefault("__getattr__", answer_for_missing(imported))

    def surround(self) -> None:
        """Give the student's code the restrictions and the environment of the grader."""
        leave_home()
        self.memory_limit = limit_memory()
        restrict(StudentsCode(self.engine, self.config.graded))

    def after_collection(self) -> None:
        """Let a forked copy of the process share more of its memory with the original."""
        gc.freeze()

    def _import(self, module: str) -> None:
        # Without bytecode, Python notices if a file is edited twice within the same second.
        sys.dont_write_bytecode = True
        try:
            importlib.import_module(module)
        except MissingNameError as error:  # the module uses another module that is broken
            sys.modules[module] = broken_module(module, error.message)
        except BaseException as error:  # including SystemExit
            fault = fault_of(error, self.engine)
            message = explain_import(fault, module, self.engine, self.config.complete)
            sys.modules[module] = broken_module(module, message)
        finally:
            sys.dont_write_bytecode = False

    def start(self, *, hidden: bool = False) -> None:  # noqa: ARG002 - nothing is hidden at home
        """Start the time limit of a check, and begin to capture what the student's code prints."""
        if sys.getrecursionlimit() == self.recursion_limit:  # the student's code has not changed it
            on_the_stack = len([*traceback.walk_stack(None)])
            self.recursion_limit = self.depth + on_the_stack
            sys.setrecursionlimit(self.recursion_limit)
        sys.stdin = Path(os.devnull).open(encoding="utf-8")  # noqa: SIM115 - closed by stop
        sys.stdout = sys.stderr = CappedText(self.printed.append)
        self.start_clock()

    def stop(self) -> str:
        """Cancel the time limit of a check, and return what the student's code has printed."""
        self.stop_clock()
        sys.stdin.close()
        sys.stdin, sys.stdout, sys.stderr = self.streams
        printed = "".join(self.printed).strip()
        self.printed.clear()
        return printed

    def start_clock(self) -> None:
        """Limit the time and the memory of a check."""
        # When the time runs out, the process writes a stack trace and exits. A MemoryError ends the
        # check before the limit, where Python may not even be able to explain what happened.
        seconds = self.config.time_limit
        faulthandler.dump_traceback_later(seconds, exit=True, file=self.stack_file)
        if sys.platform != "win32" and self.memory_limit:
            signal.signal(signal.SIGPROF, partial(_look_at_memory, self.memory_limit - ROOM))
            signal.setitimer(signal.ITIMER_PROF, LOOK_EVERY, LOOK_EVERY)

    def stop_clock(self) -> None:
        if sys.platform != "win32" and self.memory_limit:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
        faulthandler.cancel_dump_traceback_later()


def leave_home() -> None:
    """Replace the arguments, the variables and the working folder of this process for good."""
    sys.argv[:], sys.orig_argv[:] = [""], []
    kept = {name: os.environ[name] for name in NEEDED if name in os.environ}
    os.environ.clear()
    os.environ |= VARIABLES | kept
    os.chdir("/")


def limit_memory() -> int:
    """Limit the memory of this process on Linux, and return how many bytes it may use, or 0."""
    if sys.platform != "linux":
        return 0  # a limit would stop Python itself
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    limit = _memory_in_use() + MEMORY
    limit = limit if most == resource.RLIM_INFINITY else min(limit, most)
    resource.setrlimit(resource.RLIMIT_AS, (limit, most))
    return limit


def _memory_in_use() -> int:
    if sys.platform == "win32":
        return 0  # there is no limit either
    pages = Path("/proc/self/statm").read_text(encoding="ascii").split()[0]
    return int(pages) * os.sysconf("SC_PAGE_SIZE")


if sys.platform != "win32":  # which has no such signals

    def _look_at_memory(most: int, _: int, __: FrameType | None) -> None:
        """Handle a signal that comes while the student's code runs."""
        if _memory_in_use() > most:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            raise MemoryError
