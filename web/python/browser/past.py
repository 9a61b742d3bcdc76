"""Continue a run that another worker has begun: what its processes told comes first.

A check that does not end costs its worker. The page keeps what the worker told, and a new one
starts from the beginning: what is known already is not run again.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from autograder.checks.arrange import Config
from autograder.checks.events import Event, write_event
from autograder.checks.in_process import Tell
from autograder.checks.judge import Ending
from autograder.checks.runner import Run
from web.python.browser.page import post


@dataclass(frozen=True)
class Past:
    """A process that another worker has had: what it told, and how it ended.

    It began ``left`` seconds before the time for all checks was used up, and took ``seconds``.
    """

    lines: list[str]
    left: float
    seconds: float
    stack: str
    silent: bool
    code: int


class Processes:
    """The processes of a check, in the order in which they are run."""

    def __init__(self, past: list[dict[str, Any]], run: Callable[[Config, Tell], Ending]) -> None:
        self.past = [Past(**one) for one in past]
        self.run = run

    @property
    def is_live(self) -> bool:
        """Whether what is told now is told for the first time."""
        return not self.past

    def judge(self, run: Run) -> Ending:
        """Have a run take what its next process tells."""
        if self.past:
            return self._repeat(run)
        left = run.deadline - time.monotonic()
        post("process", limit=run.limit, left=left)

        def tell(event: Event) -> None:
            post("event", line=write_event(event))
            run.take(event)

        with tempfile.TemporaryDirectory(prefix="checks-") as folder:
            ending = self.run(run.config(Path(folder)), tell)
        post("ended")
        return ending

    def _repeat(self, run: Run) -> Ending:
        """Have a run take what a process told before, as if it were told now."""
        past = self.past[0]
        for line in past.lines:
            run.hear(line)
        run.deadline = time.monotonic() + past.left - past.seconds
        del self.past[0]
        return Ending(past.stack, past.silent, past.code)
