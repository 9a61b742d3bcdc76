"""Recreate an exception that a student's code raised in a worker, so that a check can catch it.

The worker is not trusted and could send anything. Each text from it is shortened and cleaned, and
data that does not describe an exception is rejected with a BrokenProtocolError.
"""

from __future__ import annotations

import ast
import builtins
import re
from typing import Any

from autograder.diagnosis.faults import GOING_FURTHER, Fault, StudentLeft
from autograder.diagnosis.misspelled import MOST_SLOTS, Unknown
from autograder.diagnosis.none_values import LONGEST as MOST_OF_AN_EXPRESSION
from autograder.isolation.wire import KNOWN_ERRORS, BrokenProtocolError
from autograder.message import Place
from autograder.text.clean import clean

FILE = re.compile(rf"ch\d\d_\w+/({GOING_FURTHER}/)?\w+\.py")


def known_name(error: Exception) -> str:
    """Return the name of an exception's class, or of its nearest base class that is built in.

    Exceptions are sent to a worker by name, and it knows only built-in ones.
    """
    return next(base.__name__ for base in type(error).__mro__ if base.__name__ in KNOWN_ERRORS)


def exception_of(data: Any) -> BaseException:
    """Rebuild an exception of the student's code from the worker's description of it.

    The result is the nearest built-in exception, or StudentLeft if the original is not a subclass
    of Exception, as in the case of SystemExit. Its attribute ``fault`` describes the original.

    Raises:
        BrokenProtocolError: The data does not describe an exception.
    """
    try:
        frames = [
            Place(file, line, text_of_worker(function, 100))
            for file, line, function in data["frames"][-50:]
            if type(file) is str and FILE.fullmatch(file) and type(line) is int
        ]
        syntax = data["syntax"]
        if syntax is not None:
            file, line, text = syntax
            syntax = (text_of_worker(file, 200), int(line), text_of_worker(text, 200))
        fault = Fault(
            text_of_worker(data["type"], 100),
            text_of_worker(data["text"], 2000),
            frames,
            syntax,
            text_of_worker(data["missing_module"], 200),
            _unknown(data["unknown"]),
            text_of_worker(data["none"], MOST_OF_AN_EXPRESSION),
        )
        if fault.none:
            ast.parse(fault.none, mode="eval")  # raises SyntaxError if it is not an expression
        name = data["as"]
        kind = getattr(builtins, name) if name in KNOWN_ERRORS else StudentLeft
    except (KeyError, TypeError, ValueError, OverflowError, SyntaxError) as error:
        raise BrokenProtocolError("an exception in an unknown form") from error
    exception: BaseException = (WordedKeyError if kind is KeyError else kind)(fault.text)
    exception.fault = fault  # type: ignore[attr-defined]
    return exception


class WordedKeyError(KeyError):
    """A KeyError whose message is printed as it is, while Python prints the repr of a message."""

    def __str__(self) -> str:
        return str(self.args[0])


WordedKeyError.__name__ = KeyError.__name__


def _unknown(data: Any) -> Unknown | None:
    """Rebuild the undefined name that caused an exception, or return None if nothing did."""
    if data is None:
        return None
    name, of, near = (text_of_worker(data[key], 100) for key in ("name", "of", "nearest"))
    slots = [text_of_worker(slot, 100) for slot in data["slots"][:MOST_SLOTS]]
    return Unknown(name, of, near, slots, data["module"] is True)


def text_of_worker(value: Any, longest: int) -> str:
    """Shorten a string from a worker, and escape its unprintable characters.

    It could contain anything, even control characters that clear the instructor's screen.

    Raises:
        BrokenProtocolError: The worker sent something other than a string.
    """
    if type(value) is not str:
        raise BrokenProtocolError("a value that is not a text")
    return clean(value[:longest])
