"""A repository with a single small chapter of four checks, for testing the tools."""

from __future__ import annotations

import shutil
from pathlib import Path

from autograder.handouts.handout import student_tools
from autograder.manifest import ROOT

MANIFEST = """
title = "Small"

[[exercise]]
id = "B90.1"
title = "Double"
kind = "build"
stars = 1
points = 4
edit = ["small.double"]
hints = ["twice"]
terms = []

[[exercise]]
id = "90.1"
title = "Quadruple"
kind = "exercise"
stars = 1
points = 2
edit = ["small.quadruple"]
needs = ["B90.1"]
hints = ["double the double"]
terms = []
"""
WRITTEN = """
[[exercise]]
id = "90.2"
title = "Why"
kind = "written"
stars = 1
points = 3
hints = ["think"]
terms = []
"""
STUB = """
def double(x):
    raise NotImplementedError("Exercise B90.1: Double")


def quadruple(x):
    raise NotImplementedError("Exercise 90.1: Quadruple")
"""
CHECKS = """
import pytest
from ch90_small import small


@pytest.mark.exercise("90.1")
def test_quadruple():
    assert small.quadruple(3) == 12, "quadruple must quadruple"


@pytest.mark.exercise("90.1")
def test_quadruple_of_zero():
    assert small.quadruple(0) == 0, "quadruple of zero is zero"


@pytest.mark.exercise("B90.1", weight=3)
def test_double(rng):
    value = rng.randint(1, 1000)
    assert small.double(value) == 2 * value, "double must double"


@pytest.mark.exercise("B90.1")
def test_double_of_zero():
    assert small.double(0) == 0, "double of zero is zero"
"""
RIGHT = """
def double(x):
    return x + x


def quadruple(x):
    return 4 * x
"""


def make_root(folder: Path, manifest: str = MANIFEST) -> Path:
    """Create the repository, including its reference, in a new folder."""
    for name, text in (
        ("chapters/ch90_small/chapter.toml", manifest),
        ("solutions/ch90_small/small.py", RIGHT),
        ("tests/ch90_small/test_small.py", CHECKS),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    for name in ("pyproject.toml", "tests/conftest.py"):
        shutil.copyfile(ROOT / name, folder / name)
    return folder


def make_students_root(folder: Path) -> Path:
    """Create the part of the repository that students have: the stub, the checks and the tools."""
    make_root(folder)
    shutil.rmtree(folder / "solutions")
    (folder / "chapters/ch90_small/small.py").write_text(STUB, encoding="utf-8")
    for file in student_tools():
        if file.is_relative_to(ROOT / "autograder"):
            copy = folder / file.relative_to(ROOT)
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(file, copy)
    return folder


def hand_in(folder: Path, student: str, code: str) -> None:
    (folder / student / "ch90_small").mkdir(parents=True)
    (folder / student / "ch90_small/small.py").write_text(code, encoding="utf-8")
