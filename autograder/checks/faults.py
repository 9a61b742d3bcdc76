"""Describe an exception in a student's code as plain data.

The code may run in this process or in a worker process. In both cases the description has the same
form.
"""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from autograder.checks.nearest import Unknown, unknown_of
from autograder.message import Message, Place

MOST_FRAMES = 50


class CheckEnded(BaseException):
    """Raised to end a check with a message.

    The class derives from BaseException, so a student's ``except Exception`` does not catch it.
    """

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)


class GraderFault(BaseException):
    """Raised to end a check because of an error in the grader, not in the student's code."""


class StudentLeft(BaseException):
    """Raised when student code raises something other than an Exception, such as SystemExit."""

    fault: Fault


@dataclass(frozen=True)
class Fault:
    """An exception as plain data: the name of its type, its text, and the frames in student code.

    For a syntax error, it also contains the file, the line and the text that Python could not
    parse. If the exception reports a missing name, ``unknown`` describes the name.
    """

    type: str
    text: str
    frames: list[Place] = field(default_factory=list)
    syntax: tuple[str, int, str] | None = None
    missing_module: str = ""
    unknown: Unknown | None = None

    @property
    def first_line(self) -> str:
        """The type and the text on one line, as at the end of a traceback.

        Long text is shortened.
        """
        first = (self.text.splitlines() or [""])[0][:500]
        return f"{self.type}: {first}" if first else self.type


def fault_of(error: BaseException, folders: Sequence[Path]) -> Fault:
    """Describe the exception ``error`` as plain data.

    Only frames of files in ``folders`` are included. The innermost frame comes last.
    """
    syntax = None
    text = text_of(error)
    if isinstance(error, SyntaxError):
        text = str(error.msg)
        if error.lineno:
            syntax = (short(error.filename or ""), error.lineno, (error.text or "").strip())
    if isinstance(error, ImportError) and type(error.path) is str:
        text = text.replace(f" ({error.path})", "")  # hide the grader's paths
    frames = [
        Place(short(frame.f_code.co_filename), line, frame.f_code.co_name)
        for frame, line in traceback.walk_tb(error.__traceback__)
        if is_inside(frame.f_code.co_filename, folders)
    ]
    missing = (error.name or "") if isinstance(error, ModuleNotFoundError) else ""
    kind, frames = type(error).__name__, frames[-MOST_FRAMES:]
    return Fault(kind, text, frames, syntax, missing, unknown_of(error))


def text_of(error: BaseException) -> str:
    """Return the text of an exception, even if the student's own __str__ method fails."""
    try:
        return str(error).strip()
    except BaseException:
        return "(its message cannot be shown)"


def is_inside(file: str, folders: Sequence[Path]) -> bool:
    """Return whether a file is in one of the folders."""
    parents = _parents(file)
    return any(folder in parents for folder in folders)


def short(file: str) -> str:
    """Return the last folder and the name of a file, such as ch02_vectors/vector.py."""
    return f"{Path(file).parent.name}/{Path(file).name}"


@cache
def _parents(file: str) -> list[Path]:
    return list(Path(file).resolve().parents)
