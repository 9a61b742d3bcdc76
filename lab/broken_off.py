"""Explain to a student why the process that runs their engine stopped answering."""

from __future__ import annotations

from pathlib import Path

from autograder.checks.explain import explain_hang

TIME_LIMIT = 2.5  # s per message; a message normally takes a few milliseconds


def why_it_broke_off(stack: str, engine: list[Path]) -> str:
    """Explain to a student why the process that runs their engine stopped during a scene.

    A process that runs out of time writes a stack trace, which shows where the endless loop is.
    Pass it as ``stack``. An empty ``stack`` means that the process ended on its own.
    """
    if stack:
        return str(explain_hang(stack, TIME_LIMIT, engine))
    return "The engine's process ended on its own. Does your code call os._exit?"
