"""What a student sees: python -m autograder check and hint."""

from __future__ import annotations

import re
import subprocess
from functools import partial
from pathlib import Path

import pytest

from autograder.__main__ import main
from autograder.diagnosis.explain import explain_exception
from autograder.manifest import ROOT, load_chapters
from copies import copy_tree, edit
from expect import expect_error
from typed import typed

SAMPLES = "sample_class"
autograder = partial(typed, "autograder")
SQUARES = "math.sqrt(self.x**2 + self.y**2 + self.z**2)"
UNWRITTEN = "raise NotImplementedError('Exercise B2.5: Add and subtract')  # "


@pytest.fixture
def vector(tmp_path: Path) -> Path:
    """The module vector.py of the reference's chapter 2, in an engine to be edited."""
    folder = tmp_path / "ch02_vectors"
    copy_tree(ROOT / "solutions/ch02_vectors", folder)
    original = (ROOT / "chapters/ch02_vectors/arguments.py").read_bytes()
    (folder / "arguments.py").write_bytes(original)
    return folder / "vector.py"


def check(vector: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Check chapter 2 of the engine with this module, or one exercise of it."""
    which = ("--exercise", *arguments) if arguments else ("--chapter", "2")
    return autograder("check", "--engine", str(vector.parents[1]), *which)


def test_the_reference_passes_and_the_exit_status_says_so() -> None:
    done = autograder("check", "--chapter", "2", "--engine", "solutions")
    assert done.returncode == 0
    points = sum(e.points for e in load_chapters()[0].exercises if e.kind != "written")
    assert f"[########################################] {points} of {points} points" in done.stdout
    assert "\nAll checks pass.\n" in done.stdout


def test_every_exercise_is_shown_with_its_state_and_the_first_failure_in_full(vector: Path) -> None:
    text = edit(vector, "self.x - v.x", "v.x - self.x")
    done = check(vector)
    assert done.returncode == 1
    for exercise in load_chapters()[0].exercises:
        assert f"\n{exercise.id} " in done.stdout
    rows = [" ".join(line.split()) for line in done.stdout.splitlines()]
    assert "2.3 A vector times itself * answered -/2" in rows
    assert "B2.4 Normalize * passed 3/3 1/1 3/3" in rows
    assert "B2.5 Add and subtract * failed 4/5 2.4/3" in rows
    line = text[: text.index("def __sub__")].count("\n") + 1
    for words in (
        *("Fix this first: B2.5 Add and subtract", "\nwith      v = ", "\ncalled    v - w\n"),
        *("wanted    (", "likely    Vectors are subtracted component by component"),
        *("read      book 2.1.4", f"Next: open {vector}:{line}\n", "make hint EX=B2.5"),
    ):
        assert words in done.stdout


def test_one_exercise_is_shown_with_what_it_builds_on() -> None:
    done = autograder("check", "--exercise", "2.1", "--engine", "solutions")
    assert done.returncode == 0
    shown = [line.split()[0] for line in done.stdout.splitlines() if line.startswith(("B", "2"))]
    assert shown == ["B2.1", "B2.2", "B2.4", "2.1"]


def test_what_is_blocked_is_not_the_first_to_repair_and_half_written_is_no_failure(
    vector: Path,
) -> None:
    half = "raise NotImplementedError('Exercise B2.1')  # "
    edit(vector, "return Vector3(-self.x", half, "if length == 0.0:", "if length is None:")
    done = check(vector)
    rows = [" ".join(line.split()) for line in done.stdout.splitlines()]
    assert "B2.1 Copy, clear and invert * half written 3/4 1.5/2" in rows
    assert "B2.4 Normalize * blocked 2/3 1/1 2.15/3" in rows
    assert "Fix this first: B2.1" in done.stdout
    assert "Fix this first: B2.1" in check(vector, "2.1").stdout


def test_a_syntax_error_is_named_with_its_line_also_in_a_console_that_lacks_a_character() -> None:
    dina = ("check", "--chapter", "2", "--engine", f"{SAMPLES}/dina")
    for environment in ({}, {"PYTHONIOENCODING": "ascii"}):
        done = autograder(*dina, **environment)
        assert done.returncode == 1
        assert "Traceback" not in done.stderr
        assert "vector.py cannot be read: '(' was never closed" in done.stdout
        assert "vector.py, line 11: return math.sqrt((" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ("check --chapter 77", "there is no chapter 77 here, only 2"),
        ("check --chapter two", "chapters must look like 2 or 2,4-6, got 'two'"),
        ("check --exercise 2.99", "there is no exercise '2.99'. An id looks like B2.1"),
        ("hint B8.77", "in its reference.md, such as chapters/ch08_mass_aggregate/reference.md"),
        ("check --engine nowhere", "engine must be a folder of chapters, got 'nowhere'"),
        ("check --exercise 2.2", "'2.2'. Similar ids: 2.2a, 2.2b"),
        ("hint 2.9", "Did you mean B2.9?"),
        ("hint 2.5 --given 2-3", "exercise 2.5 is in chapter 2, which is given"),
        ("reset 2.3", "2.3 is answered in answers.md"),
        ("check --only", "--only requires --exercise"),
        ("check --chapter 5-2", "chapters must count upwards, got '5-2'"),
        ("check --chapter 3 --given 3", "nothing left to check: chapter 3 is given"),
        ("check --chapter 3 --given 19", "no chapter 19"),
        ("grade nowhere --out OUT", "in an existing folder or zip, got 'nowhere'"),
        ("grade studies --out LICENSE", "--out must be a folder, got 'LICENSE'"),
        ("grade studies --out OUT --chapters 1", "no chapter 1"),
        ("grade studies --out OUT --jobs 0", "--jobs must be at least 1"),
        ("grade studies --out OUT --checks no", "--checks must be a folder"),
        ("grade studies --out OUT --note late", "--note is for the log of"),
    ],
)
def test_a_mistake_on_the_command_line_is_one_clear_sentence(
    arguments: str,
    complaint: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(ROOT)
    words = arguments.replace("OUT", str(tmp_path / "out")).split()
    monkeypatch.setattr("sys.argv", ["autograder", *words])
    assert main() == 2
    said = capsys.readouterr().err
    assert complaint in said
    assert len(said.strip().splitlines()) == 1


def test_hints_come_one_at_a_time() -> None:
    hints = load_chapters()[0].exercise("B2.9").hints
    first, second, all_of_them = (autograder("hint", "B2.9", "--count", n).stdout for n in "129")
    assert hints[0] in first
    assert hints[1] not in first
    assert "make hint EX=B2.9 N=2" in first
    assert hints[1] in second
    assert all(hint in all_of_them for hint in hints)
    assert "more" not in all_of_them.splitlines()[-1]


LENGTH = "math.hypot(self.x, self.y, self.z)"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (LENGTH, SQUARES, "likely    The squares of these"),  # a robust check
        ("def magnitude(self)", "def magnitude()", "Perhaps the def line lacks self"),
        (f"return {LENGTH}", "self.x = float(input())", "Remove the call to input"),
    ],
)
def test_a_slip_is_named(vector: Path, old: str, new: str, words: str) -> None:
    edit(vector, old, new)
    done = check(vector)
    assert words in re.split("Fix this first|Make this robust", done.stdout)[1]
    assert "called    " in done.stdout
    assert "read      " in done.stdout


def test_code_that_refuses_what_is_right_is_told_so_and_where() -> None:
    def refuse() -> None:
        raise ValueError("mass must be positive")

    with pytest.raises(ValueError, match="positive") as caught:
        expect_error(refuse, ValueError, allowed=refuse, call="mass(0)", cause="?", read="book 3")
    message = str(explain_exception(caught.value, [Path(__file__).parent]))
    assert "called    like mass(0), but with valid arguments\n" in message
    assert "\nwhere     student/test_check.py, line " in message
    assert "likely    These arguments are valid, so the call must not raise an error.\n" in message


def test_a_complete_file_that_was_edited_is_named_and_is_no_success(vector: Path) -> None:
    assert check(vector, "B2.1").returncode == 0
    file = vector.with_name("arguments.py")
    file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    assert check(vector, "B2.1").returncode == 0, "other line ends are no change"
    with file.open("a", encoding="utf-8") as out:
        out.write("\n\ndef clamp(x):\n    return max(x, 0.0)\n")
    done = check(vector, "B2.1")
    assert done.returncode == 1
    assert "arguments.py. It isn't handed in" in done.stdout


def test_robust_checks_of_what_an_exercise_builds_on_do_not_count_for_it(vector: Path) -> None:
    edit(vector, "math.hypot(self.x, self.y, self.z)", "math.sqrt(self.dot(self))")
    assert check(vector, "B2.2").returncode == 1
    done = check(vector, "2.1")
    assert done.returncode == 0, done.stdout


def test_written_code_that_fails_comes_before_code_that_is_not_written(vector: Path) -> None:
    wrong = "return Vector3(v.x - self.x"
    edit(vector, "return Vector3(self.x + v.x", UNWRITTEN, "return Vector3(self.x - v.x", wrong)
    screen = check(vector, "B2.5").stdout
    assert "half written" not in screen
    assert "not written yet" not in screen.partition("Fix this first")[2]
