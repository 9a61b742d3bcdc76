"""The same code has the same verdict in the same words, at home and behind the walls of grading."""

from __future__ import annotations

import importlib.metadata
import re
import shutil
import sys
import textwrap
import tomllib
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from autograder.answers import questions_of
from autograder.checks.runner import Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, load_chapter, load_chapters
from autograder.message import Kind, Message
from autograder.submissions.stage import stage
from copies import copy_tree, edit
from small import RIGHT, hand_in, make_root
from typed import typed
from walls import behind_walls

# What lies here besides the packages, and what a student may keep beside the code.
OURS = "autograder autograder.student.screen autograder.isolation.student_side studies plots.draw"
OURS += " tests chapters solutions expect draw lever conftest sitecustomize nowhere"
NOT_GRADED = ("ch90_small.helper", "ch90_small.test_small")

BothWays = tuple[dict[str, Verdict], dict[str, Verdict]]
ROWS = tomllib.loads(Path(__file__).with_name("attempts.toml").read_text(encoding="utf-8"))
ATTEMPTS = ROWS["attempts"] | ROWS["again"]
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


def both_ways(root: Path, code: str) -> BothWays:
    """Return the verdicts beside the checks, and behind walls on what a grader takes."""
    chapter = load_chapter(root / "chapters/ch90_small")
    home, graded = root / "home", root / "graded"
    for engine in (home, graded):
        hand_in(root, engine.name, code)
        (engine / "ch90_small/drops.csv").write_text("1,2", encoding="utf-8")
        for file in (root / "chapters/ch90_small").glob("*.py"):
            shutil.copy(file, engine / "ch90_small")
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
def with_attempts(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small chapter with a check for each attempt, which fails with what came of it."""
    root = make_root(tmp_path_factory.mktemp("same"))
    manifest = root / "chapters/ch90_small/chapter.toml"
    edit(manifest, 'edit = ["small.double"]', 'files = ["drops.csv"]\nedit = ["small.double"]')
    checks = ["import pytest", "from ch90_small.small import imports, try_"]
    for name in ATTEMPTS:
        exercise = "90.1" if name in ROWS["again"] else "B90.1"
        checks += [f"@pytest.mark.exercise('{exercise}')", f"def test_{name}():"]
        checks += [f"    pytest.fail(try_({name!r}))"]
    checks += ["@pytest.mark.exercise('B90.1')", "def test_imports():"]
    checks += [f"    assert imports({installed()!r}) == []"]
    (root / "tests/ch90_small/test_attempts.py").write_text("\n".join(checks), encoding="utf-8")
    return root


@pytest.fixture(scope="module")
def verdicts(with_attempts: Path) -> BothWays:
    """What came of every attempt, both ways."""
    if not behind_walls().level["seccomp"]:
        pytest.skip("there are no walls here that refuse all of it")
    code = MODULE
    for name, (body, _) in ATTEMPTS.items():
        code += f"\n\ndef try_{name}():\n" + textwrap.indent(body, "    ") + "\n"
    return both_ways(with_attempts, code)


@pytest.mark.parametrize(("name", "says"), [(name, says) for name, (_, says) in ATTEMPTS.items()])
def test_an_attempt_comes_to_the_same(name: str, says: str, verdicts: BothWays) -> None:
    home, graded = (verdicts_of[f"test_{name}"] for verdicts_of in verdicts)
    assert says in str(graded.message)
    assert told(home) == told(graded)


def test_every_package_is_refused_in_pythons_own_words(
    verdicts: BothWays,
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
def test_a_module_that_asks_for_it_is_told_the_same(line: str, words: str, root: Path) -> None:
    home, graded = both_ways(root, f"{line}\n{RIGHT}")
    assert [told(home[name]) for name in home] == [told(graded[name]) for name in graded]
    assert re.search(words, str(home["test_double"].message))


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("def double(x:", "ch90_small/small.py cannot be read: "),
        (RIGHT.replace("return x", "return y"), "given.py cannot be imported: NameError"),
    ],
)
def test_a_complete_module_that_runs_wrong_code_is_explained(
    code: str, words: str, root: Path
) -> None:
    title, imports = 'title = "Small"', "from ch90_small import small"
    edit(root / "chapters/ch90_small/chapter.toml", title, f'{title}\ncomplete = ["given.py"]')
    given = "from ch90_small.small import double\nFOUR = double(2)\n"
    (root / "chapters/ch90_small/given.py").write_text(given, encoding="utf-8")
    checks = root / "tests/ch90_small/test_small.py"
    edit(checks, imports, f"{imports}\nfrom ch90_small.given import FOUR")
    edit(checks, "(0) == 0", "(FOUR()) == 0")
    home, graded = both_ways(root, code)
    assert [told(home[name]) for name in home] == [told(graded[name]) for name in graded]
    assert words in str(home["test_quadruple_of_zero"].message)


def test_a_plot_and_a_scene_refuse_what_a_check_refuses(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
    edit(tmp_path / "ch02_vectors/vector.py", "import math\n", "import math\nimport numpy\n")
    for arguments in (["plots", "draw", "--chapter", "2"], ["lab", "record", "ball-game"]):
        done = typed(*arguments, "--engine", tmp_path)
        assert "No module named 'numpy' (" in done.stdout
        assert "vector.py, line" in done.stdout
        assert "only Python's standard library" in done.stdout


VECTOR = "ch02_vectors/vector.py"
# Each change makes a right file into one that the grader rejects.
CHANGES: dict[str, Callable[[Path], object]] = {
    "latin-1": lambda file: file.write_bytes(
        b"# -*- coding: latin-1 -*-\n# Stra\xdfe\n" + file.read_bytes()
    ),
    "NUL": lambda file: file.write_bytes(file.read_bytes() + b"# \0\n"),
    "large": lambda file: file.write_bytes(file.read_bytes() + b"#\n" * 500_000),
    "link": lambda file: file.symlink_to(file.rename(file.with_name("mine.txt"))),
    "linked folder": lambda file: file.parent.symlink_to(
        file.parent.rename(file.parent.with_name("elsewhere"))
    ),
    "folder": lambda file: file.unlink() or file.mkdir(),
    "renamed": lambda file: file.rename(file.with_stem(f"{file.stem} (1)")),
}
posix = ("link", "linked folder")


def changed(change: str, file: Path) -> None:
    if change in posix and sys.platform == "win32":
        pytest.skip("on Windows only an administrator can make links")
    CHANGES[change](file)


def run_ann(root: Path) -> list[Verdict]:
    (chapter,) = load_chapters(root)
    return run_checks(chapter, [root / "ann"], seed="1", root=root)


@pytest.mark.parametrize("change", CHANGES)
def test_check_rejects_what_the_grader_rejects(change: str, root: Path) -> None:
    hand_in(root, "ann", RIGHT)
    assert {verdict.status for verdict in run_ann(root)} == {"passed"}
    changed(change, root / "ann/ch90_small/small.py")
    staged = stage(root / "ann", load_chapters(root), root / "box", root)
    why = staged.rejected["ch90_small.small"]
    assert why.startswith("ch90_small/small.py was rejected: ")
    for verdict in run_ann(root):
        assert verdict.status in ("failed", "blocked")
        assert verdict.message.title == why


def test_scenes_plots_and_recordings_reject_what_the_grader_rejects(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "ann")
    changed("latin-1", tmp_path / "ann" / VECTOR)
    why = stage(tmp_path / "ann", load_chapters()[:1], tmp_path / "box").rejected[
        "ch02_vectors.vector"
    ]
    load = '{"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}\n'
    for arguments, text in (
        (("plots", "draw", "--chapter", "2", "--out", tmp_path / "plots"), ""),
        (("lab", "record", "ball-game", "--out", tmp_path), ""),
        (("lab.child", "--stack", tmp_path / "stack.txt"), load),
    ):
        assert why in typed(*arguments, "--engine", tmp_path / "ann", text=text).stdout


def test_rejected_answers_are_reported_at_home_in_the_same_words(tmp_path: Path) -> None:
    chapter = load_chapters()[0]
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "class/ann/ch02_vectors")
    with (tmp_path / "class/ann/ch02_vectors/answers.md").open("ab") as file:
        file.write(b"Stra\xdfe\n")
    why = "ch02_vectors/answers.md was rejected: it is not UTF-8: save it as UTF-8 in your editor"
    questions = questions_of(chapter, [tmp_path / "class/ann"])
    assert questions
    for question in questions:
        assert question.problems == [why]
        assert not question.answered


@pytest.mark.parametrize("change", ["latin-1", "renamed"])
def test_rejected_data_have_the_same_verdict_and_reason_at_home(change: str, root: Path) -> None:
    manifest, own = root / "chapters/ch90_small/chapter.toml", 'edit = ["small.double"]'
    edit(manifest, own, f'{own}\nfiles = ["data.csv"]')
    code = RIGHT + "\nfrom pathlib import Path\nFILE = Path(__file__).with_name('data.csv')\n"
    code = code.replace("return x + x", "return 2 * x * float(FILE.read_text())")
    shutil.rmtree(root / "solutions")
    for name in ("ann", "solutions"):
        hand_in(root, name, code)
        (root / name / "ch90_small/data.csv").write_text("1\n", encoding="utf-8")
    assert {verdict.status for verdict in run_ann(root)} == {"passed"}
    changed(change, root / "ann/ch90_small/data.csv")
    (chapter,) = load_chapters(root)
    staged = stage(root / "ann", [chapter], root / "box", root)
    why = staged.rejected["ch90_small.data.csv"]
    missing = {"ch90_small.data.csv": Message(why, kind=Kind.BROKEN)}
    behind = replace(behind_walls(), missing=missing)
    graded = run_checks(chapter, [root / "box"], seed="1", root=root, sandbox=behind)
    home = run_ann(root)
    told, in_grading = ([(v.status, str(v.message)) for v in of] for of in (home, graded))
    assert told == in_grading
    assert home[0].status == "failed"
    assert home[0].message.likely == why
