"""Recreate an exception that a student's code raised in a worker, so that a check can catch it.

The worker process is not trusted and could send anything. Data that does not describe an exception
is therefore rejected with a BrokenProtocolError.
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

    Exceptions are sent to a worker by name, and the worker knows only built-in ones. An instance of
    a subclass of ValueError is therefore sent as "ValueError".
    """
    return next(base.__name__ for base in type(error).__mro__ if base.__name__ in KNOWN_ERRORS)


def exception_of(data: Any) -> BaseException:
    """Rebuild an exception of the student's code from the worker's description of it.

    The result is the nearest built-in exception, such as ValueError for any subclass of ValueError.
    If the original is not a subclass of Exception, as in the case of SystemExit, a StudentLeft
    exception is returned instead. The attribute ``fault`` of the result describes the original,
    including the lines of the student's code that raised it.

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
            _expression(data["none"]),
        )
        name = data["as"]
        kind = getattr(builtins, name) if name in KNOWN_ERRORS else StudentLeft
    except (KeyError, TypeError, ValueError, OverflowError, SyntaxError) as error:
        raise BrokenProtocolError("an exception in an unknown form") from error
    exception: BaseException = (WordedKeyError if kind is KeyError else kind)(fault.text)
    exception.fault = fault  # type: ignore[attr-defined]
    return exception


class WordedKeyError(KeyError):
    """A KeyError whose message is printed without quotes.

    Python prints the argument of a KeyError as a repr, which would put the student's message in
    quotes.
    """

    def __str__(self) -> str:
        return str(self.args[0])


WordedKeyError.__name__ = KeyError.__name__


def _unknown(data: Any) -> Unknown | None:
    """Extract the undefined name that caused an exception from the data that the worker sent.

    The result contains the undefined name, such as "Vector", and the most similar name that exists,
    such as "Vector3". If the exception has another cause, the result is None.
    """
    if data is None:
        return None
    name, of, near = (text_of_worker(data[key], 100) for key in ("name", "of", "nearest"))
    slots = [text_of_worker(slot, 100) for slot in data["slots"][:MOST_SLOTS]]
    return Unknown(name, of, near, slots, data["module"] is True)


def _expression(data: Any) -> str:
    """Extract the expression that was None, and reject anything that is not one."""
    text = text_of_worker(data, MOST_OF_AN_EXPRESSION)
    if text:
        ast.parse(text, mode="eval")  # raises SyntaxError
    return text


def text_of_worker(value: Any, longest: int) -> str:
    """Shorten a string from a worker to ``longest`` characters, and escape unprintable ones.

    The string could contain anything, even control characters that clear the instructor's screen.

    Raises:
        BrokenProtocolError: The worker sent something other than a string.
    """
    if type(value) is not str:
        raise BrokenProtocolError("a value that is not a text")
    return clean(value[:longest])
