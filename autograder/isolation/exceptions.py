"""Recreate an exception that a student's code raised in a worker, so that a check can catch it."""

from __future__ import annotations

import builtins
import re
from dataclasses import replace
from typing import Any, TypeVar

import msgspec

from autograder.diagnosis.faults import GOING_FURTHER, MOST_FRAMES, Fault, StudentLeft
from autograder.isolation.wire import KNOWN_ERRORS, LONGEST_TEXT, BrokenProtocolError
from autograder.message import Place, with_texts
from autograder.text.clean import clean

FILE = re.compile(rf"ch\d\d_\w+/({GOING_FURTHER}/)?\w+\.py")
LONGEST_REPORT = 100 * LONGEST_TEXT  # characters in all texts together
T = TypeVar("T")


def read(data: Any, kind: type[T]) -> T:
    """Read a text, or a dataclass of texts and numbers, from data that a worker has sent.

    Its texts could contain anything, even control characters that clear the instructor's screen,
    so each is shortened and escaped. Data in another form is a BrokenProtocolError.
    """
    try:
        value = msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        raise BrokenProtocolError(f"a report in an unknown form: {clean(str(error))}") from error
    if len(repr(value)) > LONGEST_REPORT:
        raise BrokenProtocolError("a report that is too long")
    return with_texts(value, lambda text: clean(text[:LONGEST_TEXT]))


def exception_of(name: Any, data: Any) -> BaseException:
    """Rebuild an exception of the student's code from the worker's description of it.

    The result is the built-in exception ``name``, or StudentLeft if the original is not a subclass
    of Exception, as in the case of SystemExit. Its attribute ``fault`` describes the original.
    """
    fault = read(data, Fault)
    frames = [
        Place(frame.file, frame.line, frame.function)
        for frame in fault.frames[-MOST_FRAMES:]
        if FILE.fullmatch(frame.file)
    ]
    kind = getattr(builtins, name) if name in KNOWN_ERRORS else StudentLeft
    exception: BaseException = (WordedKeyError if kind is KeyError else kind)(fault.text)
    exception.fault = replace(fault, frames=frames)  # type: ignore[attr-defined]
    return exception


class WordedKeyError(KeyError):
    """A KeyError whose message is printed as it is, while Python prints the repr of a message."""

    def __str__(self) -> str:
        return str(self.args[0])


WordedKeyError.__name__ = KeyError.__name__
