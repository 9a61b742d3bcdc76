"""Run one of our commands in a new process, as somebody types it at a terminal."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from autograder.manifest import ROOT


def typed(
    *words: str | Path, cwd: Path = ROOT, text: str = "", **environment: str
) -> subprocess.CompletedProcess[str]:
    """Run a module as in typed("autograder", "check"); ``text`` is its standard input."""
    return subprocess.run(
        [sys.executable, "-m", *map(str, words)],
        cwd=cwd,
        env=os.environ | environment,
        input=text,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
