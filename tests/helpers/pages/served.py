"""Serve a local page from a separate process, for tests."""

from __future__ import annotations

import contextlib
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from autograder.manifest import ROOT


@contextlib.contextmanager
def served(*options: str, engine: str = "solutions") -> Iterator[str]:
    """Serve the lab and yield its address, which ends with a slash."""
    with started("lab", "serve", "--no-browser", "--engine", engine, *options) as address:
        yield address


@contextlib.contextmanager
def marking(submissions: Path, chapters: str, *more: str) -> Iterator[str]:
    """Serve the marking page of a class, and yield its address, which ends with a slash."""
    options = ("--chapters", chapters, "--no-browser", *more)
    with started("autograder", "mark", str(submissions), *options) as address:
        yield address


@contextlib.contextmanager
def started(*command: str) -> Iterator[str]:
    """Run one of our modules that serves a page, and yield the first address that it prints."""
    process = subprocess.Popen(
        [sys.executable, "-m", *command], cwd=ROOT, stdout=subprocess.PIPE, encoding="utf-8"
    )
    try:
        assert process.stdout is not None
        found = re.search(r"http://\S*", process.stdout.readline())
        assert found
        yield found[0]
    finally:
        process.terminate()
        process.wait()
        process.stdout.close()
