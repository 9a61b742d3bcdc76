"""Find the strongest sandbox for student code that works on this machine.

To test a sandbox, a process inside it tries forbidden operations, such as reading a file.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from typing import NoReturn

from autograder.isolation.handles import WorkerFailure
from autograder.isolation.launcher import Launcher, LauncherError
from autograder.isolation.sandbox import Level, landlock_version, seccomp_works_here
from autograder.manifest import ROOT

SAMPLE_CLASS = ROOT / "sample_class"
# The operations that each layer must prevent.
HELD_BY_LANDLOCK = ("reading a file", "writing a file")
HELD_BY_SECCOMP = ("reaching the network", "starting a process", "sending a signal")
HELD_BY_BUBBLEWRAP = ("reading a file", "writing a file", "reaching the network")


def choose_level(folder: Path, *, unsafe: bool) -> Level:
    """Choose the sandbox for the submissions in a folder, or raise ValueError if there is none.

    Without a sandbox, only the sample class may be graded, unless ``unsafe`` is set. Even then,
    student code never runs as root.
    """
    level = best_level()
    sample = folder.resolve() == SAMPLE_CLASS
    if level.is_sandbox or sample or (unsafe and os.geteuid() != 0):
        return level
    why = "this machine has no sandbox for submissions (it needs Linux with Landlock on x86-64, or "
    why += "bubblewrap)"
    if unsafe:
        why += ", and without one, student code never runs as root"
    else:
        why += "; to grade a class that you trust, add --unsafe-no-sandbox"
    if reasons := "; ".join(filter(None, map(what_fails, candidates()))):
        why += f". A test of this machine found: {reasons}"
    raise ValueError(why)


def best_level() -> Level:
    """Return the strongest sandbox that passes a test on this machine."""
    return next((level for level in candidates() if not what_fails(level)), Level())


def candidates() -> list[Level]:
    """List the sandboxes that this machine might support, strongest first."""
    inside = Level(landlock=landlock_version() > 0, seccomp=seccomp_works_here())
    around = Level(inside.landlock, inside.seccomp, bubblewrap=True)
    found = [around, inside] if shutil.which("bwrap") else [inside]
    return [level for level in found if level.is_sandbox]


def what_fails(level: Level) -> str:
    """Say which forbidden operations succeed in a sandbox, or why it does not start, or nothing."""
    attempts = [
        *(HELD_BY_LANDLOCK if level.landlock else ()),
        *(HELD_BY_SECCOMP if level.seccomp else ()),
        *(HELD_BY_BUBBLEWRAP if level.bubblewrap else ()),
    ]
    with tempfile.TemporaryDirectory(prefix="walls-") as folder:
        forbidden, own = Path(folder) / "forbidden", Path(folder) / "own"
        forbidden.touch()
        own.mkdir()
        launcher = Launcher(level, [], str(own), 5.0)
        try:
            session = launcher.start_worker(_no_answer)
            through: list[str] = session.ask("test_walls", attempts, str(forbidden))
            return f"it does not prevent {', '.join(through)}" if through else ""
        except (LauncherError, WorkerFailure) as error:
            return str(error) or type(error).__name__
        finally:
            launcher.close()


def _no_answer() -> NoReturn:
    raise LauncherError("the test of the sandbox does not answer")
