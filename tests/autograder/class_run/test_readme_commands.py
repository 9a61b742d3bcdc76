"""The instructors' command lines of the README page run as they are printed."""

from __future__ import annotations

import csv
import os
import re
import shutil
import signal
import subprocess
import threading
from pathlib import Path

import pytest

from autograder.isolation.probe import best_level
from autograder.manifest import ROOT
from printed import command_lines
from readme_class import STUDENTS, make_readme_class

PAGE = "autograder/README.md"
# It puts another class in the place of that of the other lines, so that it stops unless the results
# are moved, as it says.
OTHER_CLASS = "make grade SUBMISSIONS=../lab1.zip ROSTER=../roster.csv"
PATH = re.compile(r"(?m)^(?:[\w ]+: )?((?:build|\.\.)/\S*\w)$")


def run(line: str, root: Path) -> None:
    """Run a line until it ends or waits for Ctrl-C. Every path that it prints must exist."""
    browser = os.environ | {"BROWSER": "true", "PYTHONUNBUFFERED": "1"}
    how = {"shell": True, "cwd": root, "env": browser, "encoding": "utf-8"}
    with subprocess.Popen(
        line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, **how
    ) as process:
        late = threading.Timer(600.0, os.killpg, (process.pid, signal.SIGKILL))
        late.start()
        printed = ""
        for printed_line in process.stdout or ():
            printed += printed_line
            if "Press Ctrl-C to stop" in printed_line:
                os.killpg(process.pid, signal.SIGINT)
        process.wait()
        late.cancel()
    stopped = "Press Ctrl-C to stop" in printed
    assert stopped if line.startswith("make mark") else process.returncode == 0, printed
    assert "Traceback" not in printed, f"{line}\n{printed}"
    for path in PATH.findall(printed):
        assert (root / path).exists(), f"{line}: {path}"


@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")
@pytest.mark.skipif(not best_level().is_sandbox, reason="there is no sandbox here")
def test_each_line_of_the_page_runs_as_printed(tmp_path: Path) -> None:
    root = make_readme_class(tmp_path, (ROOT / PAGE).read_text(encoding="utf-8"))
    build, before = root / "build", root / "build-before"
    for line in (line for line in command_lines(PAGE) if line.startswith("make ")):
        if line == OTHER_CLASS:
            build.rename(before)
        run(line, root)
        if line == OTHER_CLASS:
            everybody_has_one_row(build / "grades/gradebook.csv")
            shutil.rmtree(build)
            before.rename(build)
    everybody_has_one_row(build / "lab1/grades/gradebook.csv")


def everybody_has_one_row(gradebook: Path) -> None:
    with gradebook.open(encoding="utf-8", newline="") as file:
        rows = [row["student"] for row in csv.DictReader(file)][1:]
    names = [name for _, name, _, _ in STUDENTS.values()]
    ids = [ident for ident, *_ in STUDENTS.values()]
    wanted = [
        f"{name} ({ident})" if names.count(name) > 1 else name
        for name, ident in zip(names, ids, strict=True)
    ]
    assert sorted(rows) == sorted(wanted)
