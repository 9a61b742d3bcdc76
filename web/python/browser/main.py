"""What the worker calls: it starts Python's side, and answers one message after the other."""

from __future__ import annotations

import json

from autograder.checks.runner import GraderError
from web.python.browser import watchdog
from web.python.browser.checks import check
from web.python.browser.folder import Folder
from web.python.browser.page import post
from web.python.browser.process import install_limits

folder = Folder()


def start() -> None:
    """Be ready for messages."""
    watchdog.install()
    install_limits()


def receive(text: str) -> None:
    """Answer a message of the page."""
    message = json.loads(text)
    try:
        post("report", report=check(message, folder))
    except (ValueError, OSError, GraderError) as error:
        post("failed", why=str(error))
