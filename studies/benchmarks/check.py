"""How long a student waits for make check."""

from __future__ import annotations

import subprocess
import sys
import timeit

from autograder.manifest import ROOT
from studies.timing import Line, ratio


def lines() -> list[Line]:
    """How long make check takes for one chapter, in units of Python importing pytest."""

    def run(*command: str) -> float:
        call = [sys.executable, *command]
        return timeit.timeit(
            lambda: subprocess.run(call, cwd=ROOT, stdout=subprocess.DEVNULL, check=False), number=1
        )

    check = ["-m", "autograder", "check", "--chapter", "2"]
    for _ in range(2):  # the first run compiles
        run(*check)
    measured = ratio(lambda: run(*check), lambda: run("-c", "import pytest"), 15, "make check")
    return [Line("make check CH=2 / python -c 'import pytest'", *measured, "at most 3")]
