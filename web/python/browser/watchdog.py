"""Notice that the time is up in a student's code, in the one thread that a worker has.

No other thread and no alarm can interrupt it. But Python asks the worker, thousands of times in a
second, whether a signal has come. When the time is up, the worker answers with SIGALRM, and Python
calls ``Watchdog.hear`` in the middle of whatever the code is doing. The page then ends the worker.
A loop inside a function of C, such as sum, never asks: the page ends that a second later.
"""

from __future__ import annotations

import signal
from collections.abc import Callable
from types import FrameType
from typing import Any

from web.python.browser.page import post, start_clock, stop_clock


class Watchdog:
    """Tells the page of code that does not end, in the words of who has started the clock."""

    def __init__(self) -> None:
        self.explain: Callable[[str], dict[str, Any]] = lambda _: {}

    def install(self) -> None:
        """Have Python call us when the worker says that the time is up."""
        signal.signal(signal.SIGALRM, self.hear)

    def start(self, seconds: float) -> None:
        """Start the clock."""
        start_clock(seconds)

    def stop(self) -> None:
        """Stop the clock."""
        stop_clock()

    def hear(self, _: int, frame: FrameType | None) -> None:
        """Tell the page where the code is, and wait for the end."""
        stack = stack_of(frame)
        post("hung", stack=stack, **self.explain(stack))
        while True:
            pass


def stack_of(frame: FrameType | None) -> str:
    """Return a stack as faulthandler writes it, the innermost call first."""
    lines = []
    while frame is not None:
        code = frame.f_code
        lines.append(f'  File "{code.co_filename}", line {frame.f_lineno} in {code.co_name}\n')
        frame = frame.f_back
    return "".join(lines)


watchdog = Watchdog()
