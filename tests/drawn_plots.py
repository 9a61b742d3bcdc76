"""Draw plots as the command does, and read the tables that they write."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

from autograder.manifest import ROOT


def plot(engine: str | Path, out: Path, chapters: str = "2") -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "studies", "plot", "--chapter", chapters]
    command += ["--engine", str(engine)]
    return subprocess.run(
        [*command, "--out", str(out)],
        cwd=ROOT,
        env=os.environ | {"MPLBACKEND": "Agg"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


def table(out: Path, name: str, chapter: str = "ch02_vectors") -> list[list[str]]:
    with (out / chapter / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))
