"""Detect whether a student has edited files that should stay unchanged, such as cloth.py.

The grader uses our own copies of these files and ignores the student's changes.
"""

from __future__ import annotations

from pathlib import Path

from autograder.handouts.lock import read_lock, stub_hash
from autograder.manifest import ROOT, Chapter


def changed_files(chapter: Chapter, engine: list[Path], root: Path = ROOT) -> list[Path]:
    """Return the files of a chapter that the student has edited but should have left unchanged.

    Each file is compared with its hash in stubs.lock. A file that is missing, or not listed there,
    does not count as changed.
    """
    locked, changed = read_lock(root), []
    for name in chapter.complete:
        file = engine[0] / chapter.name / name
        known = locked.get(f"chapters/{chapter.name}/{name}")
        if known and file.is_file():
            text = file.read_text(encoding="utf-8-sig", errors="replace")
            if stub_hash(text) != known:
                below = file.is_relative_to(Path.cwd())
                changed.append(file.relative_to(Path.cwd()) if below else file)
    return changed
