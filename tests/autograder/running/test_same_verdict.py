"""What passes at home passes in grading: the same code has the same verdict, in the same words.

Beside the checks, as students run them, and behind the walls, as a class is graded.
"""

from __future__ import annotations

import importlib.metadata
import re
import sys
import textwrap
import tomllib
from functools import partial
from pathlib import Path

import pytest

from autograder.checks.runner import Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, load_chapter
from copies import copy_tree, edit
from small import RIGHT, hand_in, make_root
from typed import typed
from walls import behind_walls

# What lies here besides the packages, and what a student may keep beside the code.
OURS = "autograder autograder.student.screen autograder.isolation.student_side studies plots.draw"
OURS += " tests chapters solutions expect draw lever conftest sitecustomize nowhere"
NOT_GRADED = ("ch90_small.helper", "ch90_small.test_small")

ATTEMPTS = tomllib.loads(Path(__file__).with_name("attempts.toml").read_text(encoding="utf-8"))
MODULE = """
import os

HERE = os.path.dirname(__file__)
COUNT = 0
print("imported")


def double(x):
    return x + x


def quadruple(x):
    return 4 * x


def try_(name):
    try:
        return repr(globals()["try_" + name]())
    except BaseException as error:
        return f"{type(error).__name__}: {error}"


def imports(names):
    odd = []
    for name in names:
        for code in (f"import {name}", f"__import__('importlib').import_module({name!r})"):
            try:
                exec(code, globals())
                odd.append((code, "imported"))
            except ModuleNotFoundError as error:
                wanted = name if name.startswith("ch90") else name.partition(".")[0]
                if str(error) != f"No module named {wanted!r}" or error.name != wanted:
                    odd.append((code, str(error)))
    return odd
"""


def installed() -> list[str]:
    """Every package and module of .venv that Python's own library does not have."""
    names = {name for name in importlib.metadata.packages_distributions() if name.isidentifier()}
    return [*sorted({*names, *OURS.split()} - sys.stdlib_module_names), *NOT_GRADED]


def both_ways(root: Path, code: str) -> tuple[dict[str, Verdict], dict[str, Verdict]]:
    """Return the verdicts beside the checks, and behind walls on what a grader takes."""
    chapter = load_chapter(root / "chapters/ch90_small")
    home, graded = root / "home", root / "graded"
    for engine in (home, graded):
        hand_in(root, engine.name, code)
        (engine / "ch90_small/drops.csv").write_text("1,2", encoding="utf-8")
    (home / "ch90_small/helper.py").write_text("x = 1\n", encoding="utf-8")
    (home / "ch90_small/data").mkdir()
    for name in ("ch90_small/notes.txt", "ch90_small/data/more.txt", "notes.txt"):
        (home / name).write_text("mine\n", encoding="utf-8")
    run = partial(run_checks, chapter, seed="1", root=root, limits=Limits(30.0))
    beside, behind = run([home]), run([graded], sandbox=behind_walls())
    return {v.name: v for v in beside}, {v.name: v for v in behind}


def told(verdict: Verdict) -> tuple[str, str]:
    return verdict.status, str(verdict.message)


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small chapter with a check for each attempt, which fails with what came of it."""
    root = make_root(tmp_path_factory.mktemp("same"))
    manifest = root / "chapters/ch90_small/chapter.toml"
    edit(manifest, 'edit = ["small.double"]', 'files = ["drops.csv"]\nedit = ["small.double"]')
    checks = ["import pytest", "from ch90_small.small import imports, try_"]
    for name, attempt in ATTEMPTS.items():
        exercise = "90.1" if attempt.get("again") else "B90.1"
        checks += [f"@pytest.mark.exercise('{exercise}')", f"def test_{name}():"]
        checks += [f"    pytest.fail(try_({name!r}))"]
    checks += ["@pytest.mark.exercise('B90.1')", "def test_imports():"]
    checks += [f"    assert imports({installed()!r}) == []"]
    (root / "tests/ch90_small/test_attempts.py").write_text("\n".join(checks), encoding="utf-8")
    return root


@pytest.fixture(scope="module")
def verdicts(root: Path) -> tuple[dict[str, Verdict], dict[str, Verdict]]:
    """What came of every attempt, both ways."""
    if not behind_walls().level["seccomp"]:
        pytest.skip("there are no walls here that refuse all of it")
    code = MODULE
    for name, attempt in ATTEMPTS.items():
        code += f"\n\ndef try_{name}():\n" + textwrap.indent(attempt["code"], "    ") + "\n"
    return both_ways(root, code)


@pytest.mark.parametrize("name", ATTEMPTS)
def test_an_attempt_comes_to_the_same(
    name: str, verdicts: tuple[dict[str, Verdict], dict[str, Verdict]]
) -> None:
    home, graded = (verdicts_of[f"test_{name}"] for verdicts_of in verdicts)
    assert ATTEMPTS[name]["says"] in str(graded.message)
    assert told(home) == told(graded)


def test_every_package_is_refused_in_pythons_own_words(
    verdicts: tuple[dict[str, Verdict], dict[str, Verdict]],
) -> None:
    assert {"numpy", "scipy", "pytest", "rich", "autograder"} <= {*installed()}
    for verdicts_of in verdicts:
        verdict = verdicts_of["test_imports"]
        assert verdict.status == "passed", verdict.message


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("import numpy", "likely .*only Python.s standard library"),
        ("from expect import expect_close", "likely .*only Python.s standard library"),
        ("from ch90_small.helper import x", "No module named 'ch90_small.helper'"),
        ("import ch91_nowhere.thing", "No module named 'ch91_nowhere'"),
        ("open('/tmp/written-by-a-student', 'w')", "likely .*should only compute"),
    ],
)
def test_a_module_that_asks_for_it_is_told_the_same(line: str, words: str, tmp_path: Path) -> None:
    root = make_root(tmp_path)
    home, graded = both_ways(root, f"{line}\n{RIGHT}")
    assert [told(home[name]) for name in home] == [told(graded[name]) for name in graded]
    assert re.search(words, str(home["test_double"].message))


def test_a_plot_and_a_scene_refuse_what_a_check_refuses(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
    edit(tmp_path / "ch02_vectors/vector.py", "import math\n", "import math\nimport numpy\n")
    for arguments in (["plots", "draw", "--chapter", "2"], ["lab", "record", "ball-game"]):
        done = typed(*arguments, "--engine", tmp_path)
        assert "No module named 'numpy' (" in done.stdout
        assert "vector.py, line" in done.stdout
        assert "only Python's standard library" in done.stdout
