"""Talk to the worker that runs Python: send messages to the page, and start or stop the clock."""

from __future__ import annotations

import json
from typing import Any

import worker  # type: ignore[import-not-found]  # worker.js creates this module


def post(kind: str, **values: Any) -> None:
    """Send a message of plain data to the page."""
    worker.post(json.dumps({"kind": kind, **values}, allow_nan=False))


def start_clock(seconds: float) -> None:
    """Ask the worker to send the signal SIGALRM in this many seconds."""
    worker.startClock(seconds)


def stop_clock() -> None:
    """Tell the worker that the signal is no longer needed."""
    worker.stopClock()
