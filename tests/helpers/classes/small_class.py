"""Grade a class that has solved the small chapter, in this process, and read the results."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from autograder.course.model import Work
from autograder.grader import cohort
from autograder.grader.cohort import ClassOptions
from autograder.isolation.probe import best_level
from autograder.manifest import ROOT, load_chapters
from autograder.platforms.grade_one import grade_one
from autograder.platforms.gradescope import make_gradescope
from autograder.reports.report import StudentReport
from copies import copy_tree
from small import RIGHT, hand_in

HALF = RIGHT.replace("4 * x", "3 * x")


def make_class(folder: Path) -> Path:
    """Make a class of three: a correct one, a half correct one, and a correct one in a zip."""
    hand_in(folder, "ann", RIGHT)
    hand_in(folder, "bob", HALF)
    with zipfile.ZipFile(folder / "cem.zip", "w") as zipped:
        zipped.writestr("my work/ch90_small/small.py", RIGHT)
    return folder


def grade(
    submissions: Path,
    out: Path,
    root: Path,
    seed: str | None = "1",
    work: Work | None = None,
    **more: Any,
) -> int:
    """Grade a class without a sandbox. ``more`` are parts of the work and options."""
    work = work or Work("", load_chapters(root))
    parts = {name: more.pop(name) for name in [*more] if name in vars(work)}
    options = ClassOptions(root=root, unsafe=True, **more)
    return cohort.grade(submissions, out, replace(work, seed=seed, **parts), options)


def interrupt(out: Path, *options: str, **environment: str) -> str:
    """Grade the sample class in another process until something has landed; return its output."""
    command = [sys.executable, "-m", "autograder", "grade", "sample_class", "--out", str(out)]
    process = subprocess.Popen(
        [*command, "--chapters", "2", *options],
        cwd=ROOT,
        env=os.environ | environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )
    deadline = time.monotonic() + 60.0
    while not [*out.glob("results/*.json")] and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    told, complaint = process.communicate(timeout=60.0)
    assert process.returncode == 130, complaint
    assert "grade: stopped" in complaint
    assert "Traceback" not in complaint
    landed = results(out)
    assert 0 < len(landed) < 8
    assert {report["status"] for report in landed.values()} == {"graded"}
    assert not (out / ".temporary").exists()
    return told


def on_gradescope(work: Work, folder: Path, source: Path) -> StudentReport:
    """Grade the files of chapter 2 in ``source`` with the zip for Gradescope."""
    make_gradescope(work, folder / "a.zip", unsafe=not best_level().is_sandbox)
    with zipfile.ZipFile(folder / "a.zip") as file:
        file.extractall(folder / "source")
    copy_tree(source / "ch02_vectors", folder / "submission/ch02_vectors")
    return grade_one(folder, folder / "source")


def results(out: Path) -> dict[str, dict[str, Any]]:
    reports = [json.loads(path.read_text(encoding="utf-8")) for path in out.glob("results/*.json")]
    return {report["student"]: report for report in reports}


def scores(out: Path) -> dict[str, float | None]:
    return {student: report["score"] for student, report in sorted(results(out).items())}


def table(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def everything_in(out: Path) -> str:
    return "\n".join(
        path.read_text(encoding="utf-8") for path in sorted(out.rglob("*")) if path.is_file()
    )


class SmallClass:
    def __init__(
        self, place: Path, folder: Path, root: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        self.place, self.folder, self.root, self.out = place, folder, root, place / "out"
        self._capsys = capsys

    def printed(self) -> str:
        """Return what was printed since the last call, as one line."""
        return " ".join(self._capsys.readouterr().out.split())

    def hand_in(self, student: str, code: str) -> None:
        hand_in(self.folder, student, code)

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text, encoding="utf-8")

    def grade(self, seed: str | None = "1", **more: Any) -> int:
        return grade(self.folder, self.out, self.root, seed, **more)

    def results(self) -> dict[str, dict[str, Any]]:
        return results(self.out)

    def scores(self) -> dict[str, float | None]:
        return scores(self.out)

    def table(self, name: str) -> list[dict[str, str]]:
        return table(self.out / name)

    def text(self, name: str) -> str:
        return (self.out / name).read_text(encoding="utf-8")

    def everything(self) -> str:
        return everything_in(self.out)
