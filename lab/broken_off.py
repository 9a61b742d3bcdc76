"""Explain to a student why the process that runs their engine stopped answering."""

from __future__ import annotations

from pathlib import Path

from autograder.diagnosis.explain import explain_hang

TIME_LIMIT = 2.5  # s per message; a message normally takes a few milliseconds
# The first message makes the engine import the scene. That takes a second, or several if the
# computer is busy or slow. In the browser, so does every message that loads a scene.
FIRST_LIMIT = 8.0  # s


def why_it_broke_off(stack: str, engine: list[Path], limit: float = TIME_LIMIT) -> str:
    """Explain why the engine stopped. ``stack`` is the trace written after ``limit`` s, or ""."""
    if stack:
        return str(explain_hang(stack, limit, engine))
    return "The engine's process ended on its own. Does your code call os._exit?"
