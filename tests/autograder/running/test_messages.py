"""Messages: the call in them, numbers with digits and a unit, and slips that they explain."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from autograder.checks.asked import about, short_numbers
from autograder.checks.runner import run_checks
from autograder.diagnosis.slips import fact_of
from autograder.manifest import ROOT, load_chapters
from autograder.message import ExpectationError, Message
from calls import calls
from compared import difference, relation
from copies import copy_tree
from draw import Triple
from expect import (
    expect_between,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
)
from walls import behind_walls

LIMIT = 2.5


@pytest.fixture(autouse=True)
def nothing_asked() -> Iterator[None]:
    about.forget()
    yield
    about.forget()


def make(*numbers: Any, **named: Any) -> SimpleNamespace:
    return SimpleNamespace(numbers=numbers, **named)


def test_names_of_plain_values_become_their_values() -> None:
    v, k, name, nothing, big = Triple((1.0, -2.0, 0.5)), 3, "left", None, [1, math.inf, math.nan]
    with calls("cause"):
        make(*v, v, name, nothing, big, scale=k / 2, limit=LIMIT, text=f"{k} m")
    assert about.call == (
        "make(1.0, -2.0, 0.5, (1.0, -2.0, 0.5), 'left', None, [1, math.inf, math.nan], scale=1.5, "
        "limit=2.5, text='3 m')"
    )


def test_names_of_objects_stay_and_of_the_last_statement_the_value_is_shown() -> None:
    outside, x = make(), 2.0
    with calls("cause"):
        a = make(x)
        b = make(a, outside, other=a.numbers)
        b.speed = -x
        got = b.numbers[0]  # noqa: F841 - this is what a check would compare
    wanted = "a = make(2.0); b = make(a, outside, other=a.numbers); b.speed = -2.0; b.numbers[0]"
    assert about.call == wanted


def test_a_name_that_the_block_changes_stays_a_name() -> None:
    k = 2.0
    with calls("cause"):
        k = k + 1.0
        make(k)
    assert about.call == "k = k + 1.0; make(k)"


def test_a_second_block_continues_the_call_and_may_use_the_result_of_the_first() -> None:
    with calls("cause"):
        a, b = make(1), make(2)
        a.x = b.x = 9.0
        got = make(a)
    with calls("cause", more=True):
        make(got)
    assert about.call == "a = make(1); b = make(2); a.x = b.x = 9.0; got = make(a); make(got)"
    with calls("cause", "p.integrate(1 / 60) 600 times"):
        make()
    with calls("another cause", more=True):
        make(1)
    assert about.call == "p.integrate(1 / 60) 600 times; make(1)"
    assert about.cause == "another cause"


def test_an_error_in_the_block_is_not_hidden_and_a_slip_is_named_before_the_cause() -> None:
    with pytest.raises(ZeroDivisionError), calls("Divide by the length.", "f(1)"):
        raise ZeroDivisionError
    with pytest.raises(ExpectationError) as caught:
        expect_close(6.0, 3.0, {"the sum": 6.0, "the difference": 1.0})
    assert caught.value.message.called == "f(1)"
    assert caught.value.message.likely == "This is the sum. Divide by the length."


def said(expectation: Callable[[], None]) -> Message:
    about("f(0.1)", cause="a mistake", read="the book")
    with pytest.raises(ExpectationError) as caught:
        expectation()
    return caught.value.message


def test_long_numbers_are_rounded_and_others_are_not() -> None:
    long = "Vector3(-0.9183386718650949, 53.291000000000004, 2.000001); g(1.5e-17, 3.0)"
    assert short_numbers(long) == "Vector3(-0.918339, 53.291, 2.000001); g(1.5e-17, 3.0)"


RIGHT = [0.25 * i for i in range(90)]
NEARLY = [*RIGHT[:17], RIGHT[17] + 1e-9, RIGHT[18] + 1.0, *RIGHT[19:]]
PAIRS = [(i, "up") for i in range(20)]
OTHERS = [*PAIRS[:5], (5, "down"), *PAIRS[6:]]
close, exactly = partial(partial, expect_close), partial(partial, expect_exactly)


@pytest.mark.parametrize(
    ("expectation", "got", "wanted"),
    [
        # Numbers that differ look different
        (close((1.0 / 3.0, -0.0), (0.5, 1.0), unit="m"), "(0.333333, 0) m", "(0.5, 1) m"),
        (close(2.0 + 1e-10, 2.0, unit="m/s"), "2.0000000001 m/s", "2 m/s"),
        (close(1234567.5, 0.0), "1234567.5", "0"),
        # A unit follows numbers only
        (exactly(0, 1, unit="contacts"), "0 contacts", "1 contact"),
        (close(None, 1.0, unit="s"), "None", "1 s"),
        (
            partial(expect_between, 0.5, -0.25, 0.25, unit="m"),
            "0.5 m",
            "a number from -0.25 to 0.25 m",
        ),
        # Words can stand for numbers
        (partial(expect_that, False, "no error", "an error"), "no error", "an error"),
        (
            partial(expect_unchanged, "v", (1.0, 2.0), (1.0, 3.0)),
            "v is (1, 2) after the call",
            "v is still (1, 3)",
        ),
        # Of long lists only the first difference is shown
        (
            close(NEARLY, RIGHT, tolerance=1e-6, unit="m"),
            "90 elements, where [18] is 5.5 m",
            "90 elements, where [18] is 4.5 m",
        ),
        (exactly(RIGHT[:40], RIGHT), "40 elements", "90 elements"),
        (
            exactly(OTHERS, PAIRS),
            "20 elements, where [5] is (5, 'down')",
            "20 elements, where [5] is (5, 'up')",
        ),
    ],
)
def test_what_is_said_of_numbers(expectation: Callable[[], None], got: str, wanted: str) -> None:
    message = said(expectation)
    assert (message.got, message.wanted) == (got, wanted)


def test_a_note_says_how_the_numbers_differ_unless_the_mistake_is_recognized() -> None:
    message = said(close((1.0, 2.0, -3.0), (1.0, 2.0, 3.0)))
    assert message.note == "Only the third number is wrong. It has the opposite sign."
    assert ("note", message.note) in message.rows()
    assert said(close(6.0, 3.0, {"You forget to halve it.": 6.0})).note == ""


def test_a_blocked_check_names_no_mistake_since_its_cause_is_elsewhere() -> None:
    message = replace(said(close(6.0, 3.0)), other="another mistake")
    assert {"likely", "or"} <= {*dict(message.rows())}
    blocked = replace(message, blocked_by=("B2.1 (Copy)",))
    assert {"likely", "or"}.isdisjoint(dict(blocked.rows()))
    assert blocked.in_short == "blocked until B2.1 (Copy) passes"


@pytest.mark.parametrize(
    ("got", "wanted", "words"),
    [
        (
            [1.0, 5.0, 6.0],
            [1.0, 2.5, 3.0],
            "Only the second and the third numbers are wrong. Each is 2",
        ),
        ([2.6, 5.0, 6.0], [1.3, 2.5, 3.0], "Each is 2 times the wanted value."),
        ([1.0, 7.1], [1.0, 2.5], "Only the second number is wrong."),
        ([8.0, 7.1, 5.2], [1.0, 2.5, 3.3], ""),
    ],
)
def test_which_of_several_numbers_are_wrong(
    got: list[float], wanted: list[float], words: str
) -> None:
    assert difference(got, wanted, 1e-9).startswith(words)
    assert bool(difference(got, wanted, 1e-9)) == bool(words)


@pytest.mark.parametrize(
    ("got", "wanted", "words"),
    [
        (-7.3, 7.3, "It has the opposite sign."),
        (180.0, 3.141592653589793, "It is 180 / pi times the wanted value."),
        (-3.65, 7.3, "It is half of the wanted value, with the opposite sign."),
        (53.29, 7.3, "It is the square of the wanted value."),
        (1.0 / 7.3, 7.3, "It is 1 divided by the wanted value."),
        (4.0, 2.0, ""),  # 2 times 2, or the square of 2
        (7.4, 7.3, ""),
        (0.0, 7.3, ""),
        (float("nan"), 7.3, ""),
    ],
)
def test_a_relation_is_told_only_if_it_is_the_only_one(
    got: float, wanted: float, words: str
) -> None:
    assert relation(got, wanted) == words


# Slips that Python explains badly

METHOD = (
    r"    def {}\(.*?(?=\n    def |\n    @|\n    __|\nclass |\n\n\n)"  # the whole text of a method
)
SLIPS = tomllib.loads(Path(__file__).with_name("slips.toml").read_text(encoding="utf-8"))


IN_WORKER = [*SLIPS][:6] + [*SLIPS][-1:]  # what fault_of finds there is sent to the checks


@pytest.mark.parametrize(
    ("name", "where"),
    [*((name, "beside") for name in SLIPS), *((name, "in a worker") for name in IN_WORKER)],
)
def test_a_slip_is_explained(name: str, where: str, tmp_path: Path) -> None:
    slip: dict[str, Any] = SLIPS[name]
    (chapter,) = (c for c in load_chapters() if slip["file"].startswith(c.name))
    for other in load_chapters():
        if other.number <= chapter.number:
            copy_tree(ROOT / "solutions" / other.name, tmp_path / other.name)
    file = tmp_path / slip["file"]
    code = file.read_text(encoding="utf-8")
    for pattern, new in slip["changes"]:
        whole = re.sub("<(\\w+)>", lambda name: METHOD.format(name[1]), pattern)
        code, count = re.subn(whole, lambda _, new=new: new, code, count=1, flags=re.DOTALL)
        assert count, pattern
    file.write_text(code, encoding="utf-8")
    engine, sandbox = [tmp_path, ROOT / "chapters"], behind_walls() if "worker" in where else None
    exercises = [*slip["texts"]]
    verdicts = run_checks(chapter, engine, seed="1", exercises=exercises, sandbox=sandbox)
    for exercise, texts in slip["texts"].items():
        failed = [v for v in verdicts if v.exercise == exercise and v.status != "passed"]
        assert failed
        assert "error" not in {verdict.status for verdict in failed}
        messages = [str(verdict.message) for verdict in failed]
        for text in texts:
            pattern = ".*".join(map(re.escape, text.split(" ... ")))
            assert re.search(pattern, "\n".join(messages), re.DOTALL), text
        assert all(text in said for text in slip.get("every", ()) for said in messages)
        assert not any(text in said for text in slip.get("never", ()) for said in messages)


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("f()", "The call passes no value for a and b."),
        ("f(1)", "The call passes no value for b."),
        ("f(1, 2, 3)", "The call passes 3 arguments, but the def line takes 2. Perhaps the def"),
        ("f(1, 2, 3, 4)", "The call passes 4 arguments, but the def line takes 2."),
        ("g()", "The call passes no value for c. Pass it by name."),
        ("a()", "Your code calls a value that isn't a function. Perhaps this value is a"),
    ],
)
def test_wrong_numbers_of_arguments(code: str, says: str) -> None:
    there = {"f": lambda a, b: (a, b), "g": lambda *, c: c, "a": True}
    with pytest.raises(TypeError) as caught:
        eval(code, there)
    assert fact_of(str(caught.value)).startswith(says)
    assert ("lacks self" in fact_of(str(caught.value))) is (code == "f(1, 2, 3)")
