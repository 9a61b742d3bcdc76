"""What a student sees: python -m autograder check and hint."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters, select_chapters

SAMPLES = "sample_class"


def autograder(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "autograder", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", check=False)


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """The reference's chapter 2 in a folder to be edited."""
    shutil.copytree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
    return tmp_path


def test_the_reference_passes_and_the_exit_status_says_so() -> None:
    done = autograder("check", "--chapter", "2", "--engine", "solutions")
    assert done.returncode == 0
    assert "[########################################] 43 of 43 points" in done.stdout
    assert "Everything that can be checked passes." in done.stdout


def test_every_exercise_is_shown_with_its_state_and_the_first_failure_in_full(engine: Path) -> None:
    vector = engine / "ch02_vectors/vector.py"
    text = vector.read_text(encoding="utf-8").replace("self.x - v.x", "v.x - self.x")
    vector.write_text(text, encoding="utf-8")
    done = autograder("check", "--chapter", "2", "--engine", str(engine))
    assert done.returncode == 1
    for exercise in load_chapters()[0].exercises:
        assert f"\n {exercise.id} " in done.stdout
    assert "First to repair: B2.5 Add and subtract" in done.stdout
    for label in ("called    v, w = Vector3(", "got       (", "wanted    ("):
        assert label in done.stdout
    assert "likely    a new vector: the first minus the second" in done.stdout
    assert "read      book 2.1.4" in done.stdout
    line = text[: text.index("def __sub__")].count("\n") + 1
    assert f"Next: open {vector}:" in done.stdout.replace("\n", "")
    assert f"ch02_vectors/vector.py:{line}" in done.stdout.replace("\n", "")
    assert "make hint EX=B2.5" in done.stdout


def test_one_exercise_is_shown_with_what_it_builds_on() -> None:
    done = autograder("check", "--exercise", "2.1", "--engine", "solutions")
    assert done.returncode == 0
    shown = [line.split()[0] for line in done.stdout.splitlines() if line.startswith((" B", " 2"))]
    assert shown == ["B2.1", "B2.2", "B2.4", "2.1"]


def test_a_written_exercise_is_shown_as_such() -> None:
    for engine, state in (("chapters", "to answer"), ("solutions", "answered")):
        done = autograder("check", "--exercise", "2.3", "--engine", engine)
        assert done.returncode == 0
        assert f"2.3   A vector times itself   *       {state}" in done.stdout


def test_a_console_that_lacks_a_character_is_no_crash() -> None:
    environment = os.environ | {"PYTHONIOENCODING": "ascii"}
    command = [sys.executable, "-m", "autograder", "check", "--engine", f"{SAMPLES}/dina"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, check=False)
    assert done.returncode == 1
    assert b"Traceback" not in done.stderr


def test_a_syntax_error_is_named_with_its_line() -> None:
    done = autograder("check", "--engine", f"{SAMPLES}/dina")
    assert done.returncode == 1
    assert "vector.py cannot be read: '(' was never closed" in done.stdout
    assert "vector.py, line 11: return math.sqrt((" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["check", "--chapter", "77"], "there is no chapter 77 here; there is 2"),
        (["check", "--chapter", "two"], "chapters must look like 2 or 2,4-6, got 'two'"),
        (["check", "--exercise", "2.99"], "there is no exercise '2.99'; there is B2.1"),
        (["check", "--engine", "nowhere"], "engine must be a folder of chapters, got 'nowhere'"),
        (["hint", "2.99"], "there is no exercise '2.99'"),
        (["grade", "nowhere", "--out", "build/x"], "nowhere"),
        (["grade", "studies", "--out", "build/x", "--chapters", "1"], "there is no chapter 1"),
    ],
)
def test_a_mistake_on_the_command_line_is_one_clear_sentence(
    arguments: list[str], complaint: str
) -> None:
    done = autograder(*arguments)
    assert done.returncode == 2
    assert complaint in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1


def test_hints_come_one_at_a_time() -> None:
    hints = load_chapters()[0].exercise("B2.9").hints
    first, second, all_of_them = (autograder("hint", "B2.9", "--count", n).stdout for n in "129")
    assert hints[0] in first
    assert hints[1] not in first
    assert "make hint EX=B2.9 N=2" in first
    assert hints[1] in second
    assert all(hint in all_of_them for hint in hints)
    assert "more" not in all_of_them.splitlines()[-1]


def test_chapters_are_selected_by_number_and_range() -> None:
    assert [chapter.number for chapter in select_chapters("2")] == [2]
    assert select_chapters("") == load_chapters()
    with pytest.raises(ValueError, match="there is no chapter 1 here"):
        select_chapters("1-2")
