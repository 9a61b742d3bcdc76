"""Remember what the running check is testing, so that a message about a failure can say so.

Before a check calls the student's code, it stores three things: the call, the likely mistake if the
result is wrong, and the section to read. If the result is wrong, or if the student's code raises an
exception, the message shows all three.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypedDict, TypeVar

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")


class Words(TypedDict, total=False):
    """Words for a single expectation, which replace those that its check has stored in ``about``.

    ``then`` is appended to the call instead of replacing it.
    """

    call: str
    then: str
    cause: str
    read: str


class About:
    """What a message about a failure will show: the call, the likely mistake, and what to read.

    To change some of these and keep the rest, call the object with the new ones. You can also
    assign to one of them, as in ``about.call += "; v.x"``.
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
        """Return the call, the mistake and what to read, with those in ``words`` replaced."""
        call = words.get("call", self.call) + words.get("then", "")
        return call, words.get("cause", self.cause), words.get("read", self.read)

    def forget(self) -> None:
        """Clear everything, so that a check does not inherit the words of the check before it."""
        self("", cause="", read="")


about = About()


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Wrap a helper of the checks, so that what it stores in ``about`` is undone when it returns.

    If the helper raises an exception, nothing is undone, because the message about the failure
    needs what the helper has stored.
    """

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
