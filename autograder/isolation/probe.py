"""Test which layers of the sandbox for student code work on this machine.

To find out, a process inside the sandbox tries forbidden operations, such as reading a file.
"""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path
from typing import NoReturn

from autograder.isolation.handles import WorkerFailure
from autograder.isolation.sandbox import Level, landlock_version, seccomp_works_here
from autograder.isolation.template import Template, TemplateError

# The operations that each layer must prevent.
HELD_BY_LANDLOCK = ("reading a file", "writing a file")
HELD_BY_SECCOMP = ("reaching the network", "starting a process", "sending a signal")
HELD_BY_BUBBLEWRAP = ("reading a file", "writing a file", "reaching the network")


def best_level() -> Level:
    """Find the strongest sandbox for student code that passes a test on this machine.

    The test tries the operations that a sandbox should prevent, such as reading a file.
    """
    return next((level for level in candidates() if not what_fails(level)), Level())


def candidates() -> list[Level]:
    """List the sandboxes for student code that this machine might support, strongest first."""
    inside = Level(landlock=landlock_version() > 0, seccomp=seccomp_works_here())
    around = Level(inside.landlock, inside.seccomp, bubblewrap=True)
    found = [around, inside] if shutil.which("bwrap") else [inside]
    return [level for level in found if level.is_sandbox]


def what_fails(level: Level) -> str:
    """Test a sandbox by trying forbidden operations in it, and report those that succeed.

    The operations include reading a file and reaching the network.

    Returns:
        A text such as "it does not prevent writing a file", or the reason why the sandbox cannot be
        started. If the sandbox passes the test, the text is empty.
    """
    attempts = [
        *(HELD_BY_LANDLOCK if level.landlock else ()),
        *(HELD_BY_SECCOMP if level.seccomp else ()),
        *(HELD_BY_BUBBLEWRAP if level.bubblewrap else ()),
    ]
    with tempfile.TemporaryDirectory(prefix="walls-") as folder:
        forbidden, own = Path(folder) / "forbidden", Path(folder) / "own"
        forbidden.touch()
        own.mkdir()
        template = Template(level, [], str(own), own, 5.0)
        try:
            session = template.start_worker(_no_answer)
            through: list[str] = session.ask("test_walls", attempts, str(forbidden))
            return f"it does not prevent {', '.join(through)}" if through else ""
        except (TemplateError, WorkerFailure) as error:
            return str(error) or type(error).__name__
        finally:
            template.close()


def _no_answer() -> NoReturn:
    raise TemplateError("the test of the sandbox does not answer")
