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
from autograder.manifest import ROOT, load_chapters
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

from a_module_of_a_long_name import (
    the_first_name_that_is_long,
    the_second_name_that_is_long,
    the_third_name_that_is_long,
    the_fourth_name,
)

LIMIT = 3.0
# A constant that only the answer uses.
_SECRET = 4.0


class Ball:
    """A ball."""

    def __init__(self) -> None:
        self.radius = LIMIT

    def volume(self) -> float:
        """Return the volume."""
        return _cube(self.radius) * math.pi * _SECRET / the_fourth_name

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


class Solid:
    """Has a method whose name appears twice, and which only the answer calls."""

    def weight(self) -> float:
        return the_first_name_that_is_long, the_second_name_that_is_long


class Cube:
    def weight(self) -> float:
        return the_third_name_that_is_long


def _cube(x: float) -> float:
    """Return x^3."""
    join("a", "b").weight()
    return x * x * x
'''
# What the stub of the two exercises lacks, or has in another form.
CHANGES = {
    "import math\n": "",
    "(\n    basename,\n    join,\n)": "basename",
    "    the_fourth_name,\n": "",
    "# A constant that only the answer uses.\n_SECRET = 4.0\n": "",
    "return _cube(self.radius) * math.pi * _SECRET / the_fourth_name": (
        'raise NotImplementedError("Exercise 1: Volume")'
    ),
    "self.radius = diameter / 2.0": 'raise NotImplementedError("2")',
    SOURCE[SOURCE.index("\n\ndef _cube") :]: "",
}


def test_the_lock_has_the_hash_of_every_stub() -> None:
    stubs = {path: stub_hash(text) for path, text in make_stubs().items()}
    assert read_lock() == stubs | complete_hashes()


def test_every_stub_can_be_imported(tmp_path: Path) -> None:
    files = []
    for path, text in made_stubs().items():
        if path.endswith(".py"):
            files.append(tmp_path / path)
            files[-1].parent.mkdir(parents=True, exist_ok=True)
            files[-1].write_text(text, encoding="utf-8")
    engine = os.pathsep.join([str(ROOT / "solutions"), str(ROOT / "chapters")])
    run_all = "import runpy, sys; [runpy.run_path(file) for file in sys.argv[1:]]"
    command = [sys.executable, "-c", run_all, *map(str, files)]
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


def test_a_stub_holds_no_answer() -> None:
    chapters = {chapter.name: chapter for chapter in load_chapters()}
    for path, text in made_stubs().items():
        _, chapter, file = path.split("/")
        if file.endswith(".csv"):
            assert text.count("\n") == 1  # the columns, and no data
        elif not file.endswith(".py"):
            assert "_Write your answer here._" in text
        else:
            defined = functions(ast.parse(text))
            for exercise in chapters[chapter].exercises:
                wanted = f"raise NotImplementedError('Exercise {exercise.id}: {exercise.title}')"
                for module, _, name in (edit.partition(".") for edit in exercise.edit):
                    if f"{module}.py" == file:
                        assert ast.get_docstring(defined[name])
                        assert [ast.unparse(node) for node in defined[name].body[1:]] == [wanted]


def test_bodies_helpers_imports_and_constants_of_the_answer_go_and_the_rest_stays() -> None:
    stub = SOURCE
    for old, new in CHANGES.items():
        assert stub.count(old) == 1
        stub = stub.replace(old, new)
    edits = {"Ball.volume": "Exercise 1: Volume", "Ball.diameter.setter": "2"}
    assert stub_module(SOURCE, edits) == stub


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
