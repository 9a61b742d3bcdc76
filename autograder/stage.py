"""Copy what a submission may contain into a folder of our own: nothing else is ever imported."""

from __future__ import annotations

import shutil
from pathlib import Path

from autograder.manifest import ROOT, Chapter

LARGEST_FILE = 1_000_000  # bytes; a chapter's longest module has about ten thousand


def stage(submission: Path, chapters: list[Chapter], box: Path, root: Path = ROOT) -> None:
    """Fill the box with an engine: the student's edited files, and the parts nobody edits.

    A file that is missing, linked, no regular file or too large is left out; its import then says
    that it was not handed in. Nothing falls back on the stubs or on the solutions.
    """
    for chapter in chapters:
        target = box / chapter.name
        target.mkdir(parents=True)
        for name in chapter.complete:
            shutil.copyfile(root / "chapters" / chapter.name / name, target / name)
        for name in chapter.edited_files:
            file = submission / chapter.name / name
            linked = file.is_symlink() or file.parent.is_symlink()
            if file.is_file() and not linked and file.stat().st_size <= LARGEST_FILE:
                shutil.copyfile(file, target / name)
