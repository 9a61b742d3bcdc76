"""Tell a student why their engine stopped before it answered a message from the page."""

from __future__ import annotations

from pathlib import Path

from autograder.checks.explain import explain_hang

TIME_LIMIT = 2.5  # s per message; a message normally takes a few milliseconds


def why_it_broke_off(stack: str, engine: list[Path]) -> str:
    """Explain why the process running a student's engine stopped.

    ``stack`` is the stack trace that the process writes when it runs out of time. If ``stack`` is
    empty, the process ended on its own.
    """
    if stack:
        return str(explain_hang(stack, TIME_LIMIT, engine))
    return "The engine's process ended on its own. Does your code call os._exit?"
