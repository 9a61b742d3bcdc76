"""The reference's plots, drawn once for all tests of plots: that takes more than a minute."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def drawn(
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[Path, subprocess.CompletedProcess[str]]:
    """Where the reference's plots were drawn to, and how."""
    from drawn_plots import plot  # tests/ is on the path only once pytest is configured

    out = tmp_path_factory.mktemp("plots")
    done = plot("solutions", out, "2-8")
    assert done.returncode == 0, done.stdout + done.stderr
    return out, done
