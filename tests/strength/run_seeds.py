"""Run the checks with many seeds on both right solutions: the reference and the second one."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path

from autograder.manifest import ROOT, Chapter
from kept import FILE, SOLUTIONS, files_of_checks, keep_seeds, seeds_of


def run_seeds(chapters: list[Chapter], seeds: int, jobs: int) -> bool:
    """Run the chapters' checks with this many seeds on each solution; return success.

    Files of checks that have passed with as many seeds, and have not changed since, are left out.
    """
    python = ".".join(platform.python_version_tuple()[:2])
    success = True
    for solution in SOLUTIONS:
        for chapter in chapters:
            known = seeds_of(solution, chapter)
            files = files_of_checks(chapter)
            checks = [file for file in files if known[file.name].get(python, 0) < seeds]
            print(
                f"{solution}, chapter {chapter.number}, {seeds} seeds, Python {python}: "
                f"{len(checks)} of {len(known)} files of checks, the others have not changed",
                flush=True,
            )
            if checks:
                held = _run(solution, checks, seeds, jobs)
                success = success and held
                for check in checks:
                    keep_seeds(solution, chapter, check, python, seeds if held else 0)
    print(f"kept in {FILE}: {'all' if success else 'not all'} earn every point")
    return success


def _run(solution: str, checks: list[Path], seeds: int, jobs: int) -> bool:
    engine = [*dict.fromkeys([SOLUTIONS[solution], ROOT / "solutions", ROOT / "chapters"])]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "seeds", "--seeds", str(seeds)]
    command += ["-n", str(jobs), *(word for folder in engine for word in ("--engine", str(folder)))]
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parent)}
    done = subprocess.run([*command, *map(str, checks)], cwd=ROOT, env=environment, check=False)
    return done.returncode == 0
