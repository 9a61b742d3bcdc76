"""Write files atomically, so that another program never reads a half-written file."""

from __future__ import annotations

import shutil
from pathlib import Path

LITTLE = 1_000_000  # bytes


def replace_bytes(path: Path, content: bytes) -> None:
    """Replace the content of the file ``path`` with ``content``.

    The content is first written to a temporary file, which is then moved to ``path``. If the
    program is killed or the disk is full, the old content remains. If ``path`` is a link, the file
    that it points to is replaced.
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
    """Return whether the disk of ``folder`` has so little free space that programs may fail."""
    return shutil.disk_usage(folder).free < LITTLE


def temporary_of(path: Path) -> Path:
    """Return the path of the temporary file that is later moved to ``path``."""
    return path.with_name(path.name + ".tmp")


def is_new(folder: Path, first: Path) -> bool:
    """Return whether ``folder`` is missing or empty.

    A run writes the file ``first`` before any other. If a run was killed while it wrote ``first``,
    the folder counts as empty.
    """
    return not folder.exists() or {*folder.iterdir()} <= {temporary_of(first)}
