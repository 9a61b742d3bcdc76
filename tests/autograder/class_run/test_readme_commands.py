"""The instructors' and students' command lines of the README pages run as they are printed."""

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
from printed import PAGES, command_lines
from readme_class import STUDENTS, make_readme_class

RUN = {"grade", "release", "similarity", "handout", "classroom", "gradescope"}
RUN |= {"check", "hint", "reset"}
# Those that run until they are stopped, and what they print once they run.
STARTED = {"mark": "Press Ctrl-C to stop", "watch": "Next: ", "lab": "Press Ctrl-C to stop"}
# Those that take minutes, may open a window or need Node. The quick tests read their variables.
ONLY_READ = {"plot", "choose", "measure", "site", "update", "figures", "test", "test-all", "lint"}
# Lines that put another class in the place of the one of the page's other lines, so that they stop
# unless the results are moved, as they say.
OTHER_CLASS = ["make grade SUBMISSIONS=../lab1.zip ROSTER=../roster.csv"]
COURSES = {"docs/study_guide.md": ROOT / "docs/plans/twelve_weeks.toml"}  # copied, as the page says
PATH = re.compile(r"(?m)^(?:[\w ]+: )?((?:build|\.\.)/\S*\w)$")
pytestmark = [
    pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here"),
    pytest.mark.skipif(not best_level().is_sandbox, reason="there is no sandbox here"),
]


def run(line: str, root: Path) -> None:
    """Run a line in a shell. It must succeed, and every path that it prints must be there."""
    done = subprocess.run(
        line, shell=True, cwd=root, capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == 0, f"{line}\n{done.stdout}\n{done.stderr}"
    assert "Traceback" not in done.stdout + done.stderr
    assert done.stdout, line
    for path in PATH.findall(done.stdout):
        assert (root / path).exists(), f"{line}: {path}"


def start(line: str, words: str, root: Path) -> None:
    """Run a line until it prints some words, and then stop it as Ctrl-C does."""
    browser = os.environ | {"BROWSER": "true", "PYTHONUNBUFFERED": "1"}
    how = {"shell": True, "cwd": root, "env": browser, "encoding": "utf-8"}
    with subprocess.Popen(
        line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, **how
    ) as process:
        late = threading.Timer(60.0, os.killpg, (process.pid, signal.SIGKILL))
        late.start()
        printed = ""
        for printed_line in process.stdout or ():
            printed += printed_line
            if words in printed and process.poll() is None:
                os.killpg(process.pid, signal.SIGINT)
                break
        printed += process.stdout.read() if process.stdout else ""
        process.wait()
        late.cancel()
    assert words in printed, f"{line}\n{printed}"
    assert "Traceback" not in printed, f"{line}\n{printed}"


@pytest.mark.parametrize("page", PAGES)
def test_each_line_of_a_page_runs_as_printed(page: str, tmp_path: Path) -> None:
    lines = [line for line in command_lines(page) if line.startswith("make ")]
    names = {line: line.split()[1] for line in lines}
    assert {*names.values()} <= RUN | STARTED.keys() | ONLY_READ, "say above what to do with it"
    text = (ROOT / "autograder/README.md").read_text(encoding="utf-8")
    if {*names.values()} <= ONLY_READ:
        return
    root = make_readme_class(tmp_path, text)
    if page in COURSES:
        shutil.copyfile(COURSES[page], root / "course.toml")
    for line, name in names.items():
        if line in OTHER_CLASS:
            (root / "build").rename(root / "build-before")
        if name in RUN:
            run(line, root)
        elif name in STARTED:
            start(line, STARTED[name], root)
        if line in OTHER_CLASS:
            everybody_has_one_row(root / "build/grades/gradebook.csv")
            shutil.rmtree(root / "build")
            (root / "build-before").rename(root / "build")
    if page == "autograder/README.md":
        everybody_has_one_row(root / "build/lab1/grades/gradebook.csv")


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
