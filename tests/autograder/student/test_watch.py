"""python -m autograder watch, as somebody has it at a terminal of 80 by 24."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest

from autograder.manifest import ROOT
from autograder.message import laid_out
from autograder.student.watching import keys
from autograder.text.wrapping import few_lines
from small import MANIFEST, RIGHT, make_students_root
from terminal import (
    HEIGHT,
    KEYS,
    PATIENCE,
    WIDTH,
    Terminal,
    command,
    opened,
    pty,
    save,
    small,
    termios,
)

HALF = RIGHT.replace("return 4 * x", 'raise NotImplementedError("Exercise 90.1: Quadruple")')

terminal = pytest.fixture(opened)

BAR = "#" * 20 + "." * 20  # one of two exercises
UNWRITTEN = "raise NotImplementedError('Exercise B90.1: Two and three')"
QUADRUPLE = 'raise NotImplementedError("Exercise 90.1: Quadruple")'
WHY = "A text would be repeated"
TIERS_MANIFEST = (
    MANIFEST.replace("Double", "Two and three")
    .replace('["small.double"]', f'["small.double", "small.triple"]\nrobust = "{WHY}."')
    .replace('needs = ["B90.1"]\n', "")
)
TIERS_CHECKS = """
import pytest
from ch90_small import small
from expect import about, expect_close, expect_error


def expect(call, wanted):
    about(call, cause="it is the multiple", read="the docstring")
    expect_close(eval("small." + call), wanted)


@pytest.mark.exercise("B90.1")
def test_double():
    expect("double(5)", 10)


@pytest.mark.exercise("B90.1")
def test_triple():
    expect("triple(5)", 15)


@pytest.mark.robust
@pytest.mark.exercise("B90.1")
def test_a_text_is_refused():
    about("double('a')", cause="refuse it", read="the docstring")
    twice, text = lambda: small.double(1), lambda: small.double("a")
    expect_error(text, TypeError, allowed=twice)


@pytest.mark.exercise("90.1")
def test_quadruple():
    expect("quadruple(5)", 20)
"""
TIERS = """
def double(x):
    return 2 * x


def triple(x):
    return 3 * x


def quadruple(x):
    raise NotImplementedError("Exercise 90.1: Quadruple")
"""


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_students_root(tmp_path)


@pytest.fixture
def tiers(root: Path) -> Iterator[Terminal]:
    """A terminal with a chapter of two tiers, and an exercise with two functions."""
    chapter, tests = root / "chapters/ch90_small", root / "tests"
    (chapter / "chapter.toml").write_text(TIERS_MANIFEST, encoding="utf-8")
    (tests / "ch90_small/test_small.py").write_text(TIERS_CHECKS, encoding="utf-8")
    (tests / "shared").mkdir()
    for name in ("compared.py", "expect.py"):
        shutil.copyfile(ROOT / "tests/shared" / name, tests / "shared" / name)
    save(root, re.sub("return . [*] x", UNWRITTEN, TIERS))
    yield from opened(root)


def test_from_the_stubs_to_the_end_of_the_chapter(root: Path, terminal: Terminal) -> None:
    terminal.wait_for("Current exercise (0 of 2 checks pass): B90.1 Double")
    terminal.wait_for("not written yet: Exercise B90.1")
    terminal.wait_for("Next: open chapters/ch90_small/small.py:3", "0 of 2 exercises work", KEYS)
    save(root, HALF)
    terminal.wait_for("B90.1 Double is done: 2 of 2 checks pass", f"Chapter 90 [{BAR}] 1 of 2")
    terminal.wait_for("to go on to 90.1 Quadruple", KEYS)
    save(root, RIGHT.replace("4 * x", "5 * x"))  # without Enter
    terminal.wait_for("Current exercise (1 of 2 checks pass): 90.1 Quadruple", KEYS)
    save(root, RIGHT)
    terminal.wait_for("90.1 Quadruple is done", "All checks pass", KEYS)
    save(root, RIGHT.replace("x + x", "x * x"))
    terminal.wait_for("Current exercise (1 of 2 checks pass): B90.1 Double", KEYS)


def test_it_outlives_a_syntax_error_a_deleted_file_and_an_endless_loop(
    root: Path, terminal: Terminal
) -> None:
    terminal.wait_for("not written yet", KEYS)
    save(root, "def double(x):\n    return (x + \n")
    terminal.wait_for("'(' was never closed", KEYS)
    save(root, "")  # an editor that is about to write the rest
    terminal.wait_for("small.py is empty", KEYS)
    small(root).unlink()
    terminal.wait_for("ch90_small/small.py is missing", KEYS)
    save(root, RIGHT.replace("return x + x", "while True:\n        pass"))
    terminal.wait_for("within 3 seconds", KEYS)
    save(root, RIGHT)
    terminal.wait_for("B90.1 Double is done", KEYS)
    assert "Traceback" not in terminal.text


def test_the_keys(root: Path, terminal: Terminal) -> None:
    terminal.wait_for(KEYS)
    terminal.press("h")
    terminal.wait_for("): B90.1 Double", "Hint 1 of 1: twice", KEYS)
    terminal.press("l")
    terminal.wait_for("Chapter 90: Small", "B90.1", "not written yet", "90.1", "not written yet")
    terminal.press("\x1b[A")  # an arrow is no a
    wrong = RIGHT.replace("4 * x", "5 * x")
    save(root, wrong)
    terminal.wait_for("B90.1 Double is done", KEYS)
    terminal.press("a")
    terminal.wait_for("Chapter 90: Small", "Fix this first: 90.1 Quadruple")
    terminal.press("r")
    terminal.wait_for("Reset B90.1 Double?", "double", "build/reset", "(y or n)", KEYS)
    terminal.press("n")
    terminal.wait_for("Nothing was reset", KEYS)
    assert small(root).read_text(encoding="utf-8") == wrong
    terminal.press("ry")
    terminal.wait_for("): B90.1 Double", "restored the stub", "build/reset/ch90_small/small-1.py")
    stub = 'raise NotImplementedError("Exercise B90.1: Double")'
    assert small(root).read_text(encoding="utf-8") == wrong.replace("return x + x", stub)
    terminal.press("q")
    assert terminal.process.wait(PATIENCE) == 0
    assert termios.tcgetattr(terminal.its) == terminal.before, "the terminal is as it was"


def test_special_keys_count_for_none_and_the_others_at_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    ours, its = pty.openpty()
    with os.fdopen(its) as stdin:
        monkeypatch.setattr(sys, "stdin", stdin)
        with keys.single_keys():
            os.write(ours, b"h\x1b[A\x1bOP\x1b[15~a")  # an arrow and two function keys
            typed, deadline = "", time.monotonic() + PATIENCE
            while "a" not in typed and time.monotonic() < deadline:
                typed += keys.pressed()
            os.close(ours)
            assert typed == "ha"
            assert keys.pressed() == keys.END  # the terminal is gone, and that is no error


def test_on_windows_special_keys_count_for_none(monkeypatch: pytest.MonkeyPatch) -> None:
    console = SimpleNamespace(typed=list("h\xe0Hq\0a"))  # an arrow, and a function key
    console.kbhit = lambda: bool(console.typed)
    console.getwch = lambda: console.typed.pop(0)
    monkeypatch.setitem(sys.modules, "msvcrt", console)
    monkeypatch.setattr(sys, "platform", "win32")
    assert keys.pressed() == "hq"
    assert keys.pressed() == ""


def test_ctrl_c_ends_it_quietly(terminal: Terminal) -> None:
    terminal.wait_for(KEYS)
    terminal.process.send_signal(signal.SIGINT)
    assert terminal.process.wait(PATIENCE) == 130
    terminal.wait_for("watch: stopped")
    assert "Traceback" not in terminal.text
    assert termios.tcgetattr(terminal.its) == terminal.before


def test_without_a_terminal_it_says_so_and_goes_on_by_itself(root: Path) -> None:
    arguments, environment = command(root, "watch")
    pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(arguments, cwd=root, env=environment, **pipes) as process:
        text = ""
        for line in process.stdout:
            text += line
            if "0 of 2 exercises work" in line:
                save(root, HALF)
            if "1 of 2 exercises work" in line:
                break
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE) == 130
    said = ("so keys do not work", "): B90.1 Double", "B90.1 Double is done", "): 90.1 Quadruple")
    places = [text.find(words) for words in said]
    assert -1 not in places
    assert places == sorted(places)
    assert "\x1b" not in text


def test_the_physics_of_all_comes_first_and_then_the_robust_checks(
    root: Path, tiers: Terminal
) -> None:
    tiers.wait_for("Current exercise (0 of 2 physics checks pass): B90.1 Two and three", KEYS)
    save(root, TIERS)
    tiers.wait_for("B90.1 Two and three works: all its physics passes.", "1 robust check")
    tiers.wait_for("until", "to go on to 90.1 Quadruple", KEYS)
    right = TIERS.replace(QUADRUPLE, "return 4 * x")
    save(root, right)
    tiers.wait_for("90.1 Quadruple is done: 1 of 1 checks pass", "robust checks")
    tiers.wait_for("to go on to B90.1", KEYS)
    tiers.press("\n")
    tiers.wait_for("Current exercise (0 of 1 robust checks pass): B90.1", "wanted    TypeError")
    tiers.wait_for(WHY, "2 of 2 work, 1 complete", KEYS)
    save(root, right.replace("return 2 * x", "return x / 0.5"))
    tiers.wait_for("B90.1 Two and three is done: 3 of 3", "Chapter 90 works", KEYS)


def test_what_was_just_edited_comes_first(root: Path, tiers: Terminal) -> None:
    """The exercise, and in an exercise with several functions the check of that function."""
    tiers.wait_for("): B90.1 Two and three", "check     test_double", KEYS)
    half = TIERS.replace("return 2 * x", UNWRITTEN)
    save(root, half.replace("3 * x", "33 * x"))
    tiers.wait_for("): B90.1", "check     test_triple", "called    triple(5)", KEYS)
    wrong = half.replace(QUADRUPLE, "return 44 * x").replace("3 * x", "33 * x")
    save(root, wrong)
    tiers.wait_for("): 90.1 Quadruple", KEYS)
    save(root, wrong + "def broken(:")
    tiers.wait_for("): 90.1 Quadruple", "cannot be read", KEYS)
    save(root, wrong.replace("return 33 * x", "return 34 * x"))
    tiers.wait_for("): B90.1", "check     test_triple", KEYS)


def test_on_80_by_24_the_heading_and_the_keys_stay_in_sight(root: Path, terminal: Terminal) -> None:
    terminal.wait_for(KEYS)
    prints = "for i in range(42):\n        print('value number', i)\n    "
    save(root, RIGHT.replace("return x + x", f"{prints}raise ValueError('many words ' * 200)"))
    terminal.wait_for("): B90.1 Double", "make check EX=B90.1", KEYS)
    shows(terminal)
    assert "printed   value number 0" in terminal.screen, "the diagnosis needs the other lines"
    assert "          value number 5" not in terminal.screen
    terminal.press("h")
    terminal.wait_for("Hint 1 of 1", KEYS)
    shows(terminal)
    terminal.press("r")
    terminal.wait_for("(y or n)", KEYS)
    shows(terminal)


def shows(terminal: Terminal) -> None:
    """Expect a screen with the heading at the top and the keys at its end, and whole words."""
    lines = terminal.screen
    assert len(lines) < HEIGHT  # the cursor is on the last
    assert max(map(len, lines)) <= WIDTH
    assert lines[0].startswith("Current exercise (0 of 2 checks pass): B90.1 Double")
    assert lines[-1].endswith(KEYS)
    words = {word for line in lines if "many" in line for word in line.split()[-2:]}
    assert words <= {"many", "words", "ValueError:", "'"}


def test_what_code_prints_cannot_look_like_a_label() -> None:
    text = laid_out([("printed", "1\nlikely    a lie"), ("", "a title\ngot       a lie")])
    assert text.splitlines() == [
        "printed   1",
        "          likely    a lie",
        "a title",
        "          got       a lie",
    ]


@pytest.mark.parametrize(
    ("text", "cut"),
    [
        ("1\n2\n3\n4\n", "1\n2\n3\n... and more"),
        ("x" * 30, f"{'x' * 20}\n... and more"),
        ("1\n2\n3\n", "1\n2\n3"),
    ],
)
def test_what_is_printed_is_cut_to_a_few_lines(text: str, cut: str) -> None:
    assert few_lines(text, 3, 20) == cut
