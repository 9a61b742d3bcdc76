"""Which walls stand on this machine, and whether a class may be graded behind them."""

from __future__ import annotations

import os
from pathlib import Path

from autograder.isolation.probe import best_level
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT

SAMPLE_CLASS = ROOT / "sample_class"


def choose_level(folder: Path, *, unsafe: bool) -> Level:
    """Return the walls that stand here. Raises ValueError where there are none, and must be."""
    level = best_level()
    if level.is_wall or folder.resolve() == SAMPLE_CLASS:
        return level
    if unsafe and os.geteuid() != 0:
        return level
    no_wall = (
        "there is no wall here to put around a submission (it takes Linux with Landlock on x86-64, "
        "or bubblewrap)"
    )
    if unsafe:
        raise ValueError(f"{no_wall}, and student code is not run as root without one")
    raise ValueError(f"{no_wall}; --unsafe-no-sandbox grades a class that you trust all the same")
