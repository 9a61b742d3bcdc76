"""The call in a message, which calls.py makes from the code that a check runs."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from autograder.checks.asked import about
from autograder.message import ExpectationError
from calls import calls
from draw import Triple
from expect import expect_close

LIMIT = 2.5


def make(*numbers: Any, **named: Any) -> SimpleNamespace:
    return SimpleNamespace(numbers=numbers, **named)


def call_of(block: Callable[[], object]) -> str:
    about.forget()
    block()
    return about.call


def test_names_of_plain_values_become_their_values() -> None:
    v, k, name, nothing, big = Triple((1.0, -2.0, 0.5)), 3, "left", None, [1, math.inf, math.nan]

    def block() -> None:
        with calls("cause"):
            make(*v, v, name, nothing, big, scale=k / 2, limit=LIMIT, text=f"{k} m")

    assert call_of(block) == (
        "make(1.0, -2.0, 0.5, (1.0, -2.0, 0.5), 'left', None, [1, math.inf, math.nan], scale=1.5, "
        "limit=2.5, text='3 m')"
    )


def test_names_of_objects_stay_and_of_the_last_statement_the_value_is_shown() -> None:
    outside, x = make(), 2.0

    def block() -> None:
        with calls("cause"):
            a = make(x)
            b = make(a, outside, other=a.numbers)
            b.speed = -x
            got = b.numbers[0]  # noqa: F841 - this is what a check would compare

    wanted = "a = make(2.0); b = make(a, outside, other=a.numbers); b.speed = -2.0; b.numbers[0]"
    assert call_of(block) == wanted


def test_a_name_that_the_block_changes_stays_a_name() -> None:
    k = 2.0

    def block() -> None:
        nonlocal k
        with calls("cause"):
            k = k + 1.0
            make(k)

    assert call_of(block) == "k = k + 1.0; make(k)"


def test_a_long_matrix_has_a_line_for_each_row() -> None:
    short, long = range(9), [i / 7.0 for i in range(12)]

    def block() -> None:
        with calls("cause"):
            make(*[*short])
        with calls("cause", more=True):
            make(*long)

    one, *rows = call_of(block).splitlines()
    assert one.startswith("make(*[*short]); make(0.0, ")
    assert [row.count(",") for row in (one, *rows)] == [4, 4, 3]


def test_a_second_block_may_use_the_result_of_the_first() -> None:
    def block() -> None:
        with calls("cause"):
            a, b = make(1), make(2)
            a.x = b.x = 9.0
            got = make(a)
        with calls("cause", more=True):
            make(got)

    wanted = "a = make(1); b = make(2); a.x = b.x = 9.0; got = make(a); make(got)"
    assert call_of(block) == wanted


def test_a_second_block_or_a_text_continues_the_call() -> None:
    def block() -> None:
        with calls("cause", "p.integrate(1 / 60) 600 times"):
            make()
        with calls("another cause", more=True):
            make(1)

    assert call_of(block) == "p.integrate(1 / 60) 600 times; make(1)"
    assert about.cause == "another cause"


def test_an_error_in_the_block_is_not_hidden_and_a_slip_is_named_before_the_cause() -> None:
    with pytest.raises(ZeroDivisionError), calls("Divide by the length.", "f(1)"):
        raise ZeroDivisionError
    with pytest.raises(ExpectationError) as caught:
        expect_close(6.0, 3.0, {"the sum": 6.0, "the difference": 1.0})
    assert caught.value.message.called == "f(1)"
    assert caught.value.message.likely == "This is the sum. Divide by the length."
    about.forget()
