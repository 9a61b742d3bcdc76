"""The files in .vscode/ are valid, their commands run, and failures are marked in the file."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from autograder.handouts.handout import make_handout
from autograder.manifest import ROOT, load_chapters
from typed import typed

FOLDER = ROOT / ".vscode"
SCHEMAS = json.loads(Path(__file__).with_name("editors.schema.json").read_text(encoding="utf-8"))
VECTOR = "chapters/ch02_vectors/vector.py"


def read(name: str) -> Any:
    return json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))


TASKS = {task["label"]: task for task in read("tasks")["tasks"]}
LAUNCHES = {entry["name"]: entry for entry in read("launch")["configurations"]}


@pytest.mark.parametrize("name", SCHEMAS)
def test_a_file_is_valid_and_handed_out(name: str, student: Path) -> None:
    jsonschema.validate(read(name), SCHEMAS[name])
    assert (student / f".vscode/{name}.json").is_file()
    used = {*re.findall(r"\$\{input:(\w+)\}", json.dumps(read(name)))}
    assert used == {each["id"] for each in read(name).get("inputs", [])}


def run(words: list[str], cwd: Path) -> subprocess.CompletedProcess[str]:
    """Run a command as the editor does, with this Python and with an answer to its question."""
    answered = [word.replace("${input:exercise}", "B2.9") for word in words]
    assert answered.pop(0) == "-m"
    return typed(*answered, cwd=cwd, text="q\n")


@pytest.fixture(scope="module")
def student(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Returns a handout, in which the second component of cross has a wrong sign."""
    folder = tmp_path_factory.mktemp("student") / "course"
    make_handout(load_chapters()[:1], [], folder)
    text = (ROOT / "solutions/ch02_vectors/vector.py").read_text(encoding="utf-8")
    right = "self.z * v.x - self.x * v.z"
    assert text.count(right) == 1
    (folder / VECTOR).write_text(text.replace(right, right.replace("-", "+")), encoding="utf-8")
    return folder


@pytest.mark.parametrize("label", [label for label in TASKS if label not in ("set up", "watch")])
def test_a_task_runs(label: str, student: Path) -> None:
    """Watch never ends, and setting up installs packages. Both have their own tests."""
    assert run(TASKS[label]["args"], student).returncode in (0, 1)


def test_the_failing_line_is_marked_in_its_file(student: Path) -> None:
    """The patterns match consecutive lines, as VS Code requires."""
    task = TASKS["check an exercise"]
    first, second = (re.compile(p["regexp"]) for p in task["problemMatcher"]["pattern"])
    lines = run(task["args"], student).stdout.splitlines()
    (here,) = [i for i, line in enumerate(lines) if first.fullmatch(line)]
    place, hint = first.fullmatch(lines[here]), second.fullmatch(lines[here + 1])
    assert place
    assert hint
    source = (student / place[1]).read_text(encoding="utf-8").splitlines()
    assert source[int(place[2]) - 1].strip().startswith("def cross(")
    assert TASKS["check everything"]["problemMatcher"] == task["problemMatcher"]


def test_the_debugger_s_entry_stops_in_the_function(student: Path) -> None:
    entry = LAUNCHES["The failing check"]
    done = run(["-m", entry["module"], *entry["args"]], student)
    assert "vector.py(" in done.stdout
    assert ")cross()" in done.stdout


def test_completion_finds_the_students_engine(student: Path) -> None:
    settings = read("settings")
    (extra,) = settings["python.analysis.extraPaths"]
    assert (student / extra / "ch02_vectors/vector.py").is_file()
    assert settings["python.defaultInterpreterPath"] == "${workspaceFolder}/.venv"
