"""Interrupt student code when its time is up, although a web worker has only one thread.

Python checks for signals from the worker thousands of times per second. When the time is up, the
worker sends SIGALRM, ``Watchdog.hear`` reports the current line, and the page ends the worker.
A loop inside a C function, such as sum, never checks for signals. In that case the page ends the
worker one second later, and the line remains unknown.
"""

from __future__ import annotations

import signal
from collections.abc import Callable
from types import FrameType
from typing import Any

from web.python.browser.page import post, start_clock, stop_clock


class Watchdog:
    """Interrupts student code that runs for too long, and tells the page which line was running.

    Set `explain` to a function that turns a stack trace into an explanation for the page.
    """

    def __init__(self) -> None:
        self.explain: Callable[[str], dict[str, Any]] = lambda _: {}

    def install(self) -> None:
        """Install `hear` as the handler of SIGALRM, which the web worker sends when time is up."""
        signal.signal(signal.SIGALRM, self.hear)

    def start(self, seconds: float) -> None:
        """Start the clock, so that the web worker sends SIGALRM in ``seconds`` seconds."""
        start_clock(seconds)

    def stop(self) -> None:
        stop_clock()

    def hear(self, _: int, frame: FrameType | None) -> None:
        """Send a stack trace to the page, then wait until the page terminates the web worker."""
        stack = stack_of(frame)
        post("hung", stack=stack, **self.explain(stack))
        while True:
            pass


def stack_of(frame: FrameType | None) -> str:
    """Format a frame and its callers like a stack trace from faulthandler, innermost call first."""
    lines = []
    while frame is not None:
        code = frame.f_code
        lines.append(f'  File "{code.co_filename}", line {frame.f_lineno} in {code.co_name}\n')
        frame = frame.f_back
    return "".join(lines)


watchdog = Watchdog()
