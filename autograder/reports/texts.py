"""What every report does with text: other people's words made harmless, files moved into place."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any, TypeVar, cast

from autograder.scores import shown

T = TypeVar("T")

LONGEST = 4000  # characters of one text in a report; a check's own message has a few hundred
ESCAPE_SEQUENCE = re.compile(
    r"\x1b\[[0-?]*[ -/]*[@-~]"  # colours and moves of the cursor
    r"|\x1b[\]PX^_][^\x07\x1b]*(?:\x07|\x1b\\)"  # titles, links and other strings of a terminal
    r"|\x1b[ -/]*[0-~]"
)
# They turn the reading direction of what follows, so that a text shows other than it is.
TURNING = re.compile("[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]")
LINE_ENDS = re.compile("\r\n?|[\x0b\x0c\x85\u2028\u2029]")


def clean(text: str) -> str:
    """Return a text without escape sequences, with what is no character written as an escape.

    Line ends become newlines, tabs stay, and a text that is too long is cut.
    """
    text = LINE_ENDS.sub("\n", TURNING.sub("", ESCAPE_SEQUENCE.sub("", text)))
    if len(text) > LONGEST:
        text = f"{text[:LONGEST]}\n... and {len(text) - LONGEST} characters more"
    return "".join(map(_visible, text))


def clean_line(text: str) -> str:
    """Return a clean text in one line."""
    return clean(text).replace("\n", " ").replace("\t", " ")


def clean_all(value: T) -> T:
    """Return a report, or a part of one, with every text in it clean."""
    return cast(T, _cleaned(value))


def _cleaned(value: Any) -> Any:
    if isinstance(value, str):
        return clean(value)
    if is_dataclass(value) and not isinstance(value, type):
        parts = {field.name: _cleaned(getattr(value, field.name)) for field in fields(value)}
        return replace(value, **parts)
    if isinstance(value, (list, tuple)):
        return type(value)(_cleaned(item) for item in value)
    return value


def number(value: float | None) -> str:
    """Return points as people write them: 18.27, 2.5, 3, and nothing where there are none."""
    return "" if value is None else shown(value)


def check_title(name: str) -> str:
    """Return a check's name as words: test_clear_leaves_zero is "clear leaves zero"."""
    return clean_line(name).removeprefix("test_").replace("_", " ")


def replace_file(path: Path, text: str) -> None:
    """Write a file beside its place and move it there, so that it is never half written."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".tmp")
    # What is no character, in a student's message or name, is written as an escape.
    temporary.write_bytes(text.encode("utf-8", errors="backslashreplace"))
    temporary.replace(path)


def _visible(character: str) -> str:
    if character in "\n\t":
        return character
    # Control characters, lone surrogates, and U+FFFE and its like, which no text may hold.
    category = unicodedata.category(character)
    broken = category in ("Cc", "Cs") or (category == "Cn" and ord(character) & 0xFFFE == 0xFFFE)
    return ascii(character)[1:-1] if broken else character
