"""What the worker does for Python: it sends messages to the page, and has a clock."""

from __future__ import annotations

import json
from typing import Any

import worker  # type: ignore[import-not-found]  # worker.js makes it


def post(kind: str, **values: Any) -> None:
    """Send a message of plain data to the page."""
    worker.post(json.dumps({"kind": kind, **values}, allow_nan=False))


def start_clock(seconds: float) -> None:
    """Have the signal SIGALRM come in this many seconds."""
    worker.startClock(seconds)


def stop_clock() -> None:
    """Have no signal come."""
    worker.stopClock()
