"""Checks and the student's code in one process, as students run them: quick, and full of trust."""

from __future__ import annotations

import faulthandler
import importlib
import sys
from collections.abc import Callable
from pathlib import Path

from autograder.definitions import read_definitions
from autograder.explain import explain_import
from autograder.faults import fault_of
from autograder.missing import MissingNameError, answer_for_missing, broken_module

Tell = Callable[..., None]  # tells the runner of an event


class InProcess:
    """The student's modules, imported beside the checks."""

    def __init__(self, engine: list[str], time_limit: float, stack_file: str) -> None:
        self.engine = [Path(folder).resolve() for folder in engine]
        self.time_limit = time_limit
        self.stack_file = Path(stack_file).open("wb")  # noqa: SIM115 - lives as long as we

    def open(self, modules: list[str], broken: dict[str, str], tell: Tell) -> None:
        """Import the student's modules before any check does, so that a bad one stops no other."""
        for module, message in broken.items():
            sys.modules[module] = broken_module(module, message)
        for module in modules:
            if module not in sys.modules:
                tell(event="import", module=module)
                self.start()
                self._import(module)
                self.stop()
                tell(event="imported")
        # Only the checks get an answer for a missing name: in another module of the student's it
        # is an ImportError here as well as behind the walls.
        for imported in filter(None, map(sys.modules.get, modules)):
            imported.__dict__.setdefault("__getattr__", answer_for_missing(imported))

    def after_collection(self) -> None:
        """Everything is there already: the checks' own imports need the modules."""

    def _import(self, module: str) -> None:
        # A source edited twice within a second would be taken for its own stale bytecode.
        sys.dont_write_bytecode = True
        try:
            importlib.import_module(module)
        except MissingNameError as error:  # it uses another module that is broken
            sys.modules[module] = broken_module(module, str(error))
        except BaseException as error:  # SystemExit among them
            message = explain_import(fault_of(error, self.engine), module, self.engine)
            sys.modules[module] = broken_module(module, message)
        finally:
            sys.dont_write_bytecode = False

    def definitions(self, file: Path) -> set[str] | None:
        """Return what a module of the student's defines."""
        return read_definitions(file)

    def start(self) -> None:
        """Write the stack and end the process when the time is up, whatever the code is doing."""
        faulthandler.dump_traceback_later(self.time_limit, exit=True, file=self.stack_file)

    def stop(self) -> str:
        """Stop the clock. What was printed is pytest's to tell."""
        faulthandler.cancel_dump_traceback_later()
        return ""
