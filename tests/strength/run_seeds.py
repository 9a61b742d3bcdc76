"""Run the checks with many seeds on both right solutions: the reference and the second one."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path

from autograder.manifest import ROOT, Chapter
from kept import FILE, SECOND, keep


def run_seeds(chapters: list[Chapter], seeds: int, jobs: int) -> bool:
    """Run the chapters' checks with this many seeds on each solution; return success."""
    python = ".".join(platform.python_version_tuple()[:2])
    success = True
    for name, folders in (("reference", []), ("second solution", [SECOND])):
        engine = [*folders, ROOT / "solutions", ROOT / "chapters"]
        for chapter in chapters:
            print(f"{name}, chapter {chapter.number}, {seeds} seeds, Python {python}:", flush=True)
            held = _run(chapter, engine, seeds, jobs)
            success = success and held
            keep(f"seeds of {name}", chapter, **{python: seeds if held else 0})
    print(f"kept in {FILE}: {'all' if success else 'not all'} earn every point")
    return success


def _run(chapter: Chapter, engine: list[Path], seeds: int, jobs: int) -> bool:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "seeds", "--seeds", str(seeds)]
    command += ["-n", str(jobs), *(word for folder in engine for word in ("--engine", str(folder)))]
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parent)}
    done = subprocess.run(
        [*command, str(ROOT / "tests" / chapter.name)], cwd=ROOT, env=environment, check=False
    )
    return done.returncode == 0
