"""Record the conditions under which a class is graded, such as the checks and the seed.

As long as they stay the same, a student's report is valid and can be reused in a later run.
"""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Iterable
from pathlib import Path

from autograder.checks.arrange import shared_by_checks
from autograder.grader.assignment import Assignment
from autograder.manifest import ROOT, load_chapters
from autograder.reports.report import RunKey


def run_key(assignment: Assignment) -> RunKey:
    """Describe everything that a student's report depends on, apart from the submission itself.

    That includes the checks, the grader and the seed. If any of them changes, the report is no
    longer valid.
    """
    root = assignment.root
    names = [chapter.name for chapter in load_chapters(root)]
    checks = shared_by_checks(root)
    for name in names:
        checks += [*(root / "tests" / name).glob("*.py"), *(root / "solutions" / name).glob("*.py")]
        checks += [*(root / "chapters" / name).glob("*.toml")]
        checks += [*(root / "chapters" / name).rglob("*.py")]  # given modules, too
    if assignment.hidden:
        checks += assignment.hidden.rglob("*.py")
    return RunKey(
        seed=assignment.seed,
        chapters=[chapter.number for chapter in assignment.chapters],
        points={e.id: e.points for chapter in assignment.chapters for e in chapter.exercises},
        extra=[e.id for chapter in assignment.chapters for e in chapter.exercises if e.extra],
        given=[chapter.number for chapter in assignment.given],
        earlier=dict(assignment.earlier),
        checks=_digest(checks),
        grader=grader_digest(),
        python=platform.python_version(),
        level=vars(assignment.level),
        time_limit=assignment.time_limit,
    )


def grader_digest() -> str:
    """Compute a digest of the autograder's source code.

    The digest changes with every edit, so reports from another version of the autograder are not
    reused.
    """
    return _digest((ROOT / "autograder").rglob("*.py"))


def _digest(files: Iterable[Path]) -> str:
    digest = hashlib.sha256()
    for file in sorted(files):
        content = file.read_bytes()
        digest.update(f"{file.parent.name}/{file.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()
