"""A copy of the repository, beside the class that the command lines of the README pages name."""

from __future__ import annotations

import csv
import re
import shutil
import sys
from pathlib import Path

from autograder.manifest import ROOT
from staging import zip_of

STUDENTS = {  # the row of the roster, by the name of the submission
    "José Ñandú": ("00042", "José Ñandú", "jose@example.org", "jn1"),
    "Sean O'Neill": ("7001", "Sean O'Neill", "sean@example.org", "so2"),
    "Jane Doe": ("7002", "Doe, Jane", "jane@example.org", "jd1"),
    "7003": ("7003", "Anna Schmidt", "anna@example.org", "as1"),
    "7004": ("7004", "Anna Schmidt", "a.schmidt@example.org", "as2"),
    "王小明": ("7005", "王小明", "wang@example.org", "wx1"),
    "ann": ("7006", "Ann Lee", "ann@example.org", "ann"),
    "": ("7007", "Bo Lee", "bo@example.org", "bl2"),  # handed in nothing
}
CHAPTERS = ("ch02_vectors", "ch03_laws_of_motion")  # the second takes long, so two hand it in
TIMES = [["student", "submitted"], ["42", "2020-10-22 20:15"], ["ann", "2020-10-27 12:00"]]
MARKS = [["student", "exercise", "points", "comment"], ["Jane Doe", "2.2b", "0.5", "Half of it"]]
HIDDEN = '''"""A check that students never get."""

import pytest

from ch03_laws_of_motion.particle import Particle


@pytest.mark.exercise("B3.1")
def test_a_particle_can_be_made() -> None:
    """A particle can be made without arguments."""
    assert isinstance(Particle(), Particle)
'''


def make_readme_class(folder: Path, page: str) -> Path:
    """Return a copy of the repository beside the class; ``page`` has the course file."""
    root = folder / "companion"
    unneeded = shutil.ignore_patterns(".?*", "build", "__pycache__", "hostile")
    shutil.copytree(ROOT, root, ignore=unneeded)
    _make_environment(root / ".venv")
    (course,) = re.findall(r"(?ms)^```toml\n(.+?)^```", page)
    # The due dates have passed, whenever the test runs, because a release waits for them.
    (root / "course.toml").write_text(course.replace("2026-", "2020-"), encoding="utf-8")
    (root / "hidden/ch03_laws_of_motion").mkdir(parents=True)
    (root / "hidden/ch03_laws_of_motion/test_hidden.py").write_text(HIDDEN, encoding="utf-8")
    for roster in (root / "roster.csv", folder / "roster.csv"):
        _write(roster, [["id", "name", "email", "login"], *STUDENTS.values()])
    _hand_in(folder / "handed-in")
    _write(folder / "handed-in/times.csv", TIMES)
    _write(folder / "handed-in/marks.csv", MARKS)
    return root


def _make_environment(venv: Path) -> None:
    """Make an environment with this test's Python, in which make has nothing to install."""
    (venv / "bin").mkdir(parents=True)
    python = venv / "bin/python"
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n', encoding="utf-8")
    python.chmod(0o755)
    for group in ("ready", "teaching", "pictures", "everything"):
        (venv / group).touch()  # which is newer than the copied locks


def _hand_in(folder: Path) -> None:
    """Hand in as folders and zips, and the same again in the zip that Canvas makes of a class."""
    engines = {"7003": "chapters", "7004": "solutions", "ann": "solutions"}
    in_canvas = {}
    for number, (name, (ident, real, _, _)) in enumerate(STUDENTS.items()):
        if not name:
            continue
        engine = ROOT / engines.get(name, "sample_class/ada")
        files = {
            f"{chapter}/{file.name}": file.read_bytes()
            for chapter in CHAPTERS[: 2 if name in ("ann", "王小明") else 1]
            for file in (engine / chapter).glob("*.*")
            if file.suffix in (".py", ".md")
        }
        work = zip_of({f"my work/{path}": content for path, content in files.items()})
        given, _, family = real.replace("Doe, Jane", "Jane Doe").partition(" ")
        letters = "".join(c for c in f"{family}{given}".lower() if c.isalnum())
        in_canvas[f"{letters}_{ident}_{900 + number}_work.zip"] = work
        if number % 2:
            (folder / f"{name}.zip").write_bytes(work)
            continue
        for path, content in files.items():
            (folder / name / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / name / path).write_bytes(content)
    (folder.parent / "lab1.zip").write_bytes(zip_of(in_canvas))


def _write(path: Path, rows: list[list[str]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows(rows)
