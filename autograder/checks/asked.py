"""The context of the running check: its call, the likely cause of a failure, and where to read.

A check sets the context before it calls the student's code. A failed expectation shows it in its
message, and so does an exception of that code.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypedDict, TypeVar

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")


class Words(TypedDict, total=False):
    """The context of one expectation, which replaces the check's. ``then`` is added to the call."""

    call: str
    then: str
    cause: str
    read: str


class About:
    """The context of the running check: call, cause and reading.

    Calling the object sets the parts that are passed and keeps the others. A part may also be
    assigned: about.call += "; v.x".
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
        """Return call, cause and reading, with ``words`` in place of the check's parts."""
        call = words.get("call", self.call) + words.get("then", "")
        return call, words.get("cause", self.cause), words.get("read", self.read)

    def forget(self) -> None:
        """Clear the context before a new check."""
        self("", cause="", read="")


about = About()


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Restore the context when a helper returns. If the helper raises, keep its context."""

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
