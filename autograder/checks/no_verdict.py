"""Explain why the check process ended before any check had a verdict."""

from __future__ import annotations

import re

# An earlier chapter that the student's folder does not have.
MISSING = re.compile(r"No module named '(ch\d\d_\w+)'")
# A check that imports something which tests/shared does not have, or no longer has.
GONE = re.compile(
    r"test module '.*?(\w+\.py)'.*cannot import name '(\w+)' from .*tests.shared.(\w+\.py)\)",
    re.DOTALL,
)


def why_no_verdict(stderr: str, chapter: str) -> str:
    """Return the reason in one line if it is a known one, or what the process wrote to stderr."""
    if missing := MISSING.search(stderr):
        return f"{missing[1]} is missing: put your own folder of that name beside {chapter}"
    if gone := GONE.search(stderr):
        file, name, helper = gone.groups()
        return (
            f"{file} imports {name}, but {helper} has no {name}. How a graded check is written "
            "today: tests/README.md"
        )
    words = stderr or "it printed nothing"
    if "INTERNALERROR>" in words:  # leave out pytest's own traceback
        words = words.rpartition("INTERNALERROR>")[2].strip()
    return f"the check process stopped without a verdict: {words}"
