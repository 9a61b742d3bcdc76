"""Represent the message of a check as data.

Screens, pages and files format it in different ways.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from enum import Enum
from typing import Any

INDENT = 10  # width of the label column
LONG_CALL = 100  # characters; a longer call is shown with one statement per line
Row = tuple[str, str]  # a label, which is empty for a title, and its text


class Kind(Enum):
    """The way in which a check ended."""

    FAILED = "failed"  # a result or an exception is wrong
    UNWRITTEN = "not written yet"
    GONE = "no longer defined"  # a student removed a stub
    HUNG = "did not finish"
    BROKEN = "cannot be imported"
    LEFT = "left the process"


@dataclass(frozen=True)
class Place:
    """A line of the student's code, in a file such as ch02_vectors/vector.py."""

    file: str
    line: int
    function: str = ""
    source: str = ""

    def __str__(self) -> str:
        function = f", in {self.function}" if self.function else ""
        source = f": {self.source}" if self.source else ""
        return f"{self.file}, line {self.line}{function}{source}"


@dataclass(frozen=True)
class Message:
    """The message that tells a student the outcome of a check. Empty parts are not shown.

    ``title`` is a sentence without a label. ``got`` must equal ``wanted`` to within ``tolerance``,
    or exactly if the tolerance is 0. ``where`` is a line of the student's code. ``likely`` is the
    likely cause of the failure, and ``other`` is a second possible cause. If a function is not
    written yet, ``exercise`` names the exercise in which to write it. ``blocked_by`` lists the
    exercises that must pass first.
    """

    title: str = ""
    called: str = ""
    got: str = ""
    wanted: str = ""
    tolerance: float | None = None
    where: Place | None = None
    likely: str = ""
    other: str = ""
    read: str = ""
    printed: str = ""
    kind: Kind = Kind.FAILED
    exercise: str = ""
    blocked_by: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        """Return whether the message has any content."""
        return self != NOTHING

    def changed(self, change: Callable[[str], str]) -> Message:
        """Return a copy of the message with ``change`` applied to every text."""
        values: dict[str, Any] = {
            field.name: change(value)
            for field in fields(self)
            if isinstance(value := getattr(self, field.name), str) and value
        }
        if self.where:
            where = self.where
            values["where"] = Place(
                change(where.file), where.line, change(where.function), change(where.source)
            )
        return replace(self, **values)

    def rows(self, *, printed: bool = True) -> list[Row]:
        """Return the labels with their texts, in the order in which they are shown."""
        rows = [("", self.blocked), ("", self.title)]
        rows += [("called", one_per_line(self.called)), ("got", self.got)]
        rows += [("wanted", self.wanted + self._how_close), ("where", str(self.where or ""))]
        rows += [("likely", self.likely), ("or", self.other), ("read", self.read)]
        rows += [("printed", self.printed)] if printed else []
        return [(label, words) for label, words in rows if words]

    @property
    def blocked(self) -> str:
        """A sentence that names the exercises that must pass first, or an empty string."""
        verb = "pass" if len(self.blocked_by) > 1 else "passes"
        return f"blocked until {', '.join(self.blocked_by)} {verb}" if self.blocked_by else ""

    @property
    def in_short(self) -> str:
        """The most informative part: the likely cause of a wrong value, or the exception."""
        return (self.likely if self.wanted else self.got) or (
            self.blocked or self.title or self.called
        ).partition("\n")[0]

    @property
    def _how_close(self) -> str:
        if self.tolerance is None:
            return ""
        return f", to within {self.tolerance:.2g}" if self.tolerance else ", exactly"

    def __str__(self) -> str:
        return laid_out(self.rows())


def one_per_line(call: str) -> str:
    """Put each statement of a long call on its own line. Do not split text inside brackets."""
    if len(call) <= LONG_CALL:
        return call
    lines, depth = [""], 0
    for part in call.split("; "):
        lines[-1] += f"; {part}" if depth else part
        depth += sum(map(part.count, "([{")) - sum(map(part.count, ")]}"))
        if depth <= 0:
            depth = 0
            lines.append("")
    return "\n".join(line for line in lines if line)


def laid_out(rows: list[Row]) -> str:
    """Format ``rows`` as text. Each row starts with its label, and its text starts at column 10.

    Continuation lines are indented too, so that nobody mistakes their text for a label.
    """
    lines = []
    for label, words in rows:
        start = f"{label:{INDENT}}" if label else ""
        lines.append(start + words.replace("\n", "\n" + " " * INDENT))
    return "\n".join(lines)


NOTHING = Message()


class ExpectationError(AssertionError):
    """Raised when a student's code does not meet an expectation.

    It contains the check's message.
    """

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)
