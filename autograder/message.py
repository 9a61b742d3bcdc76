"""The message that tells a student why a check failed, as data that screens and pages lay out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, is_dataclass, replace
from enum import Enum
from typing import Any, TypeVar, cast

INDENT = 10  # width of the label column
LONG_CALL = 100  # characters; if the statements before the last are longer, each gets a line
Row = tuple[str, str]  # a label, which is empty for a title, and its text
T = TypeVar("T")


class Kind(Enum):
    """The kind of failure that a check has found."""

    FAILED = "failed"  # a result or an exception is wrong
    UNWRITTEN = "not written yet"
    HUNG = "did not finish"
    BROKEN = "cannot be imported"
    LEFT = "left the process"


@dataclass(frozen=True)
class Place:
    """A line of the student's code. ``file`` is a path such as ch02_vectors/vector.py."""

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
    """The message that a student sees if a check does not pass. Empty parts are not shown."""

    title: str = ""  # a sentence that is shown without a label
    called: str = ""  # the statements that the check ran, of which the last produced the result
    got: str = ""  # what the student's code returned or raised
    wanted: str = ""  # what it must match, to within the tolerance, or exactly if that is 0
    tolerance: float | None = None
    note: str = ""  # what the numbers show, such as that only one component is wrong
    where: Place | None = None  # a line in the file whose function the check called
    inside: Place | None = None  # the line of another file's function, called there, that raised
    likely: str = ""  # the most likely mistake
    other: str = ""  # a second possible mistake
    read: str = ""  # the section of the book or lesson that helps
    printed: str = ""  # what the student's code printed
    kind: Kind = Kind.FAILED
    exercise: str = ""  # if the function is not written yet, the exercise that asks for it
    blocked_by: tuple[str, ...] = ()  # the exercises that must pass first

    def __bool__(self) -> bool:
        return self != NOTHING

    def rows(self, *, printed: bool = True) -> list[Row]:
        """Return the parts that are not empty, such as ("got", "Vector3(1.0, 0.0, 0.0)")."""
        *prepared, called = statements(self.called)
        together = "; ".join(prepared)
        close = f", to within {self.tolerance:.2g}" if self.tolerance else ", exactly"
        rows = [
            ("", self.blocked),
            ("", self.title),
            ("with", together if len(together) <= LONG_CALL else "\n".join(prepared)),
            ("called", called),
            ("got", self.got),
            ("wanted", self.wanted + ("" if self.tolerance is None else close)),
            ("note", self.note),
            ("where", str(self.where or "")),
            ("inside", str(self.inside or "")),
            ("likely", "" if self.blocked_by else self.likely),  # the cause is elsewhere
            ("or", "" if self.blocked_by else self.other),
            ("read", self.read),
            ("printed", self.printed if printed else ""),
        ]
        return [(label, words) for label, words in rows if words]

    @property
    def blocked(self) -> str:
        """What blocks the check, such as "blocked until B2.1 passes", or "" if nothing does."""
        verb = "pass" if len(self.blocked_by) > 1 else "passes"
        return f"blocked until {', '.join(self.blocked_by)} {verb}" if self.blocked_by else ""

    @property
    def in_short(self) -> str:
        """One line for tables: what blocks the check, the likely mistake, or an exception."""
        found = self.blocked or (self.likely if self.wanted else self.got)
        return found or (self.title or self.called).partition("\n")[0]

    def __str__(self) -> str:
        return laid_out(self.rows())


def statements(call: str) -> list[str]:
    """Split code such as "a = Vector3(); a.clear()" at the semicolons that are not in brackets."""
    found, depth = [""], 0
    for part in call.split("; "):
        found[-1] += f"; {part}" if depth else part
        depth += sum(map(part.count, "([{")) - sum(map(part.count, ")]}"))
        if depth <= 0:
            depth = 0
            found.append("")
    return [statement for statement in found if statement] or [""]


def laid_out(rows: list[Row]) -> str:
    """Lay out the rows as text, with further lines indented so that none looks like a label."""
    return "\n".join(
        (f"{label:{INDENT}}" if label else "") + words.replace("\n", "\n" + " " * INDENT)
        for label, words in rows
    )


def with_texts(value: T, change: Callable[[str], str]) -> T:
    """Return a copy of a dataclass in which ``change`` has been applied to every text in it."""

    def changed(part: Any) -> Any:
        if isinstance(part, str):
            return change(part)
        if is_dataclass(part) and not isinstance(part, type):
            return replace(part, **{name: changed(own) for name, own in vars(part).items()})
        return type(part)(map(changed, part)) if isinstance(part, (list, tuple)) else part

    return cast(T, changed(value))


NOTHING = Message()


class ExpectationError(AssertionError):
    """Raised with a message for the student when the code does not do what a check expects."""

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message
