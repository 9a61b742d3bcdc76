"""Measure how long students wait for `make check`, the command that checks their work."""

from __future__ import annotations

import subprocess
import sys

from autograder.manifest import ROOT
from scenes.timing import Measurement, Target, Timer, timer, versus


def lines() -> list[Measurement]:
    """Set up the benchmark that compares `make check` for one chapter with importing pytest."""
    check = running("-m", "autograder", "check", "--chapter", "2")
    for _ in range(2):  # the first run compiles the modules
        check()
    what = "make check CH=2 / importing pytest"
    figure = versus(check, running("-c", "import pytest"))
    return [Measurement(what, figure, 15, Target("at most", 3))]


def running(*command: str) -> Timer:
    """Return a function that runs Python with these arguments and returns the time taken, in s."""
    call = [sys.executable, *command]
    return timer(lambda: subprocess.run(call, cwd=ROOT, stdout=subprocess.DEVNULL, check=False))
