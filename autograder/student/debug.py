"""Run an exercise's checks until one fails, and stop in the student's function at that call.

The check that fails in a process of its own then runs twice in this one. The first run counts the
calls of the exercise's functions until the failure, and the second stops at the last of them.

The stop is one statement, ``if call_counts(): breakpoint()``, which is put in front of a function's
own code while its module is imported. It works with pdb as well as with the debugger of an editor,
and the line numbers stay those of the file. The file itself does not change.
"""

from __future__ import annotations

import _thread
import ast
import builtins
import copy
import os
import sys
import threading
from bdb import BdbQuit
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from importlib.machinery import SourceFileLoader
from pathlib import Path
from pdb import Pdb
from types import CodeType, FrameType, TracebackType

import pytest

from autograder.checks.pytest_plugin import exercise_of, pytest_arguments
from autograder.checks.runner import Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.commands import command
from autograder.definitions import functions
from autograder.diagnosis.faults import is_inside, short
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.message import Kind

CHECKS = ROOT / "tests"
STOP = "__stop_at_this_call__"  # the name of a built-in function
LOAD = SourceFileLoader.get_code
KEYS = """\
n  next line            a  the arguments of the function    c  continue
s  step into a call     w  where you are                    q  quit
p NAME  print a value"""


def debug(chapter: Chapter, exercise: Exercise, folders: list[Path], seed: str) -> bool:
    """Find the first check of an exercise that fails, and debug it. Return True if none fails."""
    with _breakpoints_off():
        verdicts = run_checks(chapter, folders, seed=seed, exercises=[exercise.id])
    failed = next((verdict for verdict in verdicts if verdict.status != "passed"), None)
    own = [verdict for verdict in verdicts if verdict.exercise == exercise.id]
    if failed is None:
        print(f"All checks of {exercise.id} pass. They run again, to stop at your breakpoints.")
    else:
        print(f"{failed.exercise}, {failed.name}:\n{failed.message}\n")
        if failed.exercise != exercise.id:
            first = command("debug", EX=failed.exercise)
            print(f"{exercise.id} builds on it. Start there: {first}")
            return False
        if failed.message.kind in (Kind.UNWRITTEN, Kind.BROKEN):
            print("There is no code to step through yet.")
            return False
    plugin = Debugging(chapter, exercise, folders, [failed] if failed else own)
    arguments = pytest_arguments([f"tests/{chapter.name}"], ROOT, seed, folders)
    pytest.main(arguments, plugins=[plugin])
    return failed is None


class Debugging:
    """A pytest plugin that runs some checks here, and stops in the student's function.

    It counts the calls of the exercise's functions, such as ch02_vectors/vector.Vector3.cross. A
    call counts only if no other counted call is still running. The stop is at call number ``at``.
    """

    def __init__(
        self, chapter: Chapter, exercise: Exercise, folders: list[Path], checks: Sequence[Verdict]
    ) -> None:
        self.exercise = exercise.id
        self.edits = {f"{chapter.name}/{edit}" for edit in exercise.edit}
        self.folders = [folder.resolve() for folder in folders]
        self.failing = {check.name: check.status != "passed" for check in checks}
        self.calls = 0
        self.at = 0
        setattr(builtins, STOP, self.count)
        setattr(SourceFileLoader, "get_code", lambda loader, name: self.get_code(loader, name))  # noqa: B010

    def count(self) -> bool:
        """Count the call of a function, and return True if it is the one to stop at."""
        frame: FrameType | None = sys._getframe(1)  # of the function itself
        while frame and (frame := frame.f_back):
            code = frame.f_code
            if f"{_module(code.co_filename)}.{code.co_qualname}" in self.edits:
                return False
        self.calls += 1
        return self.calls == self.at

    def get_code(self, loader: SourceFileLoader, fullname: str) -> CodeType | None:
        """Compile a module of the student's with stops. Python's cached bytecode has none."""
        path = loader.path
        if not is_inside(path, self.folders):
            return LOAD(loader, fullname)
        tree = ast.parse(loader.get_data(path), path)
        for name, node in functions(tree).items():
            if f"{_module(path)}.{name}" in self.edits:
                first = min(1, len(node.body) - 1) if ast.get_docstring(node) is not None else 0
                (stop,) = ast.parse(f"if {STOP}(): breakpoint()").body
                # On the line of the def, because a debugger goes on to the next line.
                for part in ast.walk(stop):
                    if isinstance(part, ast.stmt | ast.expr):
                        part.lineno = part.end_lineno = node.lineno
                node.body.insert(first, stop)
        return compile(tree, path, "exec", dont_inherit=True)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Leave out all other checks."""
        own = [item for item in items if exercise_of(item) == self.exercise]
        items[:] = [item for item in own if item.name in self.failing]

    @pytest.hookimpl(tryfirst=True)
    def pytest_pyfunc_call(self, pyfuncitem: pytest.Function) -> bool:
        """Run a check. If it fails, an earlier run counts the calls until it does."""
        names = pyfuncitem._fixtureinfo.argnames
        arguments = {name: pyfuncitem.funcargs[name] for name in names}
        if self.failing[pyfuncitem.name]:
            # An endless loop is interrupted.
            timer = threading.Timer(Limits().check, _thread.interrupt_main)
            timer.start()
            with _breakpoints_off():
                _fails(lambda: pyfuncitem.obj(**copy.deepcopy(arguments)))
            timer.cancel()
            self.at, self.calls = self.calls, 0
            if not self.at:
                print("It fails before it calls your function. Put breakpoint() where to stop.")
            print(KEYS)
        if "debugpy" not in sys.modules:  # an editor's debugger stops by itself
            sys.breakpointhook = _stop_here
        try:
            if _fails(lambda: pyfuncitem.obj(**arguments)):
                print("\nThe check has ended with the failure above.")
        except BdbQuit:
            pyfuncitem.session.shouldstop = "the student quits"
        return True


class Debugger(Pdb):
    """Python's debugger, which shows a function's arguments first, and no calls above the check."""

    def preloop(self) -> None:
        """Show the arguments before the first prompt."""
        if not getattr(self, "was_here", False):
            self.was_here = True
            self.do_args("")
        super().preloop()

    def get_stack(
        self, f: FrameType | None, t: TracebackType | None
    ) -> tuple[list[tuple[FrameType, int]], int]:
        """Return the calls that ``where`` shows, from the check to the student's line."""
        calls, current = super().get_stack(f, t)
        ours = [Path(frame.f_code.co_filename).is_relative_to(CHECKS) for frame, _ in calls]
        above = ours.index(True) if True in ours else 0
        return calls[above:], current - above


def _stop_here(*_: object, **__: object) -> None:
    """Start the debugger in the function that has called breakpoint()."""
    Debugger(nosigint=True).set_trace(sys._getframe(1))


@contextmanager
def _breakpoints_off() -> Iterator[None]:
    """Let breakpoint() do nothing, here and in the processes that start in this block."""
    hook, sys.breakpointhook = sys.breakpointhook, lambda *_, **__: None
    os.environ["PYTHONBREAKPOINT"] = "0"
    try:
        yield
    finally:
        sys.breakpointhook = hook
        del os.environ["PYTHONBREAKPOINT"]


def _fails(check: Callable[[], object]) -> bool:
    """Run a check, and return True if it fails. BdbQuit, which ends the debugger, is passed on."""
    try:
        check()
    except BdbQuit:
        raise
    except BaseException:  # including KeyboardInterrupt, which ends an endless loop
        return True
    return False


def _module(path: str) -> str:
    """Return a file's folder and name, such as ch02_vectors/vector."""
    return short(path).removesuffix(".py")
