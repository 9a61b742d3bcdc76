"""Run the checks and the student's code in one process, which is fast but not secure.

This is how checks run on a student's own machine. The student's code is limited to the imports and
operations that the grader allows. Otherwise, code that works at home could fail when it is graded.
"""

from __future__ import annotations

import faulthandler
import gc
import importlib
import os
import sys
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path

from autograder.at_home.allowed_acts import limit_acts
from autograder.at_home.allowed_imports import limit_imports
from autograder.at_home.students_code import StudentsCode
from autograder.at_home.surroundings import Depth, MemoryWatch, leave_home
from autograder.checks.apart import CAN_COPY
from autograder.checks.events import Event, Imported, Importing
from autograder.checks.printed import CappedText
from autograder.definitions import read_definitions
from autograder.diagnosis.explain import explain_import
from autograder.diagnosis.faults import fault_of
from autograder.diagnosis.missing import MissingNameError, answer_for_missing, broken_module
from autograder.message import Message

Send = Callable[[Event], None]  # sends an event to the runner
CALLS = 13  # nested calls of pytest and the check between start() and the student's code


class InProcess:
    """Runs the student's code in the same process as the checks, for use on a student's machine."""

    def __init__(
        self,
        engine: list[str],
        time_limit: float,
        stack_file: str,
        complete: Sequence[str],
        graded: Mapping[str, Collection[str]],
        *,
        apart: bool,
    ) -> None:
        self.engine = [Path(folder).resolve() for folder in engine]
        self.time_limit = time_limit
        self.stack_file = Path(stack_file).open("wb")  # noqa: SIM115 - open until the process ends
        self.complete = complete
        self.graded = graded
        self.apart = apart and CAN_COPY
        self.printed: list[str] = []
        self.streams = sys.stdin, sys.stdout, sys.stderr
        self.depth = Depth()
        self.memory = MemoryWatch()

    def open(self, modules: list[str], broken: Mapping[str, Message], send: Send) -> None:
        """Import the student's modules one by one, before pytest imports the checks.

        If a module cannot be imported, only the checks that use it fail.
        """
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
        """Give the student's code the same restrictions and environment as when it is graded."""
        leave_home()
        code = StudentsCode(self.engine, self.graded)
        limit_imports(code)
        limit_acts(code)

    def after_collection(self) -> None:
        """Exclude all objects that exist now from garbage collection.

        This lets a forked copy of the process share more of its memory with the original.
        """
        gc.freeze()

    def _import(self, module: str) -> None:
        # Without bytecode, Python notices if a file is edited twice within the same second.
        sys.dont_write_bytecode = True
        try:
            importlib.import_module(module)
        except MissingNameError as error:  # the module uses another module that is broken
            sys.modules[module] = broken_module(module, error.message)
        except BaseException as error:  # including SystemExit
            message = explain_import(
                fault_of(error, self.engine), module, self.engine, self.complete
            )
            sys.modules[module] = broken_module(module, message)
        finally:
            sys.dont_write_bytecode = False

    def definitions(self, file: Path) -> set[str] | None:
        """List the names that a student's file defines.

        Return None if the file defines nothing, is missing, or is not valid Python.
        """
        return read_definitions(file)

    def start(self, *, hidden: bool = False) -> None:  # noqa: ARG002 - nothing is hidden at home
        """Start the time limit of a check, and begin to capture what the student's code prints."""
        self.depth.adapt(CALLS)
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
        """Start the time limit for a check.

        When it runs out, the process writes a stack trace and exits, even if the student's code is
        stuck in an endless loop.
        """
        faulthandler.dump_traceback_later(self.time_limit, exit=True, file=self.stack_file)
        self.memory.start()

    def stop_clock(self) -> None:
        self.memory.stop()
        faulthandler.cancel_dump_traceback_later()
