"""Draw plots as the command does, and read the tables that it writes."""

from __future__ import annotations

import csv
import subprocess
from pathlib import Path

from studied import study


def plot(engine: str | Path, out: Path, chapters: str = "2") -> subprocess.CompletedProcess[str]:
    return study("plot", "--chapter", chapters, "--engine", str(engine), "--out", str(out))


def table(out: Path, name: str, chapter: str = "ch02_vectors") -> list[list[str]]:
    with (out / chapter / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))
