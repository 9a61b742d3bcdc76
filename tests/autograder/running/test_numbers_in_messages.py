"""Numbers in messages have as many digits as a reader needs, and a unit."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from autograder.checks.asked import about, short_numbers
from autograder.message import ExpectationError, Message
from compared import difference, relation
from expect import (
    expect_between,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
)


def said(expectation: Callable[[], None]) -> Message:
    about("f(0.1)", cause="a mistake", read="the book")
    with pytest.raises(ExpectationError) as caught:
        expectation()
    about.forget()
    return caught.value.message


def test_long_numbers_are_rounded_and_others_are_not() -> None:
    long = "Vector3(-0.9183386718650949, 53.291000000000004, 2.000001); g(1.5e-17, 3.0)"
    assert short_numbers(long) == "Vector3(-0.918339, 53.291, 2.000001); g(1.5e-17, 3.0)"


def test_numbers_that_differ_look_different() -> None:
    message = said(lambda: expect_close((1.0 / 3.0, -0.0), (0.5, 1.0), unit="m"))
    assert (message.got, message.wanted) == ("(0.333333, 0) m", "(0.5, 1) m")
    message = said(lambda: expect_close(2.0 + 1e-10, 2.0, unit="m/s"))
    assert (message.got, message.wanted) == ("2.0000000001 m/s", "2 m/s")
    message = said(lambda: expect_close(1234567.5, 0.0))
    assert (message.got, message.wanted) == ("1234567.5", "0")


def test_a_unit_follows_numbers_only() -> None:
    message = said(lambda: expect_exactly(0, 1, unit="contacts"))
    assert (message.got, message.wanted) == ("0 contacts", "1 contact")
    message = said(lambda: expect_close(None, 1.0, unit="s"))
    assert (message.got, message.wanted) == ("None", "1 s")
    message = said(lambda: expect_between(0.5, -0.25, 0.25, unit="m"))
    assert (message.got, message.wanted) == ("0.5 m", "a number from -0.25 to 0.25 m")


def test_words_can_stand_for_numbers() -> None:
    message = said(lambda: expect_that(False, "no error", "an error"))
    assert (message.got, message.wanted) == ("no error", "an error")
    message = said(lambda: expect_unchanged("v", (1.0, 2.0), (1.0, 3.0)))
    assert message.got == "v is (1, 2) after the call"
    assert message.wanted == "v is still (1, 3)"


def test_of_long_lists_only_the_first_difference_is_shown() -> None:
    right = [0.25 * i for i in range(90)]
    nearly = [*right[:17], right[17] + 1e-9, right[18] + 1.0, *right[19:]]
    message = said(lambda: expect_close(nearly, right, tolerance=1e-6, unit="m"))
    assert message.got == "90 elements, where [18] is 5.5 m"
    assert message.wanted == "90 elements, where [18] is 4.5 m"
    message = said(lambda: expect_exactly(right[:40], right))
    assert (message.got, message.wanted) == ("40 elements", "90 elements")
    pairs = [(i, "up") for i in range(20)]
    message = said(lambda: expect_exactly([*pairs[:5], (5, "down"), *pairs[6:]], pairs))
    assert message.got == "20 elements, where [5] is (5, 'down')"
    message = said(lambda: expect_close(None, right))
    assert message.got == "None"


def test_a_note_says_how_the_numbers_differ_unless_the_mistake_is_recognized() -> None:
    message = said(lambda: expect_close((1.0, 2.0, -3.0), (1.0, 2.0, 3.0)))
    assert message.note == "Only the third number is wrong. It has the opposite sign."
    assert ("note", message.note) in message.rows()

    halved = said(lambda: expect_close(6.0, 3.0, {"You forget to halve it.": 6.0}))
    assert halved.note == ""


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
