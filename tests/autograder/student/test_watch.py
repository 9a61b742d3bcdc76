"""python -m autograder watch, as somebody at a terminal has it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from autograder.student.watching import keys
from small import RIGHT
from terminal import (
    KEYS,
    PATIENCE,
    Terminal,
    command,
    make_handout,
    opened,
    pty,
    save,
    small,
    termios,
)

HALF = RIGHT.replace("return 4 * x", 'raise NotImplementedError("Exercise 90.1: Quadruple")')


root = pytest.fixture(make_handout)
terminal = pytest.fixture(opened)

BAR = "#" * 20 + "." * 20  # one of two exercises


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


def test_a_save_that_breaks_what_the_current_exercise_needs_leads_back_there(
    root: Path, terminal: Terminal
) -> None:
    terminal.wait_for(KEYS)
    save(root, HALF)
    terminal.wait_for("to go on to", KEYS)
    terminal.press("\n")
    terminal.wait_for("): 90.1 Quadruple", KEYS)
    save(root, HALF.replace("x + x", "x * x"))
    terminal.wait_for("): B90.1 Double", "0 of 2 exercises work", KEYS)


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
    process = subprocess.Popen(
        arguments,
        cwd=root,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert process.stdout is not None
    text = ""
    for line in process.stdout:
        text += line
        if "0 of 2 exercises work" in line:
            save(root, HALF)
        if "1 of 2 exercises work" in line:
            break
    process.send_signal(signal.SIGINT)
    assert process.wait(PATIENCE) == 130
    process.stdout.close()
    said = ("so keys do not work", "): B90.1 Double", "B90.1 Double is done", "): 90.1 Quadruple")
    places = [text.find(words) for words in said]
    assert -1 not in places
    assert places == sorted(places)
    assert "\x1b" not in text
