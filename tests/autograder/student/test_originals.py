"""What a student must not have edited, and what a student is shown first."""

from __future__ import annotations

from pathlib import Path
from subprocess import CompletedProcess

import pytest

from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT
from autograder.scores import result_of
from copies import copy_tree
from graded import exercise_of
from typed import typed

CH02 = "ch02_vectors"


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """The reference's chapter 2, with the complete module that it uses."""
    copy_tree(ROOT / "solutions" / CH02, tmp_path / CH02)
    original = (ROOT / "chapters" / CH02 / "arguments.py").read_bytes()
    (tmp_path / CH02 / "arguments.py").write_bytes(original)
    return tmp_path


def check(engine: Path, *arguments: str) -> CompletedProcess[str]:
    return typed("autograder", "check", "--engine", engine, *arguments)


def test_a_complete_file_that_was_edited_is_named_and_is_no_success(engine: Path) -> None:
    done = check(engine, "--exercise", "B2.1")
    assert done.returncode == 0
    file = engine / CH02 / "arguments.py"
    file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    assert check(engine, "--exercise", "B2.1").returncode == 0, "other line ends are no change"
    with file.open("a", encoding="utf-8") as out:
        out.write("\n\ndef clamp(x):\n    return max(x, 0.0)\n")
    done = check(engine, "--exercise", "B2.1")
    assert done.returncode == 1
    assert "arguments.py. It isn't handed in" in done.stdout


def test_robust_checks_of_what_an_exercise_builds_on_do_not_count_for_it(engine: Path) -> None:
    vector = engine / CH02 / "vector.py"
    text = vector.read_text(encoding="utf-8")
    plain = text.replace("math.hypot(self.x, self.y, self.z)", "math.sqrt(self.dot(self))")
    assert plain != text
    vector.write_text(plain, encoding="utf-8")
    assert check(engine, "--exercise", "B2.2").returncode == 1
    done = check(engine, "--exercise", "2.1")
    assert done.returncode == 0, done.stdout


def test_written_code_that_fails_comes_before_code_that_is_not_written(engine: Path) -> None:
    vector = engine / CH02 / "vector.py"
    text = vector.read_text(encoding="utf-8")
    stub = "raise NotImplementedError('Exercise B2.5: Add and subtract')  # "
    text = text.replace("return Vector3(self.x + v.x", f"{stub}", 1)
    text = text.replace("return Vector3(self.x - v.x", "return Vector3(v.x - self.x", 1)
    vector.write_text(text, encoding="utf-8")
    screen = check(engine, "--exercise", "B2.5").stdout
    assert "half written" not in screen
    assert "not written yet" not in screen.partition("Fix this first")[2]


def test_a_class_with_another_name_is_named_and_not_made_twice(engine: Path) -> None:
    vector = engine / CH02 / "vector.py"
    text = vector.read_text(encoding="utf-8").replace("class Vector3:", "class Vector:")
    vector.write_text(text, encoding="utf-8")
    screen = check(engine, "--exercise", "B2.1").stdout
    assert "vector.py no longer has a class Vector3" in screen
    assert "renamed it to Vector," in screen
    done = typed("autograder", "reset", "B2.1", "--engine", engine)
    assert done.returncode == 2
    assert "no class Vector3, but a class Vector" in done.stderr
    assert vector.read_text(encoding="utf-8") == text


@pytest.mark.parametrize(
    ("physics", "robust", "status"),
    [
        ("inherited", "failed", "inherited"),
        ("blocked", "failed", "blocked"),
        ("passed", "failed", "failed"),
        ("passed", "passed", "passed"),
    ],
)
def test_an_exercise_is_in_the_state_of_its_physics_first(
    physics: str, robust: str, status: str
) -> None:
    exercise = exercise_of("B3.1", "Mass", "build", 5)
    checks = [
        Verdict("a", exercise.id, 1, physics, ""),
        Verdict("b", exercise.id, 1, robust, "", robust=True),
    ]
    assert result_of(exercise, checks).status == status
