"""Write files in one step, so that no file is ever half written."""

from __future__ import annotations

import shutil
from pathlib import Path

LITTLE = 1_000_000  # bytes


def replace_bytes(path: Path, content: bytes) -> None:
    """Write a temporary file and move it into place.

    The old content stays if the program is killed or the disk is full. A link stays a link.
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
        error.filename = error.filename or str(path)  # it has none if the disk is full
        if temporary.exists():
            temporary.unlink()
        raise


def is_full(folder: Path) -> bool:
    """Return whether the disk of a folder has so little space left that programs fail."""
    return shutil.disk_usage(folder).free < LITTLE


def temporary_of(path: Path) -> Path:
    """Return the path of the file that is written before it is moved into place."""
    return path.with_name(path.name + ".tmp")


def is_new(folder: Path, first: Path) -> bool:
    """Return whether a folder is missing or empty, or a run was killed while it wrote ``first``."""
    return not folder.exists() or {*folder.iterdir()} <= {temporary_of(first)}
