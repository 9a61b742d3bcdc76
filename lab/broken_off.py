"""Explain why an engine stopped in the middle of a message."""

from __future__ import annotations

from pathlib import Path

from autograder.checks.explain import explain_hang

TIME_LIMIT = 2.5  # s per message; a message normally takes a few milliseconds


def why_it_broke_off(stack: str, engine: list[Path]) -> str:
    """Return the explanation. ``stack`` is what the engine wrote when its time was up, or empty."""
    if stack:
        return str(explain_hang(stack, TIME_LIMIT, engine))
    return "The engine's process ended by itself. Does your code call os._exit?"
