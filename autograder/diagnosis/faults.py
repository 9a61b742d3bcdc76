"""Describe an exception in a student's code as data that can be sent to another process.

With this description, an exception is explained in the same way wherever it was raised.
"""

from __future__ import annotations

import sys
import traceback
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from autograder.diagnosis.misspelled import Unknown, unknown_of
from autograder.message import Message, Place

MOST_FRAMES = 50
GOING_FURTHER = "going_further"  # the folder of a chapter with what goes beyond the book


class CheckEnded(BaseException):
    """Raised to end a check with a message, even if the student's code has ``except Exception``."""

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message


class GraderFault(BaseException):
    """Raised to end a check because of an error in the grader, not in the student's code."""


class StudentLeft(BaseException):
    """Raised if student code raises something that is not an Exception, such as SystemExit."""

    fault: Fault


@dataclass(frozen=True)
class Fault:
    """A description of an exception in a student's code."""

    type: str
    text: str
    frames: list[Place] = field(default_factory=list)  # lines of the traceback in student files
    syntax: tuple[str, int, str] | None = None  # the file, line and text that cannot be parsed
    missing_module: str = ""
    unknown: Unknown | None = None  # the name that does not exist, if that is the cause

    @property
    def first_line(self) -> str:
        """The type and text, as in "ZeroDivisionError: division by zero", cut to one line."""
        first = (self.text.splitlines() or [""])[0][:500]
        return f"{self.type}: {first}" if first else self.type


def fault_of(error: BaseException, folders: Sequence[Path]) -> Fault:
    """Describe an exception, with the lines of its traceback that are in ``folders``."""
    syntax = None
    text = text_of(error)
    if isinstance(error, SyntaxError):
        text = str(error.msg)
        if error.lineno:
            syntax = (short(error.filename or ""), error.lineno, (error.text or "").strip())
    elif isinstance(error, ImportError) and type(error.path) is str:
        text = text.replace(f" ({error.path})", "")  # hide the grader's paths
    elif isinstance(error, ImportError) and error.name in sys.stdlib_module_names:
        # A module such as math is a file in some Pythons and built into others.
        text = text.replace(" (unknown location)", "")
    frames = [
        Place(short(frame.f_code.co_filename), line, frame.f_code.co_name)
        for frame, line in traceback.walk_tb(error.__traceback__)
        if is_inside(frame.f_code.co_filename, folders)
    ]
    missing = (error.name or "") if isinstance(error, ModuleNotFoundError) else ""
    kind, unknown = type(error).__name__, unknown_of(error)
    return Fault(kind, text, frames[-MOST_FRAMES:], syntax, missing, unknown)


def text_of(error: BaseException) -> str:
    """Return the text of an exception, even if a __str__ that the student wrote fails."""
    try:
        return str(error).strip()
    except BaseException:
        return "(its message cannot be shown)"


def is_inside(file: str, folders: Sequence[Path]) -> bool:
    return not _parents(file).isdisjoint(folders)


def short(file: str) -> str:
    """Shorten a path to the part from the chapter's folder on, as in ch02_vectors/vector.py."""
    kept = 3 if Path(file).parent.name == GOING_FURTHER else 2
    return "/".join(Path(file).parts[-kept:])


@cache
def _parents(file: str) -> frozenset[Path]:
    return frozenset(Path(file).resolve().parents)
