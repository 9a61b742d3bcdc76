"""Copy a folder without its bytecode, read the reference's files, and edit a file."""

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
    """Return the files that students hand in, from the reference, keyed by path."""
    files = [
        f"{chapter.name}/{name}"
        for chapter in load_chapters()
        if not chapters or chapter.name in chapters
        for name in chapter.handed_in
    ]
    return {file: (ROOT / "solutions" / file).read_text(encoding="utf-8") for file in files}


def edit(file: Path, *changes: str) -> str:
    """Replace texts in a file, old and new ones in turn. Return the new text."""
    text = file.read_text(encoding="utf-8")
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        assert old in text
        text = text.replace(old, new)
    file.write_text(text, encoding="utf-8")
    return text
