"""Run the checks with many seeds on both right solutions: the reference and the second one."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

from autograder.manifest import ROOT, Chapter
from kept import FILE, SOLUTIONS, files_of_checks, keep_seeds, seeds_of


def run_seeds(chapters: list[Chapter], seeds: int, jobs: int) -> bool:
    """Run the files of checks that have not yet passed with so many seeds; return success."""
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
            failing = _failing(solution, checks, seeds, jobs) if checks else set()
            success = success and not failing
            for check in checks:
                held = check.name not in failing
                keep_seeds(solution, chapter, check, python, seeds if held else 0)
    print(f"kept in {FILE}: {'all' if success else 'not all'} earn every point")
    return success


def _failing(solution: str, checks: list[Path], seeds: int, jobs: int) -> set[str]:
    """Run files of checks, and return the names of those that fail with a seed."""
    engine = [*dict.fromkeys([SOLUTIONS[solution], ROOT / "solutions", ROOT / "chapters"])]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "seeds", "--seeds", str(seeds)]
    command += ["-n", str(jobs), *(word for folder in engine for word in ("--engine", str(folder)))]
    environment = os.environ | {"PYTHONPATH": str(Path(__file__).parent)}
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder, "report.xml")
        command += [f"--junitxml={report}", *map(str, checks)]
        done = subprocess.run(command, cwd=ROOT, env=environment, check=False)
        if done.returncode == 0:
            return set()
        cases = ElementTree.parse(report).iter("testcase") if report.exists() else []
        modules = [case.get("classname", "") for case in cases if len(case)]
    # Without a report, or with errors outside of the checks, nothing is known about any file.
    found = {f"{module.rpartition('.')[2]}.py" for module in modules}
    names = {check.name for check in checks}
    return found if found and found <= names else names
