"""Decide whether the grader accepts a student's file.

The grader uses this module when it copies a submission, and the students' own commands use it
before they run the code. A file that would be rejected in grading is therefore rejected at home
too, in the same words.
"""

from __future__ import annotations

import difflib
import errno
import os
import re
import stat
from collections.abc import Iterable, Sequence
from pathlib import Path

from autograder.manifest import Chapter

LARGEST_FILE = 1_000_000  # bytes; the longest module of a chapter has about ten thousand
HARMLESS = re.compile(r"[\w .()+-]{1,80}")  # names that can be shown in a report
SIMILAR = 0.8  # least similarity, from 0 to 1; "vector (1).py" and "vector.py" have 0.82
LINKED_FOLDER = "its folder is a symbolic link"
# If one of these errors occurs, the machine is to blame and not the submission.
OURS = (errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.EIO, errno.ESTALE)


class NotTakenError(Exception):
    """Raised when a student's file or a whole submission is rejected.

    The message gives the reason as part of a sentence, such as "it is a symbolic link".
    """


def rejected_modules(chapters: Iterable[Chapter], engine: Sequence[Path]) -> dict[str, str]:
    """Find the files in a student's folders that the grader would reject.

    Python imports each module from the first folder of ``engine`` that contains it, so only that
    file is read.

    Returns:
        The names of the rejected modules, such as ch02_vectors.vector, each with the reason.
    """
    reasons = {}
    for chapter in chapters:
        for name in chapter.handed_in:
            try:
                _check(chapter, name, engine)
            except NotTakenError as error:
                reasons[module_of(chapter.name, name)] = rejection(chapter.name, name, error)
    return reasons


def _check(chapter: Chapter, name: str, engine: Sequence[Path]) -> None:
    """Raise NotTakenError if the grader would reject a file.

    A missing file is not rejected, unless a file with a similar name is in its place.
    """
    there: set[str] = set()
    for folder in (folder / chapter.name for folder in engine):
        names = {path.name for path in folder.iterdir()} if folder.is_dir() else set()
        if name in names:
            if folder.is_symlink():
                raise NotTakenError(LINKED_FOLDER)
            check_text(read_file(folder / name, LARGEST_FILE))
            return
        there |= names
    if error := renamed(chapter, name, there):
        raise error


def module_of(chapter: str, name: str) -> str:
    """Return the name under which a file is imported, such as ch02_vectors.vector."""
    return f"{chapter}.{name.removesuffix('.py')}"


def rejection(chapter: str, name: str, error: NotTakenError) -> str:
    """Return the sentence that tells a student why a file was rejected."""
    return f"{chapter}/{name} was rejected: {error}"


def check_text(content: bytes) -> bytes:
    """Make sure that a student's file is a text file, and return its contents unchanged.

    Raises:
        NotTakenError: It is not a text file.
    """
    try:
        content.decode()
    except UnicodeDecodeError as error:
        raise NotTakenError("it is not UTF-8: save it as UTF-8 in your editor") from error
    if b"\0" in content:
        raise NotTakenError("it contains NUL bytes: save it as UTF-8 in your editor")
    return content


def renamed(chapter: Chapter, file: str, there: Iterable[str]) -> NotTakenError | None:
    """Recognize a missing file under an almost correct name, such as "vector (1).py".

    ``there`` contains the names of the files in the chapter's folder. A file that belongs there
    under its own name, such as a given module, has not been renamed.

    Returns:
        The error that tells the student the right name, or None if no name is similar.
    """
    strange = {*there} - {*chapter.handed_in, *chapter.complete}
    ending = f".{file.rpartition('.')[2]}"
    alike = [n for n in sorted(strange) if n.endswith(ending) and HARMLESS.fullmatch(n)]
    for name in difflib.get_close_matches(file, alike, 1, SIMILAR):
        return NotTakenError(f"its name is '{name}', so rename it to {file}")
    return None


def read_file(path: Path, largest: int, what: str = "it") -> bytes:
    """Read a student's file, but only if it is a regular file of at most ``largest`` bytes.

    Error messages refer to the file as ``what``, for example "the zip".

    Raises:
        NotTakenError: The file is not a regular file, is too large, or cannot be read.
    """
    try:
        _check_kind(path.lstat(), largest, what)
        with open(path, "rb", opener=_open) as file:
            # We look again, since another file may have taken its place in the meantime.
            _check_kind(os.fstat(file.fileno()), largest, what)
            content = file.read(largest + 1)
    except OSError as error:
        if error.errno == errno.ELOOP:
            raise NotTakenError(f"{what} is a symbolic link") from error
        raise NotTakenError(f"{what} cannot be read: {cause(error)}") from error
    if len(content) > largest:
        raise too_large(what, largest)
    return content


def too_large(what: str, largest: int) -> NotTakenError:
    """Create the error for a student's file or zip that is larger than ``largest`` bytes."""
    return NotTakenError(f"{what} is larger than {largest:,} bytes")


def cause(error: OSError) -> str:
    """Return the reason why a student's file cannot be read, such as "Permission denied".

    The error is raised again if the submission is not to blame, for example because the grader has
    run out of memory.
    """
    if error.errno in OURS:
        raise error
    return error.strerror or type(error).__name__


def _open(path: str, flags: int) -> int:
    """Open a student's file without following a link or waiting for a pipe.

    A link could lead to a file outside the submission, and a pipe could keep the grader waiting
    forever.
    """
    return os.open(path, flags | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))


def _check_kind(status: os.stat_result, largest: int, what: str) -> None:
    if stat.S_ISLNK(status.st_mode):
        raise NotTakenError(f"{what} is a symbolic link")
    if stat.S_ISDIR(status.st_mode):
        raise NotTakenError(f"{what} is a folder")
    if not stat.S_ISREG(status.st_mode):
        raise NotTakenError(f"{what} is not a regular file")
    if status.st_size > largest:
        raise too_large(what, largest)
