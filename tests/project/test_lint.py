"""Style, types and spelling, as `make lint` checks them."""

from __future__ import annotations

import subprocess

from autograder.manifest import ROOT


def test_make_lint_finds_nothing() -> None:
    done = subprocess.run(
        ["make", "lint"], cwd=ROOT, capture_output=True, encoding="utf-8", check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
