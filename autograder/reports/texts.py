"""Prepare text for the grading reports: clean what students have written, and format points."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any, TypeVar, cast

from autograder.files import replace_bytes
from autograder.scores import shown
from autograder.text.clean import clean, clean_line

T = TypeVar("T")

LONGEST = 4000  # characters of a text in a report; the message of a check has only a few hundred


def clean_all(value: T) -> T:
    """Return a copy of a student's report, or of part of a report, that is safe to display.

    The report may contain any text that a student wrote. Unprintable characters are escaped, and
    long texts are truncated.
    """
    return cast(T, _cleaned(value))


def _cleaned(value: Any) -> Any:
    if isinstance(value, str):
        return _clean_and_cut(value)
    if is_dataclass(value) and not isinstance(value, type):
        parts = {field.name: _cleaned(getattr(value, field.name)) for field in fields(value)}
        return replace(value, **parts)
    if isinstance(value, (list, tuple)):
        return type(value)(_cleaned(item) for item in value)
    return value


def _clean_and_cut(text: str) -> str:
    """Sanitize text that may come from a student, so that a report can show it safely.

    Unprintable characters are escaped, and only the first 4000 characters are kept.
    """
    if len(text) > LONGEST:
        text = f"{text[:LONGEST]}\n... and {len(text) - LONGEST} more characters"
    return clean(text)


def number(value: float | None) -> str:
    """Format a number of points for the reports, such as "18.27" or "3".

    If the points are unknown, the result is "".
    """
    return "" if value is None else shown(value)


def check_title(name: str) -> str:
    """Turn the name of a check into a title for the reports.

    For example, test_clear_leaves_zero becomes "clear leaves zero".
    """
    return clean_line(name).removeprefix("test_").replace("_", " ")


def replace_file(path: Path, text: str) -> None:
    """Write text, such as a report, to a file.

    The file is replaced atomically, so nobody ever reads a half-written file.
    """
    # Characters in a student's message or name that cannot be encoded are escaped.
    replace_bytes(path, text.encode("utf-8", errors="backslashreplace"))
