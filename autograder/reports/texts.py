"""Prepare text for the grading reports: clean what students have written, and format points."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

from autograder.files import replace_bytes
from autograder.message import with_texts
from autograder.scores import shown
from autograder.text.clean import clean, clean_line

T = TypeVar("T")
LONGEST = 4000  # characters of a text in a report; the message of a check has only a few hundred


def clean_all(value: T) -> T:
    """Return a copy of a report or text that is safe to display, with unusual characters escaped.

    Only the first 4000 characters of a text are kept.
    """

    def shortened(text: str) -> str:
        if len(text) > LONGEST:
            text = f"{text[:LONGEST]}\n... and {len(text) - LONGEST} more characters"
        return clean(text)

    return with_texts(value, shortened)


def number(value: float | None) -> str:
    """Format a number of points, such as "18.27" or "3", or "" if it is not known."""
    return "" if value is None else shown(value)


def check_title(name: str) -> str:
    """Turn the name of a check, such as test_clear_leaves_zero, into "clear leaves zero"."""
    return clean_line(name).removeprefix("test_").replace("_", " ")


def replace_file(path: Path, text: str) -> None:
    """Write text to a file, which is replaced whole, so nobody ever reads a half-written file."""
    # Characters in a student's message or name that cannot be encoded are escaped.
    replace_bytes(path, text.encode("utf-8", errors="backslashreplace"))
