"""Every command line of a README page is one that make or Python accepts."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys

import pytest

from autograder import __main__ as autograder
from autograder.manifest import ROOT
from printed import PAGES, TAKES, command_lines

# What is added to a line of Python, so that it reads its options and does nothing.
ONLY_READ = {
    "-m dask": "--help",
    "-m http.server": "--help",
    "-m pytest": "--collect-only -p no:cacheprovider",
}


def lines_of(page: str, program: str) -> list[list[str]]:
    """Return the words of a page's lines that start a program, without its environment."""
    lines = [re.sub(r"^[A-Z]+=\S+ ", "", line) for line in command_lines(page)]
    return [shlex.split(line) for line in lines if program in line.split()[0]]


@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")
@pytest.mark.parametrize("page", PAGES)
def test_make_accepts_each_line(page: str) -> None:
    for _, *words in lines_of(page, "make"):
        command = ["make", "--dry-run", "--old-file=.venv/ready", *words]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == 0, f"{page}: {shlex.join(command)}\n{done.stderr}"


LESSONS = [page.relative_to(ROOT).as_posix() for page in ROOT.glob("chapters/**/*.md")]


@pytest.mark.parametrize("page", [*PAGES, *LESSONS])
def test_each_command_and_each_variable_exists(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    assert {*re.findall(r"(?:^(?: {4})?|`)make ([a-z-]+)", text, re.M)} <= TAKES.keys()
    taken = {name for names in TAKES.values() for name in names}
    assert {*re.findall(r"`([A-Z]+)=[^` ]*`", text)} <= taken


@pytest.mark.parametrize("page", PAGES)
def test_python_accepts_each_line(page: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for _, *words in lines_of(page, "python"):
        start = " ".join(words[:2])
        if words[0] == "autograder/make_venv.py":
            assert all((ROOT / f"autograder/locks/{group}.lock").exists() for group in words[1:])
        elif start == "-m autograder" and "--help" not in words:
            monkeypatch.setattr(sys, "argv", words[1:])
            monkeypatch.setattr(autograder, "prepare", lambda *_: False)  # ends after the options
            assert autograder.main() == 2, words
        else:
            command = [sys.executable, *words, *ONLY_READ.get(start, "--help").split()]
            done = subprocess.run(
                command, cwd=ROOT, capture_output=True, encoding="utf-8", check=False
            )
            assert done.returncode == 0, f"{page}: {shlex.join(command)}\n{done.stdout}"
