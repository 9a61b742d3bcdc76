"""Run the server of the lab in a separate process, for tests."""

from __future__ import annotations

import contextlib
import re
import subprocess
import sys
from collections.abc import Iterator

from autograder.manifest import ROOT


@contextlib.contextmanager
def served(*options: str, engine: str = "solutions") -> Iterator[str]:
    """Serve the lab and yield its address, which ends with a slash."""
    command = [sys.executable, "-m", "lab", "serve", "--no-browser", "--engine", engine, *options]
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, encoding="utf-8")
    try:
        assert process.stdout is not None
        found = re.search(r"http://\S*", process.stdout.readline())
        assert found
        yield found[0]
    finally:
        process.terminate()
        process.wait()
