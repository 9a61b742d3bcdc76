"""The map in CONTRIBUTING.md has every folder, and its list of texts suffices for an exercise."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from graded import points_of

PAGE = (ROOT / "docs/CONTRIBUTING.md").read_text(encoding="utf-8")
MAP = PAGE.partition("\n## A map of the folders\n")[2].partition("\n## ")[0]
ADDING = PAGE.partition("\n## Adding an exercise\n")[2].partition("\n## ")[0]
COMMANDS = re.findall(r"(?m)^make [^#\n]+", ADDING)
TABLE = re.compile(r"(?s)(?<=writes this -->).*?(?=<!-- end of)")

SOLUTION = '''
def halfway(a: Vector3, b: Vector3) -> Vector3:
    """Exercise G2.1: return the point halfway between a and b, as a new vector.

    >>> halfway(Vector3(1, 2, 3), Vector3(3, 2, 0))
    Vector3(2.0, 2.0, 1.5)
    """
    return (a + b) * 0.5
'''
SECOND = '''
def halfway(a: Vector3, b: Vector3) -> Vector3:
    """Go half of the way from a to b."""
    return a + (b - a) / 2
'''
POINTS = 7
ENTRY = f"""
[[exercise]]
id = "G2.1"
title = "The point halfway"
kind = "exercise"
stars = 1
points = {POINTS}
edit = ["exercises.halfway"]
needs = ["B2.3", "B2.5"]
hints = ["What is the mean of two numbers?", "Add a and b, and multiply the sum by 0.5."]
terms = ["vector"]
"""
CHECKS = '''"""Exercise G2.1."""

from __future__ import annotations

from random import Random

import pytest

from calls import calls
from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import vector
from expect import expect_close


@pytest.mark.exercise("G2.1", read="the docstring of halfway")
def test_halfway_is_the_mean_of_both_points(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls("The mean of two numbers is half their sum, and this holds for each component."):
        got = exercises.halfway(Vector3(*a), Vector3(*b))
    expect_close(got, (a + b) / 2.0, {"This is the sum.": a + b})
'''
WRONG = """
["exercises.halfway".test_halfway_is_the_mean_of_both_points]
"the sum is not halved" = {says = "This is the sum.", body = "return a + b"}
"half of the difference" = ["a + b", "b - a"]
"only b is halved" = ["(a + b)", "a + b"]
"""
TURN = """
**Your turn** (5 minutes): exercise G2.1, `halfway`.

```sh
make check EX=G2.1
```
"""
TEXTS = {  # the texts that are written by hand, keyed by the file that the page names
    "solutions/chNN_name/module.py": SOLUTION,
    "sample_class/ada/chNN_name/module.py": SECOND,
    "chapters/chNN_name/chapter.toml": ENTRY,
    "tests/chNN_name/test_module.py": CHECKS,
    "tests/chNN_name/wrong.toml": WRONG,
    "chapters/chNN_name/README.md": TURN,
}
# Eight tests of the project that the texts and the generated files must pass. The points of both
# solutions are what the page's commands show: `make check`, and the sample class in `make update`.
PROOFS = "halfway or G2.1 or lock_has_the_hash or (ch02 and (has_its_turn or hints or three_wrong))"
FILES = ["lessons/test_lessons.py", *(f"project/test_{n}.py" for n in ("structure", "stubs"))]
FILES += ["project/test_strength.py", "project/test_proofs.py"]


def test_the_map_has_every_folder_and_no_other() -> None:
    named = re.findall(r"`([^` ]+/)`", "".join(re.findall(r"(?m)^\| (.+?) \|", MAP)))
    there = {".ci/", ".github/", "tests/chNN_name/"}
    for folder in (path for glob in ("*", "autograder/*", "tests/*") for path in ROOT.glob(glob)):
        if folder.is_dir() and not re.match(r"[._]|build|ch\d\d_", folder.name):
            there.add(f"{folder.relative_to(ROOT).as_posix()}/")
    assert sorted(named) == sorted(there)


def write_exercise(root: Path) -> None:
    """Copy the repository with only chapter 2, and add an exercise by hand."""
    others = [chapter.name for chapter in load_chapters()[1:]]
    unneeded = shutil.ignore_patterns(".?*", "build", "__pycache__", "hostile", *others)
    shutil.copytree(ROOT, root, ignore=unneeded)
    (root / ".venv").symlink_to(sys.prefix, target_is_directory=True)
    named = re.findall(r"(?m)^\| [^`|]+ \| `([^`]+)` \| ", ADDING)
    assert sorted(named) == sorted(TEXTS)
    for name, text in TEXTS.items():
        name = name.replace("test_module", "test_halfway").replace("module", "exercises")
        with (root / name.replace("chNN_name", "ch02_vectors")).open("a", encoding="utf-8") as file:
            file.write(text)


def run(root: Path, *command: str) -> str:
    done = subprocess.run(command, cwd=root, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")
def test_an_exercise_takes_what_the_page_lists_and_no_more(tmp_path: Path) -> None:
    """Run the commands of the page. Make only plans those that take minutes."""
    root, screens = tmp_path / "companion", {}
    write_exercise(root)
    for command in dict.fromkeys(COMMANDS):
        _, name, *variables = command.split()
        plan = ["--dry-run"] if name in ("test", "measure") else []
        screens[name] = run(root, "make", "--old-file=.venv/ready", *plan, name, *variables)
    assert screens.keys() == {"update", "check", "test", "measure"}
    assert "generated chapters/ch02_vectors/exercises.py\n" in screens["update"]
    total = points_of(load_chapters()[0]) + POINTS
    assert f"] {total} of {total} points" in screens["check"]
    pages = {
        "chapters/ch02_vectors/exercises.py": '("Exercise G2.1: The point halfway")',
        "chapters/ch02_vectors/reference.md": f"| The point halfway | exercise | \\* | {POINTS} |",
        "sample_class/README.md": f" {total}/{total} ",
    }
    for path, words in pages.items():
        assert words in (root / path).read_text(encoding="utf-8")
    for page in ("tests/README.md", "sample_class/README.md"):
        old, new = ((top / page).read_text(encoding="utf-8") for top in (ROOT, root))
        assert old != new
        assert TABLE.sub("", old) == TABLE.sub("", new), "make update replaces the table alone"
    command = (sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", PROOFS)
    assert "\n8 passed, " in run(root, *command, *(f"tests/{file}" for file in FILES))
