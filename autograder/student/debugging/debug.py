"""Run an exercise's checks until one fails, and stop in the student's function at that call.

The check that fails in a process of its own then runs twice in this one. The first run counts the
calls of the exercise's functions until the failure, and the second stops at the last of them.
"""

from __future__ import annotations

import _thread
import copy
import os
import sys
import threading
from bdb import BdbQuit
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from pdb import Pdb
from types import FrameType, TracebackType

import pytest

from autograder.checks.pytest_plugin import exercise_of, pytest_arguments
from autograder.checks.runner import Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.commands import command
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.message import Kind
from autograder.student.debugging.stops import Stops

CHECKS = ROOT / "tests"
KEYS = """\
n  next line            a  the arguments of the function    c  continue
s  step into a call     w  where you are                    q  quit
p NAME  print a value"""


def debug(chapter: Chapter, exercise: Exercise, folders: list[Path], seed: str) -> bool:
    """Find the first check of an exercise that fails, and debug it. Return True if none fails."""
    with _breakpoints_off():
        verdicts = run_checks(chapter, folders, seed=seed, exercises=[exercise.id])
    failed = [verdict for verdict in verdicts if verdict.status != "passed"]
    own = [verdict for verdict in verdicts if verdict.exercise == exercise.id]
    if not failed:
        print(f"All checks of {exercise.id} pass. They run again, to stop at your breakpoints.")
        _run(chapter, exercise, folders, seed, own)
        return True
    first = failed[0]
    print(f"{first.exercise}, {first.name}:\n{first.message}\n")
    if first.exercise != exercise.id:
        print(f"{exercise.id} builds on it. Start there: {command('debug', EX=first.exercise)}")
    elif first.message.kind in (Kind.UNWRITTEN, Kind.BROKEN):
        print("There is no code to step through yet.")
    else:
        _run(chapter, exercise, folders, seed, [first])
    return False


def _run(
    chapter: Chapter, exercise: Exercise, folders: list[Path], seed: str, checks: Sequence[Verdict]
) -> None:
    """Run checks in this process, and stop in the student's code."""
    stops = Stops([f"{chapter.name}/{edit}" for edit in exercise.edit], folders)
    stops.install()
    failing = {check.name for check in checks if check.status != "passed"}
    plugin = Debugging(stops, exercise, {check.name for check in checks}, failing)
    arguments = pytest_arguments([f"tests/{chapter.name}"], ROOT, seed, folders)
    pytest.main(arguments, plugins=[plugin])


@dataclass
class Debugging:
    """A pytest plugin that runs the chosen checks, and stops in the student's function."""

    stops: Stops
    exercise: Exercise
    names: set[str]
    failing: set[str]

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Leave out all other checks."""
        items[:] = [i for i in items if exercise_of(i) == self.exercise.id and i.name in self.names]

    @pytest.hookimpl(tryfirst=True)
    def pytest_pyfunc_call(self, pyfuncitem: pytest.Function) -> bool:
        """Run a check. If it fails, an earlier run counts the calls until it does."""
        names = pyfuncitem._fixtureinfo.argnames
        arguments = {name: pyfuncitem.funcargs[name] for name in names}
        if pyfuncitem.name in self.failing:
            with _breakpoints_off(), _limited(Limits().check):
                _fails(lambda: pyfuncitem.obj(**copy.deepcopy(arguments)))
            self.stops.at, self.stops.calls = self.stops.calls, 0
            if not self.stops.at:
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


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    """Interrupt an endless loop."""
    timer = threading.Timer(seconds, _thread.interrupt_main)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _fails(check: Callable[[], object]) -> bool:
    """Run a check, and return True if it fails. BdbQuit, which ends the debugger, is passed on."""
    try:
        check()
    except BaseException as error:  # including KeyboardInterrupt, which ends an endless loop
        if isinstance(error, BdbQuit):
            raise
        return True
    return False
