"""Copy a folder without its bytecode, and read the reference's files."""

from __future__ import annotations

import shutil
from pathlib import Path

from autograder.manifest import ROOT, load_chapters


def copy_tree(source: Path, target: Path) -> None:
    """Copy the contents of a folder into another folder, which may already exist."""
    shutil.copytree(
        source, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__")
    )


def reference(*chapters: str) -> dict[str, str]:
    """Return the reference's files for these chapters, keyed by path. By default, return all.

    Only the files that students hand in are included.
    """
    files = [
        f"{chapter.name}/{name}"
        for chapter in load_chapters()
        if not chapters or chapter.name in chapters
        for name in chapter.handed_in
    ]
    return {file: (ROOT / "solutions" / file).read_text(encoding="utf-8") for file in files}
