"""make lists students' commands first, refuses unknown variables, and fails only for trouble."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from copies import copy_tree
from printed import MAKEFILES, TAKES

STUDENTS = ["watch", "check", "debug", "python", "hint", "reset", "lab", "plot", "setup"]
pytestmark = pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")


def make(*arguments: str, folder: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """Run make without setting up .venv."""
    command = ["make", "--no-print-directory", "--old-file=.venv/ready", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)


def listed(screen: str) -> list[str]:
    return re.findall(r"(?m)^  make (\w+)  ", screen)


def test_help_lists_the_students_commands_and_help_all_every_command() -> None:
    first, everything = make(), make("help-all")
    assert first.returncode == 0, first.stderr
    assert listed(first.stdout) == STUDENTS
    assert "make help-all" in first.stdout
    assert listed(everything.stdout)[: len(STUDENTS)] == STUDENTS
    assert {*listed(everything.stdout)} == {name for name in TAKES if "-" not in name} - {"help"}
    assert max(map(len, everything.stdout.splitlines())) <= 80


def test_a_hand_out_has_the_students_commands_alone(tmp_path: Path) -> None:
    (tmp_path / "autograder").mkdir()
    for name in ("Makefile", "autograder/commands.mk"):
        shutil.copyfile(ROOT / name, tmp_path / name)
    for arguments in ((), ("help-all",)):
        done = make(*arguments, folder=tmp_path)
        assert listed(done.stdout) == STUDENTS
        assert "instructors" not in done.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("plot EX=2.5", ["make plot does not take EX", "CH", "GIVEN"]),
        ("demo DEMO=spin", ["make demo is gone: run make lab SCENE=spin, which"]),
        ("hint EX=2.5 CHAPTER=2", ["make hint does not take CHAPTER", "EX"]),
        ("grade CH=2", ["make grade does not take CH;", "CHAPTERS"]),
        ("chekc CH=2", ['there is no command "make chekc"', "check"]),
        ("check 2.5", ['there is no command "make 2.5"']),
    ],
)
def test_what_a_command_does_not_know_is_an_error_that_names_what_it_takes(
    arguments: str, words: list[str]
) -> None:
    done = make("--dry-run", *arguments.split())
    assert done.returncode == 2
    assert done.stdout == ""
    for word in words:
        assert word in done.stderr


def test_a_scene_takes_several_settings_beside_another_command() -> None:
    done = make("--dry-run", "check", "lab", "EX=2.5", "SCENE=cloth", "SET=rate=240 mass=2")
    assert "--set 'rate=240' --set 'mass=2'" in done.stdout


# All that the shell or make would replace or divide.
ODD = """it's "late", costs $5; `echo x` $(shell echo y) $HOME $$ \\ # 100 % & d $("""
TAKERS = [
    *("watch CH", "reset EX", "plot GIVEN", "lab SCENE", "grade NOTE", "grade SUBMISSIONS"),
    *("grade OUT", "release GRADES", "similarity ROSTER", "mark SUBMISSIONS", "handout CHAPTERS"),
    *("classroom COURSE", "gradescope ASSIGNMENT", "site OUT", "choose SCENE"),
]


@pytest.fixture(scope="module")
def echoing(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the commands, in which Python only prints its arguments as JSON."""
    folder = tmp_path_factory.mktemp("echoing")
    (folder / "autograder").mkdir()
    for name in MAKEFILES:
        shutil.copyfile(ROOT / name, folder / name)
    python = folder / ".venv/bin/python"
    python.parent.mkdir(parents=True)
    code = "import json, sys; print(json.dumps(sys.argv[1:]))"
    python.write_text(f"#!/bin/sh\nexec {sys.executable} -c '{code}' \"$@\"\n", encoding="utf-8")
    python.chmod(0o755)
    return folder


@pytest.mark.parametrize("taker", TAKERS)
def test_commands_get_values_exactly_as_they_were_typed(taker: str, echoing: Path) -> None:
    command, name = taker.split()
    needed = {"release": "CHAPTERS=2 GRADES=a", "similarity": "SUBMISSIONS=a"}
    needed |= dict.fromkeys(("handout", "classroom", "gradescope"), "ASSIGNMENT=lab1")
    installed = [f"--old-file=.venv/{group}" for group in ("teaching", "pictures", "everything")]
    done = make(
        command, *needed.get(command, "").split(), *installed, f"{name}={ODD}", folder=echoing
    )
    words = [word for line in done.stdout.splitlines() for word in json.loads(line)]
    assert ODD in words, done.stderr
    assert name != "ASSIGNMENT" or f"build/{ODD}/gradescope.zip" in words


def test_a_value_of_several_lines_is_refused() -> None:
    done = make("--dry-run", "grade", "NOTE=late\nbut right")
    assert "NOTE must be on one line" in done.stderr
    assert done.returncode == 2


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """Return the reference's chapter 2, with one body not written yet."""
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
    vector = tmp_path / "ch02_vectors/vector.py"
    source = vector.read_text(encoding="utf-8")
    unwritten = 'raise NotImplementedError("Exercise B2.2: Length")\n        return math.hypot('
    vector.write_text(source.replace("return math.hypot(", unwritten), encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("command", ["check EX=B2.2", "plot CH=2"])
def test_a_diagnosis_is_no_error_of_makes(command: str, engine: Path) -> None:
    done = make(*command.split(), f"ENGINE={engine}")
    assert "not written yet: Exercise B2.2" in done.stdout
    assert "***" not in done.stderr
    assert done.returncode == 0


def test_trouble_is_an_error() -> None:
    done = make("check", "CH=77")
    assert "there is no chapter 77" in done.stderr
    assert done.returncode != 0
