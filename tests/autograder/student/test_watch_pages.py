"""What watch shows on a terminal of 80 by 24, and in which order: tiers, and what was edited."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from autograder.message import laid_out
from autograder.text.wrapping import cut, few_lines, wrapped, wrapped_rows
from small import MANIFEST, RIGHT
from terminal import HEIGHT, KEYS, WIDTH, Terminal, make_handout, opened, save

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


@pytest.mark.exercise("B90.1")
def test_double():
    about("double(5)", cause="twice", read="the docstring")
    expect_close(small.double(5), 10)


@pytest.mark.exercise("B90.1")
def test_triple():
    about("triple(5)", cause="three times", read="the docstring")
    expect_close(small.triple(5), 15)


@pytest.mark.robust
@pytest.mark.exercise("B90.1")
def test_a_text_is_refused():
    about("double('a')", cause="refuse it", read="the docstring")
    twice = lambda: small.double(1)
    text = lambda: small.double("a")
    expect_error(text, TypeError, allowed=twice)


@pytest.mark.exercise("90.1")
def test_quadruple():
    about("quadruple(5)", cause="four times", read="the docstring")
    expect_close(small.quadruple(5), 20)
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
def tiers(root: Path) -> Iterator[Terminal]:
    """A terminal with a chapter of two tiers, and an exercise with two functions."""
    chapter, tests = root / "chapters/ch90_small", root / "tests"
    (chapter / "chapter.toml").write_text(TIERS_MANIFEST, encoding="utf-8")
    (tests / "ch90_small/test_small.py").write_text(TIERS_CHECKS, encoding="utf-8")
    (tests / "shared").mkdir()
    for name in ("compared.py", "expect.py"):
        shutil.copyfile(ROOT / "tests/shared" / name, tests / "shared" / name)
    save(root, re.sub("return . [*] x", UNWRITTEN, TIERS))
    terminal = Terminal(root, "watch")
    yield terminal
    terminal.close()


UNWRITTEN = "raise NotImplementedError('Exercise B90.1: Two and three')"
QUADRUPLE = 'raise NotImplementedError("Exercise 90.1: Quadruple")'


root = pytest.fixture(make_handout)
terminal = pytest.fixture(opened)


def test_the_physics_of_all_comes_first_and_then_the_robust_checks(
    root: Path, tiers: Terminal
) -> None:
    tiers.wait_for("Current exercise (0 of 2 physics checks pass): B90.1 Two and three", KEYS)
    save(root, TIERS)
    tiers.wait_for("B90.1 Two and three works: all 2 physics checks pass.", "1 robust check")
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


def test_a_line_breaks_between_words_below_its_label() -> None:
    rows = [("likely", "some words " * 9), ("", "plain " + "words " * 9)]
    lines = wrapped_rows(rows, 40)
    assert max(map(len, lines)) <= 40
    assert [line[:10].strip() for line in lines] == [
        "likely",
        "",
        "",
        "",
        "plain word",
        "words word",
    ]
    assert {word for line in lines for word in line.split()} == {"likely", "some", "words", "plain"}
    long = "v = " + "x" * 50
    assert "".join(line.strip() for line in wrapped(long, 40)) == long


def test_what_code_prints_cannot_look_like_a_label() -> None:
    text = laid_out([("printed", "1\nlikely    a lie"), ("", "a title\ngot       a lie")])
    assert text.splitlines() == [
        "printed   1",
        "          likely    a lie",
        "a title",
        "          got       a lie",
    ]


def test_a_long_diagnosis_is_cut_in_the_middle() -> None:
    lines = [f"line {number}" for number in range(30)]
    short = cut(lines, 9, "note")
    assert short == [*lines[:4], "note", *lines[-4:]]
    assert cut(lines, 30, "note") == lines
    assert len(cut(lines, -5, "note")) == 3  # a very low terminal


@pytest.mark.parametrize(
    ("text", "kept", "more"),
    [
        ("a\nb", "a\nb", ""),
        ("1\n2\n3\n4", "1\n2\n3", "... and 1 more line"),
        ("\n".join("123456"), "1\n2\n3", "... and 3 more lines"),
        ("1\n2\n3\n4\n... and 10 more lines", "1\n2\n3", "... and 11 more lines"),
        ("x" * 30, "x" * 20, "... and more"),
        ("1\n" * 3000, "1\n1\n1", "... and at least 1997 more lines"),
    ],
)
def test_what_is_printed_is_cut_to_a_few_lines(text: str, kept: str, more: str) -> None:
    assert few_lines(text, 3, 20) == (f"{kept}\n{more}" if more else kept)
