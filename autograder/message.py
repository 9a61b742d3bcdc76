"""The message that tells a student why a check failed, stored as data rather than text.

This allows the terminal, the web pages and the result files to use different layouts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from enum import Enum
from typing import Any

INDENT = 10  # width of the label column
LONG_CALL = 100  # characters; if the statements before the last are longer, each gets a line
Row = tuple[str, str]  # a label, which is empty for a title, and its text


class Kind(Enum):
    """The kind of failure that a check has found, such as a wrong result or an infinite loop."""

    FAILED = "failed"  # a result or an exception is wrong
    UNWRITTEN = "not written yet"
    GONE = "no longer defined"  # a student removed a stub
    HUNG = "did not finish"
    BROKEN = "cannot be imported"
    LEFT = "left the process"


@dataclass(frozen=True)
class Place:
    """A line of the student's code that a failure message points to.

    ``file`` includes the folder of the chapter, as in ch02_vectors/vector.py.
    """

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
    """The message that a student sees if a check does not pass. Empty parts are not shown.

    Attributes:
        title: A sentence that is shown without a label.
        called: The statements that the check ran. The last one produced the result.
        got: What the student's code returned or raised.
        wanted: The value that ``got`` must match, to within ``tolerance``. If the tolerance is 0,
            the two must be equal.
        note: What the numbers show, such as that only one component is wrong.
        where: A line of the student's code, in the file whose function the check called.
        inside: The line of another file's function, called by that line, that raised the error.
        likely: The most likely mistake.
        other: A second possible mistake.
        read: The section of the book or lesson that helps.
        printed: What the student's code printed.
        exercise: If the function is not written yet, the exercise that asks for it.
        blocked_by: The exercises that must pass first.
    """

    title: str = ""
    called: str = ""
    got: str = ""
    wanted: str = ""
    tolerance: float | None = None
    note: str = ""
    where: Place | None = None
    inside: Place | None = None
    likely: str = ""
    other: str = ""
    read: str = ""
    printed: str = ""
    kind: Kind = Kind.FAILED
    exercise: str = ""
    blocked_by: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return self != NOTHING

    def changed(self, change: Callable[[str], str]) -> Message:
        """Return a copy of the message in which ``change`` has been applied to every text.

        This is useful for escaping special characters, for example.
        """
        values: dict[str, Any] = {
            field.name: change(value)
            for field in fields(self)
            if isinstance(value := getattr(self, field.name), str) and value
        }
        for name, place in (("where", self.where), ("inside", self.inside)):
            if place:
                texts = (change(text) for text in (place.file, place.function, place.source))
                file, function, source = texts
                values[name] = Place(file, place.line, function, source)
        return replace(self, **values)

    def rows(self, *, printed: bool = True) -> list[Row]:
        """Return the non-empty parts of the message with their labels, in display order.

        An example of such a row is ("got", "Vector3(1.0, 0.0, 0.0)").
        """
        rows = [("", self.blocked), ("", self.title)]
        *called, tested = statements(self.called)
        rows += [("called", _in_lines(called)), ("tested" if called else "called", tested)]
        rows += [
            ("got", self.got),
            ("wanted", self.wanted + self._how_close),
            ("note", self.note),
            ("where", str(self.where or "")),
            ("inside", str(self.inside or "")),
        ]
        rows += [("likely", self.likely), ("or", self.other), ("read", self.read)]
        rows += [("printed", self.printed)] if printed else []
        return [(label, words) for label, words in rows if words]

    @property
    def blocked(self) -> str:
        """A phrase that says what blocks the check, such as "blocked until B2.1 passes".

        The phrase is empty if nothing blocks the check.
        """
        verb = "pass" if len(self.blocked_by) > 1 else "passes"
        return f"blocked until {', '.join(self.blocked_by)} {verb}" if self.blocked_by else ""

    @property
    def in_short(self) -> str:
        """A one-line summary of the message, for tables and lists.

        If a result was wrong, this is the likely mistake. If the code raised an exception, it is
        the text of the exception.
        """
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


def statements(call: str) -> list[str]:
    """Split a line of Python code, such as "a = Vector3(); a.clear()", into its statements.

    Semicolons inside brackets do not separate statements.
    """
    found, depth = [""], 0
    for part in call.split("; "):
        found[-1] += f"; {part}" if depth else part
        depth += sum(map(part.count, "([{")) - sum(map(part.count, ")]}"))
        if depth <= 0:
            depth = 0
            found.append("")
    return [statement for statement in found if statement] or [""]


def _in_lines(statements: list[str]) -> str:
    """Join statements with semicolons if the result is short, or with line breaks if it is not."""
    together = "; ".join(statements)
    return together if len(together) <= LONG_CALL else "\n".join(statements)


def laid_out(rows: list[Row]) -> str:
    """Format the rows of a failure message as text, with a column of labels on the left.

    Continuation lines are indented like the texts, so that none of them can be mistaken for a
    label.
    """
    lines = []
    for label, words in rows:
        start = f"{label:{INDENT}}" if label else ""
        lines.append(start + words.replace("\n", "\n" + " " * INDENT))
    return "\n".join(lines)


NOTHING = Message()


class ExpectationError(AssertionError):
    """Raised when the student's code does not do what a check expects.

    The exception carries the message that the student will read.
    """

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)
