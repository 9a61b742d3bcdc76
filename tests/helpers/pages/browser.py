"""A real browser for tests: Debian's Chromium, controlled by Playwright.

Where one of them is missing, a test is skipped, or fails if the environment variable CI is set.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from typing import Any

import pytest

COMMANDS = ("chromium-headless-shell", "chromium", "chromium-browser")
CHROMIUM = next(filter(None, map(shutil.which, COMMANDS)), "")


def missing() -> str:
    """Return the reason why no browser can be used here, or an empty string if one can."""
    try:
        import playwright  # noqa: F401
    except ImportError:
        return "Playwright is not installed (make test installs it)"
    return (
        ""
        if CHROMIUM
        else "there is no Chromium; on Debian: apt-get install chromium-headless-shell"
    )


def browser() -> Iterator[Any]:
    yield from launched()


def browser_alone() -> Iterator[Any]:
    """Yield a browser that can reach no other host than this machine, for a fixture."""
    yield from launched("--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1")


def launched(*arguments: str) -> Iterator[Any]:
    need(missing())
    from playwright.sync_api import sync_playwright

    with sync_playwright() as driver:
        # Chromium's sandbox needs rights that containers lack. It is not needed for our own pages.
        command = ["--no-sandbox", *arguments]
        opened = driver.chromium.launch(executable_path=CHROMIUM, args=command)
        yield opened
        opened.close()


def need(missing: str) -> None:
    """Skip the current test if something is missing. In CI, fail instead."""
    if missing:
        if os.environ.get("CI"):
            pytest.fail(missing)
        pytest.skip(missing)
