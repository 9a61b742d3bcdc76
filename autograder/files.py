"""Write files atomically, so that another program never reads a half-written file."""

from __future__ import annotations

import csv
import io
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path


def replace_bytes(path: Path, content: bytes) -> None:
    """Replace the contents of a file, or leave them untouched if anything goes wrong.

    A temporary file is moved into place, so the old contents survive a full disk or a kill. If
    ``path`` is a link, the file that it points to is replaced.
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
        temporary.unlink(missing_ok=True)
        raise


def replace_table(path: Path, rows: Iterable[Sequence[str]]) -> None:
    """Write a CSV file atomically. Characters that cannot be encoded are escaped."""
    text = io.StringIO(newline="")
    csv.writer(text).writerows(rows)
    replace_bytes(path, text.getvalue().encode("utf-8", errors="backslashreplace"))


def temporary_of(path: Path) -> Path:
    """Return the path of the temporary file that is written first and then moved to ``path``."""
    return path.with_name(path.name + ".tmp")


def is_new(folder: Path, first: Path) -> bool:
    """Return True if a folder is missing, or has at most an unfinished ``first`` file of a run."""
    return not folder.exists() or {*folder.iterdir()} <= {temporary_of(first)}


def from_here(path: Path) -> Path:
    """Return a path for people to read: relative to the working folder if it is inside."""
    return path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
