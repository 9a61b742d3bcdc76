"""The stubs match solutions/, contain no answers, and never overwrite anybody's work."""

from __future__ import annotations

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.definitions import functions
from autograder.handouts.stubs import (
    LOCK_NAME,
    complete_hashes,
    make_stubs,
    read_lock,
    stale_stubs,
    stub_hash,
    stub_module,
    write_stubs,
)
from autograder.handouts.tables import with_table
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.options import makefile
from copies import copy_tree
from made import made_stubs
from typed import typed

SOURCE = '''\
"""A module."""

import math
import random
from os.path import (
    basename,
    join,
)
from typing import Protocol

LIMIT = 3.0
SIDES = 4.0
# A constant that only the answer uses.
_SECRET = 4.0


class Ball:
    """A ball."""

    def __init__(self) -> None:
        self.radius = LIMIT

    def volume(self) -> float:
        """Return the volume."""
        return _cube(self.radius) * math.pi * _SECRET / SIDES

    @property
    def diameter(self) -> float:
        """The diameter."""
        return 2.0 * self.radius

    @diameter.setter
    def diameter(self, diameter: float) -> None:
        """Set the diameter."""
        self.radius = diameter / 2.0


def throw() -> str:
    return basename(str(random.random()))


class Solid(Protocol):
    """Has a method whose name appears twice, and which only the answer calls."""

    def weight(self) -> float:
        """Return the weight."""


class Cube:
    """A cube, which is given."""

    def weight(self) -> float:
        return 1.0


def _cube(x: float) -> float:
    """Return x^3."""
    join("a", "b").weight()
    return x * x * x
'''


def test_the_lock_has_the_hash_of_every_stub() -> None:
    stubs = {path: stub_hash(text) for path, text in make_stubs().items()}
    assert read_lock() == stubs | complete_hashes()


IMPORT_ALL = """
import runpy, sys
for file in sys.argv[1:]:
    runpy.run_path(file)
"""


def test_every_stub_can_be_imported(tmp_path: Path) -> None:
    files = []
    for path, text in made_stubs().items():
        if path.endswith(".py"):
            files.append(tmp_path / path)
            files[-1].parent.mkdir(parents=True, exist_ok=True)
            files[-1].write_text(text, encoding="utf-8")
    engine = os.pathsep.join([str(ROOT / "solutions"), str(ROOT / "chapters")])
    command = [sys.executable, "-c", IMPORT_ALL, *map(str, files)]
    subprocess.run(command, env={"PYTHONPATH": engine}, check=True)


def test_every_stub_is_as_tidy_as_ruff_would_make_it(tmp_path: Path) -> None:
    """The stubs are made without it, so that students need no linter for make reset."""
    for path, text in made_stubs().items():
        if path.endswith(".py"):
            (tmp_path / path.replace("/", "_")).write_text(text, encoding="utf-8")
    options = ["--isolated", "--line-length", "100", "--target-version", "py311"]
    src = f"src = ['{ROOT / 'solutions'}', '{ROOT / 'chapters'}']"
    unused = ["check", "--select", "F401,F841,I", "--config", src, *options]
    for command in (unused, ["format", "--check", *options]):
        done = typed("ruff", *command, tmp_path)
        assert done.returncode == 0, done.stdout


LONG = """\
import os
import sys

from a_module_of_a_long_name import (
    the_first_name_that_is_long,
    the_second_name_that_is_long,
    the_third_name_that_is_long,
    the_fourth_name,
)
_SECRET = 1
_OPEN = os.sep


def f() -> None:
    return sys.argv, _SECRET, the_fourth_name


def g() -> None:
    return the_first_name_that_is_long, the_second_name_that_is_long, the_third_name_that_is_long
"""


def test_imports_that_stay_in_a_stub_keep_their_lines_if_they_fill_more_than_one() -> None:
    stub = stub_module(LONG, {"f": "Exercise 1: F"})
    assert stub.startswith(
        """\
import os

from a_module_of_a_long_name import (
    the_first_name_that_is_long,
    the_second_name_that_is_long,
    the_third_name_that_is_long,
)
_OPEN = os.sep
"""
    )


def test_a_stub_holds_no_answer() -> None:
    chapters = {chapter.name: chapter for chapter in load_chapters()}
    for path, text in made_stubs().items():
        _, chapter, file = path.split("/")
        if file.endswith(".csv"):
            assert text.count("\n") == 1  # the columns, and no data
        elif file.endswith(".py"):
            _holds_no_answer(chapters[chapter], file.removesuffix(".py"), text)
        else:
            assert "_Write your answer here._" in text


def _holds_no_answer(chapter: Chapter, module: str, text: str) -> None:
    defined = functions(ast.parse(text))
    for exercise in chapter.exercises:
        for name in exercise.edit:
            if name.startswith(f"{module}."):
                docstring, *rest = defined[name.removeprefix(f"{module}.")].body
                assert ast.unparse(docstring).startswith(("'", '"')), f"{name} has no docstring"
                wanted = f"raise NotImplementedError('Exercise {exercise.id}: {exercise.title}')"
                assert [ast.unparse(node) for node in rest] == [wanted]


def test_bodies_helpers_imports_and_constants_of_the_answer_go_and_the_rest_stays() -> None:
    assert (
        stub_module(SOURCE, {"Ball.volume": "Exercise 1: Volume", "Ball.diameter.setter": "2"})
        == '''\
"""A module."""

import random
from os.path import basename
from typing import Protocol

LIMIT = 3.0
SIDES = 4.0


class Ball:
    """A ball."""

    def __init__(self) -> None:
        self.radius = LIMIT

    def volume(self) -> float:
        """Return the volume."""
        raise NotImplementedError("Exercise 1: Volume")

    @property
    def diameter(self) -> float:
        """The diameter."""
        return 2.0 * self.radius

    @diameter.setter
    def diameter(self, diameter: float) -> None:
        """Set the diameter."""
        raise NotImplementedError("2")


def throw() -> str:
    return basename(str(random.random()))


class Solid(Protocol):
    """Has a method whose name appears twice, and which only the answer calls."""

    def weight(self) -> float:
        """Return the weight."""


class Cube:
    """A cube, which is given."""

    def weight(self) -> float:
        return 1.0
'''
    )


def test_a_name_that_the_solution_does_not_have_is_an_error() -> None:
    with pytest.raises(ValueError, match=r"does not define Ball\.mass"):
        stub_module(SOURCE, {"Ball.mass": "Exercise 1: Mass"})


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """Return a copy of the files that make update reads and writes."""
    for folder in ("chapters", "solutions"):
        copy_tree(ROOT / folder, tmp_path / folder)
    (tmp_path / LOCK_NAME).parent.mkdir(parents=True)
    shutil.copyfile(ROOT / LOCK_NAME, tmp_path / LOCK_NAME)
    for path, text in made_stubs().items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    return tmp_path


def test_an_edited_stub_is_never_overwritten(copy: Path) -> None:
    edited, path = "x = 1\n", "chapters/ch02_vectors/vector.py"
    (copy / path).write_text(edited, encoding="utf-8")
    solution = copy / "solutions/ch02_vectors/exercises.py"
    text = solution.read_text(encoding="utf-8").replace("book's chapter 2", "chapter")
    solution.write_text(text, encoding="utf-8")
    assert write_stubs(copy) == (["chapters/ch02_vectors/exercises.py"], [path])
    assert (copy / path).read_text(encoding="utf-8") == edited
    assert write_stubs(copy) == ([], [path]), "the second time it must still count as edited"


def test_a_stub_out_of_step_or_missing_is_named(copy: Path) -> None:
    assert stale_stubs(copy) == []
    (copy / "chapters/ch02_vectors/vector.py").unlink()
    assert stale_stubs(copy) == ["chapters/ch02_vectors/vector.py"]
    assert write_stubs(copy) == (["chapters/ch02_vectors/vector.py"], [])


def test_the_exercise_tables_are_what_the_manifests_say() -> None:
    for chapter in load_chapters():
        page = (ROOT / "chapters" / chapter.name / "reference.md").read_text(encoding="utf-8")
        assert with_table(page, chapter) == page


@pytest.mark.parametrize("table", ["commands", "instructor"])
def test_the_makefiles_are_what_the_tables_of_commands_say(table: str) -> None:
    text = (ROOT / "autograder" / f"{table}.mk").read_text(encoding="utf-8")
    assert text == makefile(table), "make update writes it again"
