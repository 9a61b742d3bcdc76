"""Explain to students why their code failed in a plot or in a scene of the lab."""

from __future__ import annotations

import os
import sys
import threading
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from autograder.at_home.restrictions import LIBRARY
from autograder.commands import LackingError, advice
from autograder.diagnosis.faults import is_inside
from autograder.diagnosis.slips import slip_of
from autograder.files import from_here
from autograder.manifest import ROOT
from scenes.engine import RejectedFileError


def reason(error: BaseException) -> str:
    """Describe an error in a student's code: its message, line and, if common, its cause."""
    if isinstance(error, NotImplementedError):
        return f"not written yet: {error}"
    if isinstance(error, RejectedFileError | LackingError):
        return str(error)
    if isinstance(error, SyntaxError) and error.filename:
        file, line, words = error.filename, error.lineno, error.msg
    else:
        last = _last_of_theirs(traceback.extract_tb(error.__traceback__))
        file, line, words = last.filename, last.lineno, str(error)
    told = f"{type(error).__name__}: {words}"
    likely = slip_of(told) or advice(error)
    where = f"{told} ({from_here(Path(file))}, line {line})"
    return f"{where}\nlikely    {likely}" if likely else where


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """End the program if the block takes longer, and say in which line it was then."""
    timer = threading.Timer(seconds, _give_up, (seconds, threading.get_ident()))
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _give_up(seconds: float, thread: int) -> None:
    last = _last_of_theirs(traceback.extract_stack(sys._current_frames()[thread]))
    file = from_here(Path(last.filename))
    print(
        f"not finished after {seconds:g} s, at {file}, line {last.lineno}. "
        "Is there an endless loop, or is the computer busy with something else?",
        flush=True,
    )
    os._exit(1)  # nothing else ends a loop in another thread


def _last_of_theirs(frames: Sequence[traceback.FrameSummary]) -> traceback.FrameSummary:
    """Return the innermost frame that is neither in a library nor in the autograder."""
    not_theirs = [*LIBRARY, ROOT / "autograder"]  # autograder itself rejects some imports
    return ([f for f in frames if not is_inside(f.filename, not_theirs)] or list(frames))[-1]
