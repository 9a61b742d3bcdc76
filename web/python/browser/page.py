"""Send messages to the page, and control the clock that limits how long student code may run."""

from __future__ import annotations

import json
from typing import Any

import worker  # type: ignore[import-not-found]  # worker.js creates this module


def post(kind: str, **values: Any) -> None:
    """Send the page a message of a kind such as "progress", with values for JSON."""
    worker.post(json.dumps({"kind": kind, **values}, allow_nan=False))


def start_clock(seconds: float) -> None:
    """Tell the web worker to send the signal SIGALRM to Python in ``seconds`` seconds."""
    worker.startClock(seconds)


def stop_clock() -> None:
    """Tell the web worker not to send the signal SIGALRM any more."""
    worker.stopClock()
