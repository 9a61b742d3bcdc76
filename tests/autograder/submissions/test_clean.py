"""Text of other people is harmless wherever it is shown, and still says what it said."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.text.clean import clean, clean_line

WORDS = "Åsa B, O'Neill, 王, 🦊, [red], <b>, =1, \\x1b"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        (WORDS, WORDS),
        ("two\n\tlines", "two\n\tlines"),
        ("\x1b[2J\x07", "\\x1b[2J\\x07"),
        ("\x9b1m\x00\ud800", "\\x9b1m\\x00\\ud800"),
        ("\u202ereversed\u200b\ufffe", "\\u202ereversed\\u200b\\ufffe"),
        ("a\r\nb\rc\u2028d\x0be", "a\nb\nc\nd\ne"),
        ("10\u00a0kg", "10 kg"),
    ],
)
def test_what_cannot_be_printed_is_shown_as_an_escape(text: str, shown: str) -> None:
    assert clean(text) == shown


def test_a_line_has_no_second_one() -> None:
    assert clean_line("a\r\nb\tc") == "a b c"


@given(st.text(st.characters(codec=None)))
def test_a_clean_text_can_be_printed_and_encoded_and_is_not_changed_again(text: str) -> None:
    shown = clean(text)
    assert all(line.isprintable() for line in shown.replace("\t", "\n").split("\n"))
    assert shown.encode("utf-8").decode("utf-8") == shown
    assert clean(shown) == shown
