"""Say why an engine has broken off in the middle of a message."""

from __future__ import annotations

from pathlib import Path

from autograder.checks.explain import explain_hang

TIME_LIMIT = 2.5  # s, for a message that takes some milliseconds


def why_it_broke_off(stack: str, engine: list[Path]) -> str:
    """Return the reason, by the stack that the engine left when its time was up, if it was."""
    if stack:
        return str(explain_hang(stack, TIME_LIMIT, engine))
    return "The engine's process ended by itself: is there an os._exit in your code?"
