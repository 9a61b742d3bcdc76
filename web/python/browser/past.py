"""Resume a run of checks after its web worker was terminated.

If a check never ends, the page terminates the worker and keeps its reports. A new worker then
replays these reports instead of running the same checks a second time.
"""

from __future__ import annotations

import os
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from autograder.checks.check_process import Ending
from autograder.checks.events import Event, Started, write_event
from autograder.checks.runner import Run
from autograder.checks.verdict import Verdict
from autograder.diagnosis.explain import explain_hang
from autograder.manifest import ROOT
from autograder.scores import result_of
from autograder.student.failure import failure_of
from web.python.browser.page import post
from web.python.browser.process import run_here
from web.python.browser.report import failure_to_page
from web.python.browser.watchdog import watchdog


@dataclass(frozen=True)
class Past:
    """A record of the checks that an earlier web worker ran in one process, for replaying.

    Attributes:
        run: The chapter and the exercises that were to be checked.
        lines: The reports that the process sent.
        left: The time that remained for all checks when the process began, in seconds.
        seconds: How long the process took.
        stack: What the process was doing when it ran out of time, as a stack trace.
        silent: True if the process stopped responding and had to be killed.
        code: The exit code of the process.
    """

    run: str
    lines: list[str]
    left: float
    seconds: float
    stack: str
    silent: bool
    code: int


class Processes:
    """Runs the checks of one request, or replays what an earlier web worker reported of them."""

    def __init__(self, past: list[dict[str, Any]], *, shallow: bool) -> None:
        self.past = [Past(**one) for one in past]
        self.shallow = shallow

    @property
    def is_live(self) -> bool:
        """True while checks are being run, and False while earlier reports are replayed."""
        return not self.past

    def run(self, run: Run) -> Ending:
        """Run checks as if in a process of their own, or replay them. Return how it ended."""
        request = run.request
        # Folders with given modules have a different name each time, so only their number counts.
        key = f"{request.chapter.name} on {len(request.engine)}: {' '.join(request.exercises)}"
        for past in self.past:
            if past.run == key:
                return self._repeat(run, past)
        left = run.deadline - time.monotonic()
        post("process", run=key, limit=run.limit, left=left)

        def send(event: Event) -> None:
            post("event", line=write_event(event))
            run.take(event)

        with tempfile.TemporaryDirectory(prefix="checks-") as folder:
            watchdog.explain = lambda stack: {"failure": failure_of_hang(run, stack)}
            ending = run_here(run.config(Path(folder)), send, shallow=self.shallow)
        post("ended")
        return ending

    def _repeat(self, run: Run, past: Past) -> Ending:
        """Replay the reports of a process that an earlier web worker ran, and return its ending."""
        for line in past.lines:
            run.hear(line)
        run.deadline = time.monotonic() + past.left - past.seconds
        if past.silent and len(self.past) == 1:
            post("trouble", failure=failure_of_hang(run, ""))
        self.past.remove(past)
        return Ending(past.stack, past.silent, past.code)


def failure_of_hang(run: Run, stack: str) -> dict[str, Any] | None:
    """Build the failure of a check that never ended, or return None if none was running."""
    if not isinstance(run.current, Started):
        return None
    check, request = run.checks[run.current.name], run.request
    why = explain_hang(stack, run.limit, request.engine)
    verdict = Verdict(check.name, check.exercise, check.weight, "failed", why, robust=check.robust)
    result = result_of(request.chapter.exercise(check.exercise), [verdict])
    os.chdir(ROOT)  # the student's code ran in another folder
    failure = failure_of(request.chapter, result, request.engine)
    return failure_to_page(failure) if failure else None
