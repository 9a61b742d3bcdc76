"""Choose the sandbox for students' code, or refuse to grade a class without one."""

from __future__ import annotations

import os
from pathlib import Path

from autograder.isolation.probe import best_level, candidates, what_fails
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT

SAMPLE_CLASS = ROOT / "sample_class"


def choose_level(folder: Path, *, unsafe: bool) -> Level:
    """Choose the strongest sandbox for students' code that works on this machine.

    Without a sandbox, only the sample class may be graded, unless ``unsafe`` is set. Even then,
    student code never runs as root.

    Raises:
        ValueError: No sandbox works, and grading without one is not permitted.
    """
    level = best_level()
    if level.is_sandbox or folder.resolve() == SAMPLE_CLASS:
        return level
    if unsafe and os.geteuid() != 0:
        return level
    reasons = "; ".join(filter(None, map(what_fails, candidates())))
    no_sandbox = (
        "this machine has no sandbox for submissions (it needs Linux with Landlock on x86-64, or "
        "bubblewrap)"
    )
    tried = f". A test of this machine found: {reasons}" if reasons else ""
    if unsafe:
        raise ValueError(f"{no_sandbox}, and without one, student code never runs as root{tried}")
    raise ValueError(
        f"{no_sandbox}; to grade a class that you trust, add --unsafe-no-sandbox{tried}"
    )
