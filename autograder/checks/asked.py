"""Store the context of the running check, so that a failure message can show it.

The context consists of the call that is being checked, the likely cause of a failure, and the
section to read. A check sets the context before it calls the student's code. If an expectation
fails or the student's code raises an exception, the message includes the context.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypedDict, TypeVar

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")


class Words(TypedDict, total=False):
    """The context for a single expectation, which replaces the context of the check.

    ``then`` is appended to the call.
    """

    call: str
    then: str
    cause: str
    read: str


class About:
    """The context of the running check: the call, the likely cause, and the section to read.

    Call the object to change some parts and keep the others. You can also assign to a part, as in
    ``about.call += "; v.x"``.
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
        """Return the call, the cause and the reading, with the parts in ``words`` replaced."""
        call = words.get("call", self.call) + words.get("then", "")
        return call, words.get("cause", self.cause), words.get("read", self.read)

    def forget(self) -> None:
        """Clear the context before a new check."""
        self("", cause="", read="")


about = About()


def scoped(helper: Callable[Parameters, Returned]) -> Callable[Parameters, Returned]:
    """Wrap ``helper``, so that the context is restored when ``helper`` returns.

    If ``helper`` raises an exception, the context stays as it is, so that the message can show it.
    """

    @wraps(helper)
    def run(*arguments: Parameters.args, **keywords: Parameters.kwargs) -> Returned:
        __tracebackhide__ = True
        before = about.but({})
        returned = helper(*arguments, **keywords)
        about(before[0], cause=before[1], read=before[2])
        return returned

    return run
