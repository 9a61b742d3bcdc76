"""Start Python in a web worker, and answer the page's messages one at a time."""

from __future__ import annotations

import json
import os
from typing import Any

from autograder.checks.runner import GraderError
from autograder.diagnosis.explain import explain_hang
from autograder.manifest import ROOT
from lab.broken_off import FIRST_LIMIT, TIME_LIMIT, why_it_broke_off
from web.python.browser.checks import check
from web.python.browser.folder import Folder
from web.python.browser.page import post
from web.python.browser.process import compile_once, install_limits
from web.python.browser.scenes import Link
from web.python.browser.trying import try_line
from web.python.browser.watchdog import watchdog

folder = Folder()
links: dict[int, Link] = {}


def start() -> None:
    """Prepare Python for student code. Send what the page shows when Python no longer answers."""
    os.chdir(ROOT)
    watchdog.install()
    install_limits()
    compile_once()
    post(
        "ready",
        left=why_it_broke_off("", []),
        limits={"load": FIRST_LIMIT, "other": TIME_LIMIT},
        hung={
            "load": str(explain_hang("", FIRST_LIMIT, [])),
            "other": str(explain_hang("", TIME_LIMIT, [])),
        },
    )


def receive(text: str) -> None:
    """Answer a message from the page, such as a request to check an exercise."""
    message = json.loads(text)
    try:
        _answer(message)
    except (ValueError, OSError, GraderError) as error:
        post("failed", why=str(error))


def _answer(message: dict[str, Any]) -> None:
    match message:
        case {"kind": "check"}:
            post("report", report=check(message, folder))
        case {"kind": "try"}:
            post("tried", **try_line(message, folder))
        case {"kind": "scene", "link": int(number), "message": dict(asked)}:
            link = links.setdefault(number, Link(folder))
            post("answers", answers=link.receive(asked))
        case {"kind": "close", "link": int(number)}:
            if number in links:
                links.pop(number).close()
        case _:
            raise ValueError(f"unknown kind of message: {message!r:.200}")
