"""Notice that the time is up in a student's code, in the one thread that a worker has.

No other thread and no alarm can interrupt it. But Python asks the worker, some thousands of times in
a second, whether a signal has come. From when the time is up, the worker says SIGALRM, and Python
calls ``hear`` in the middle of whatever the code is doing. The page then ends the worker. A loop
inside a function of C, such as sum, never asks: the page ends that a second later.
"""

from __future__ import annotations

import signal
from types import FrameType

from web.python.browser.page import post


def install() -> None:
    """Have Python call us when the worker says that the time is up."""
    signal.signal(signal.SIGALRM, hear)


def hear(_: int, frame: FrameType | None) -> None:
    """Tell the page where the code is, and wait for the end."""
    post("hung", stack=stack_of(frame))
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
