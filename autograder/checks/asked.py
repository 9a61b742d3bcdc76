"""Store the parts of the message that a check shows if it fails.

Before a check calls the student's code, it stores the call, the likely mistake behind a wrong
result, and the section to read. The message shows them also if the code raises an exception.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypedDict, TypeVar

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")
Text = str | Callable[[], str]  # a text, or a function that writes it when it is needed
LONG = re.compile(r"\b\d{1,5}\.\d{10,}(?:e[-+]?\d+)?\b")  # a computed number with all its digits


class Words(TypedDict, total=False):
    """Parts of a failure message that a check sets for only one of its comparisons.

    ``then`` is appended to the call. ``unit``, such as "m/s" or "contacts", follows both numbers.
    """

    call: str
    then: str
    unit: str
    cause: str
    read: str


class About:
    """The parts of a check's failure message: the call, the likely mistake and the section to read.

    To change some of them, call the object with the new values, or assign to an attribute.
    """

    def __init__(self) -> None:
        self._call: Text = ""
        self.cause = self.read = ""
        self.recognized = ""  # the last cause that was found by the result it leads to

    @property
    def call(self) -> str:
        """The call as text."""
        self._call = written(self._call)
        return self._call

    @call.setter
    def call(self, call: Text) -> None:
        self._call = call

    def __call__(
        self, call: Text | None = None, *, cause: str | None = None, read: str | None = None
    ) -> None:
        self._call = self._call if call is None else call
        self.cause = self.cause if cause is None else cause
        self.read = self.read if read is None else read

    def but(self, words: Words) -> tuple[Text, str, str]:
        """Return the call, the likely mistake and the section to read for one comparison."""
        call, then = words.get("call", self._call), words.get("then", "")
        whole = (lambda: written(call) + then) if then else call
        return whole, words.get("cause", self.cause), words.get("read", self.read)

    def forget(self) -> None:
        """Clear all parts of the failure message before the next check stores its own."""
        self("", cause="", read="")
        self.recognized = ""


def written(text: Text) -> str:
    """Return a text, which a function may still have to write."""
    return text if isinstance(text, str) else text()


about = About()


def short_numbers(text: str) -> str:
    """Round the numbers in a text that have ten or more decimal places to six digits."""
    return LONG.sub(lambda number: f"{float(number[0]):.6g}", text)


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Decorate a helper so that it restores the parts of the failure message when it returns."""

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
