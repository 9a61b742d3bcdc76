"""Run the checks with pytest, and report each verdict as soon as it is known.

The runner reads an event, such as a verdict, from each line of this program's output.
"""

from __future__ import annotations

import os
import pickle
import sys
import traceback
from collections.abc import Generator, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NoReturn

import pytest
from _pytest.runner import runtestprotocol

from autograder.at_home.in_process import InProcess, Send
from autograder.checks.arrange import Config
from autograder.checks.asked import about
from autograder.checks.events import Check, Checks, Decided, Ended, Event, Started, write_event
from autograder.checks.forked import run_forked
from autograder.diagnosis.explain import explain_exception
from autograder.diagnosis.faults import CheckEnded, GraderFault, StudentLeft, fault_of
from autograder.message import NOTHING, Message, with_texts
from autograder.text.wrapping import few_lines

if TYPE_CHECKING:
    from autograder.isolation.in_worker import InWorker

# No check uses these plugins of pytest. Students wait a sixth less if we leave them out.
UNUSED_PLUGINS = (
    "terminal cacheprovider doctest faulthandler junitxml legacypath logging pastebin setuponly "
    "setupplan stepwise unittest debugging warnings unraisableexception threadexception recwarn "
    "subtests"
)

MOST_KEPT = (40, 2000)  # how many lines and characters of the printed output we keep


class Recorder:
    """A pytest plugin that selects the checks to run, and reports the verdicts."""

    def __init__(self, config: Config, send: Send, engine: InProcess | None = None) -> None:
        self.config = config
        self.send = send
        self.engine: InProcess | InWorker
        if engine or config.level is None:
            self.engine = engine or InProcess(config)
        else:
            from autograder.isolation.in_worker import InWorker  # not in handouts

            self.engine = InWorker(config)

    def pytest_sessionstart(self) -> None:
        """Import the student's modules before pytest collects the checks that use them."""
        self.engine.open(self.config.modules, self.config.broken, self.send)

    def pytest_collection_finish(self) -> None:
        """Prepare the engine to run the student's code in checks."""
        self.engine.after_collection()

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """If a check file cannot be imported, print the error to stderr for the runner."""
        if report.failed:
            print(report.longreprtext, file=sys.stderr)

    def pytest_collection_modifyitems(
        self, config: pytest.Config, items: list[pytest.Item]
    ) -> None:
        """Sort the checks into manifest order, announce them, and drop those with a verdict."""
        order = {exercise: place for place, exercise in enumerate(self.config.exercises)}
        for item in items:
            if (exercise := exercise_of(item)) not in self.config.known:
                raise pytest.UsageError(f"{item.nodeid} belongs to an unknown exercise, {exercise}")
        items[:] = [item for item in items if exercise_of(item) in order]
        items.sort(key=lambda item: (order[exercise_of(item)], _is_robust(item)))
        checks, hidden = [], 0
        for item in items:
            name, rationale = item.name, None
            if self._is_hidden(item):
                hidden += 1
                item.name = f"hidden check {hidden}"  # the real name may reveal what is checked
                # Students see only this line of a hidden check.
                lines = (getattr(item, "obj", None).__doc__ or "").strip().splitlines()
                rationale = lines[0] if lines else "a hidden check of this exercise fails"
            weight = _marker(item).kwargs.get("weight", 1)
            exercise, robust = exercise_of(item), _is_robust(item)
            checks.append(Check(item.name, exercise, weight, robust, rationale, name))
        self.send(Checks(checks))
        left_out = [item for item in items if item.name in self.config.done]
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in left_out]

    def _is_hidden(self, item: pytest.Item) -> bool:
        """Return True if an instructor supplied this check, and students may not see it."""
        return item.path.is_relative_to(Path(self.config.root) / "tests/hidden")

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool | None:
        """Run the checks of each exercise in a forked copy of this process, unless in a sandbox."""
        forks = isinstance(self.engine, InProcess) and self.engine.forks
        if session.testsfailed or not forks:
            return None  # pytest reports a failed collection, or runs the checks as usual
        for _, group in groupby(session.items, exercise_of):
            run_forked(partial(run_all, list(group)))
        return True

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Generator[None, Any, Any]:
        """Announce a check, and start its time limit and, in a sandbox, its worker process."""
        self.send(Started(item.name))
        about.forget()
        about.read = _marker(item).kwargs.get("read", "")
        # It is stopped after the report, since an exception's str() may hang.
        self.engine.start(hidden=self._is_hidden(item))
        try:
            return (yield)
        except MemoryError as error:
            # What used up the memory is still referred to by the traceback.
            traceback.clear_frames(error.__traceback__)
            used_up = MemoryError()
            fault = getattr(error, "fault", None) or fault_of(error, self.engine.engine)
            used_up.fault = fault  # type: ignore[attr-defined]
            raise used_up from None
        except KeyboardInterrupt as error:  # from student code; pytest would end the run
            left = StudentLeft(str(error))
            left.fault = fault_of(error, self.engine.engine)
            raise left.with_traceback(error.__traceback__) from None

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(
        self, item: pytest.Item, call: pytest.CallInfo[None]
    ) -> Generator[None, pytest.TestReport, pytest.TestReport]:
        """Report the verdict on a check. An error outside its body is the grader's fault."""
        # Nobody reads pytest's traceback, and formatting it would take four times as long as
        # everything else here.
        setattr(item, "repr_failure", str)  # noqa: B010
        report = yield
        status: Literal["passed", "failed", "error"] = "passed"
        message = NOTHING
        if call.excinfo is not None:
            error = call.excinfo.value
            ours = report.when != "call" or isinstance(error, GraderFault)
            status = "error" if ours else "failed"
            if isinstance(error, CheckEnded):
                message = error.message
            elif isinstance(error, (pytest.fail.Exception, GraderFault)):
                message = Message(str(error))
            else:
                message = explain_exception(error, self.engine.engine, self.config.complete)
        if report.when == "call":
            printed = self.engine.stop()
            if printed and message:
                message = replace(message, printed=few_lines(printed, *MOST_KEPT))
        if report.when == "call" or status == "error":
            # A point on the chart could reveal what a hidden check measures.
            hidden = self._is_hidden(item)
            point: Any = None if hidden else dict(item.user_properties).get("on_chart")
            message = with_texts(message, self._without_folders)
            self.send(Decided(item.name, status, message, point))
        return report

    def _without_folders(self, text: str) -> str:
        """Shorten the paths in a message, so that it is the same in the grader."""
        for folder in self.engine.engine:
            text = text.replace(f"{folder}{os.sep}", "")
        return text

    def pytest_sessionfinish(self, exitstatus: int) -> None:
        code = pytest.ExitCode
        if exitstatus in (code.OK, code.TESTS_FAILED, code.NO_TESTS_COLLECTED):
            self.send(Ended())


def run_all(checks: list[pytest.Item]) -> None:
    for check in checks:
        runtestprotocol(check, log=False)


def exercise_of(item: pytest.Item) -> str:
    """Return the id of the exercise that a check tests, such as B2.3."""
    return str(_marker(item).args[0])


def _marker(item: pytest.Item) -> pytest.Mark:
    marker = item.get_closest_marker("exercise")
    if marker is None or not marker.args:
        raise pytest.UsageError(f"{item.nodeid} has no exercise marker with an id")
    return marker


def _is_robust(item: pytest.Item) -> bool:
    """Return True if a check tests bad arguments, overflow or NaN rather than the physics."""
    return item.get_closest_marker("robust") is not None


def run_and_exit() -> NoReturn:
    """Run the checks of the configuration file on the command line, and end the process."""
    config: Config = pickle.loads(Path(sys.argv[1]).read_bytes())
    wire = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # student output must not mix with verdicts

    def send(event: Event) -> None:
        wire.write(write_event(event))
        wire.flush()

    arguments = pytest_arguments(config.tests, config.root, config.seed, config.engine)
    code = int(pytest.main(arguments, plugins=[Recorder(config, send)]))
    sys.stderr.flush()
    os._exit(code)  # threads or exit handlers of the student's code must not keep the process


def pytest_arguments(
    tests: Sequence[str], root: Path | str, seed: str, engine: Iterable[Path | str]
) -> list[str]:
    """Assemble pytest's command line. The paths in ``tests`` are relative to ``root``."""
    arguments = [*tests, "--capture=no", f"--rootdir={root}", f"--seed={seed}"]
    arguments += [f"--engine={folder}" for folder in engine]
    for plugin in UNUSED_PLUGINS.split():
        arguments += ["-p", f"no:{plugin}"]
    return arguments


if __name__ == "__main__":
    run_and_exit()
