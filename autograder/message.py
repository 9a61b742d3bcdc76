"""What a check found, as data: each screen, page and file lays it out for itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from enum import Enum
from typing import Any

INDENT = 10  # columns of a label
LONG_CALL = 100  # characters: of a longer call each statement has a line
Row = tuple[str, str]  # a label, empty for a title, and what it says


class Kind(Enum):
    """How a check came to its end."""

    FAILED = "failed"  # what came back, or was raised, is wrong
    UNWRITTEN = "not written yet"
    HUNG = "did not end"
    BROKEN = "cannot be imported"
    LEFT = "left the process"


@dataclass(frozen=True)
class Place:
    """A line of the student's code: folder and file, such as ch02_vectors/vector.py."""

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
    """What a check found. What is empty is not shown.

    ``title`` is a sentence for what cannot be told by the labeled parts; ``tolerance`` is how near
    ``got`` must come to ``wanted``, 0 for equal; ``other`` is a second possible cause. ``where`` is
    the line of the student's code. ``exercise`` is the one whose body is not written yet, and
    ``blocked_by`` names the exercises that must pass first.
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
        """Whether there is anything to say."""
        return self != NOTHING

    def changed(self, change: Callable[[str], str]) -> Message:
        """Return the message with every text in it changed by a function."""
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
        """Return the labels and what they say, in the order in which people read them."""
        rows = [("", self.blocked), ("", self.title)]
        rows += [("called", one_a_line(self.called)), ("got", self.got)]
        rows += [("wanted", self.wanted + self._how_close), ("where", str(self.where or ""))]
        rows += [("likely", self.likely), ("or", self.other), ("read", self.read)]
        rows += [("printed", self.printed)] if printed else []
        return [(label, words) for label, words in rows if words]

    @property
    def blocked(self) -> str:
        """What must pass first, as a sentence; empty where nothing must."""
        verb = "pass" if len(self.blocked_by) > 1 else "passes"
        return f"blocked until {', '.join(self.blocked_by)} {verb}" if self.blocked_by else ""

    @property
    def in_short(self) -> str:
        """What says most on its own: the cause, or the exception."""
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


def one_a_line(call: str) -> str:
    """Return a call with one statement a line if it is long. What is in brackets stays together."""
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
    """Return rows as text: the label, and what it says from column 10 on.

    Further lines of it begin there as well, so no text can be taken for a label.
    """
    lines = []
    for label, words in rows:
        start = f"{label:{INDENT}}" if label else ""
        lines.append(start + words.replace("\n", "\n" + " " * INDENT))
    return "\n".join(lines)


NOTHING = Message()


class ExpectationError(AssertionError):
    """What a check expected did not come. It carries the message."""

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)
