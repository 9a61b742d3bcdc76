"""Write files atomically, so that another program never reads a half-written file."""

from __future__ import annotations

import shutil
from pathlib import Path

LITTLE = 1_000_000  # bytes


def replace_bytes(path: Path, content: bytes) -> None:
    """Replace the content of a file, or leave the file as it was if anything goes wrong.

    We write the new content to a temporary file first and then move that file into place. If the
    disk is full or the program is killed in between, the old content is still there. If ``path`` is
    a link, we replace the file that it points to.
    """
    path = path.resolve()
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = temporary_of(path)
    try:
        temporary.write_bytes(content)
        if path.exists():
            shutil.copymode(path, temporary)
        temporary.replace(path)
    except OSError as error:
        error.filename = error.filename or str(path)  # the error lacks it if the disk is full
        if temporary.exists():
            temporary.unlink()
        raise


def is_full(folder: Path) -> bool:
    """Return whether the disk has so little space left (under 1 MB) that programs may fail."""
    return shutil.disk_usage(folder).free < LITTLE


def temporary_of(path: Path) -> Path:
    """Return the path at which ``replace_bytes`` first writes the new content of a file."""
    return path.with_name(path.name + ".tmp")


def is_new(folder: Path, first: Path) -> bool:
    """Return whether a folder for results is missing or empty, so that a run can start there.

    Every run writes the file ``first`` before any other. If the folder contains only an unfinished
    copy of this file, an earlier run was killed right at its beginning, and the folder counts as
    empty.
    """
    return not folder.exists() or {*folder.iterdir()} <= {temporary_of(first)}
