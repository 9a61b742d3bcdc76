"""Measure how long a student waits for `make check`."""

from __future__ import annotations

import subprocess
import sys

from autograder.manifest import ROOT
from studies.timing import Measurement, Target, Timer, timer, versus


def lines() -> list[Measurement]:
    """Measure how long make check takes for one chapter, relative to importing pytest."""
    check = running("-m", "autograder", "check", "--chapter", "2")
    for _ in range(2):  # the first run compiles the modules
        check()
    what = "make check CH=2 / importing pytest"
    figure = versus(check, running("-c", "import pytest"))
    return [Measurement(what, figure, 15, Target("at most", 3))]


def running(*command: str) -> Timer:
    """Return a timer for a run of Python with these arguments."""
    call = [sys.executable, *command]
    return timer(lambda: subprocess.run(call, cwd=ROOT, stdout=subprocess.DEVNULL, check=False))
