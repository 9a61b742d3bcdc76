"""Run a command of lab/ or plots/ in a new process, with less to draw than students get."""

from __future__ import annotations

import json
import os
import subprocess
import sys

from autograder.manifest import ROOT

PROGRAM = """
import json, sys
from importlib import import_module

package, arguments, settings, only = json.loads(sys.argv[1])
sys.argv = [package, *arguments]
for name, value in settings.items():
    record = import_module("lab.record")
    assert hasattr(record, name), name
    setattr(record, name, value)
if only:
    plots = import_module("plots.draw")
    draw = plots.draw
    plots.draw = lambda plot, folder: plot.__name__ not in only or draw(plot, folder)
sys.exit(import_module(f"{package}.__main__").main())
"""


def study(
    *arguments: str,
    package: str,
    settings: dict[str, int] | None = None,
    only: tuple[str, ...] = (),
) -> subprocess.CompletedProcess[str]:
    """Run a package with these arguments, as `python -m` does.

    ``settings`` replaces constants of lab.record, and ``only`` leaves a chapter's other plots out.
    """
    request = json.dumps([package, arguments, settings or {}, only])
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, request],
        cwd=ROOT,
        env=os.environ | {"MPLBACKEND": "Agg"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
