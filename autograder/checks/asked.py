"""Store the parts of the message that a check shows if it fails.

Before a check calls the student's code, it stores three parts: the call, the likely mistake behind
a wrong result, and the section to read. The message shows all three if the result is wrong or the
student's code raises an exception.
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

    ``call``, ``cause`` and ``read`` replace the parts that the check has stored, and ``then`` is
    appended to the call. ``unit`` is a unit such as "m/s" or a plural noun such as "contacts". It
    follows both the returned and the expected number in the message.
    """

    call: str
    then: str
    unit: str
    cause: str
    read: str


class About:
    """The parts of a check's failure message: the call, the likely mistake and the section to read.

    A check sets them before it calls the student's code. To change only some of them, call the
    object with the new values, or assign to an attribute, as in ``about.call += "; v.x"``. The call
    may be a function that writes it, because only a check that fails needs it.
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
        """Return the call, the likely mistake and the section to read for one comparison.

        ``words`` contains the parts that differ from those that the check has stored.
        """
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
    """Shorten the computed numbers in a string, for example from 0.30000000000000004 to 0.3.

    Numbers with ten or more decimal places are rounded to six significant digits. All others stay
    as they are.
    """
    return LONG.sub(lambda number: f"{float(number[0]):.6g}", text)


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Decorate a helper so that it restores the parts of the failure message when it returns.

    A check stores these parts in ``about``. The helper may replace them to describe its own calls.
    If the helper raises an exception, its own parts are kept, because the failure message needs
    them.
    """

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
