"""Remember what the running check is testing, so that a failure message can say so.

Before a check calls the student's code, it stores three things: the call, the likely mistake if the
result is wrong, and the section to read. The message shows all three if the result is wrong or the
student's code raises an exception.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypedDict, TypeVar

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")
LONG = re.compile(r"\b\d{1,5}\.\d{10,}\b(?![eE])")  # a computed number with all its digits


class Words(TypedDict, total=False):
    """Texts for the failure message of one expectation, in place of those stored in ``about``.

    Two of them replace no text: ``then`` is appended to the call, and ``unit`` follows the numbers
    that came and were wanted. It is a unit such as "m/s", or a plural such as "contacts".
    """

    call: str
    then: str
    unit: str
    cause: str
    read: str


class About:
    """The texts for a failure message: the call, the likely mistake, and the section to read.

    To change only some of them, call the object with the new texts or assign to its attributes, as
    in ``about.call += "; v.x"``.
    """

    def __init__(self) -> None:
        self.call = self.cause = self.read = ""

    def __call__(
        self, call: str | None = None, *, cause: str | None = None, read: str | None = None
    ) -> None:
        self.call = self.call if call is None else call
        self.cause = self.cause if cause is None else cause
        self.read = self.read if read is None else read

    def but(self, words: Words) -> tuple[str, str, str]:
        """Return the call, the likely mistake and the section to read, for one expectation.

        Texts in ``words`` replace those that the check has stored.
        """
        call = words.get("call", self.call) + words.get("then", "")
        return call, words.get("cause", self.cause), words.get("read", self.read)

    def forget(self) -> None:
        """Clear the texts of this check, to keep them out of the next check's messages."""
        self("", cause="", read="")


about = About()


def short_numbers(text: str) -> str:
    """Round the numbers in a text that have ten decimals or more to six digits."""
    return LONG.sub(lambda number: f"{float(number[0]):.6g}", text)


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Decorate a helper function of the checks, so that it leaves ``about`` as it was.

    If the helper raises an exception, its changes stay, because the failure message needs them.
    """

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
