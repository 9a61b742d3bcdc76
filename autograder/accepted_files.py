"""Decide whether the grader accepts a student's file.

Students' own commands use it too, so a file is rejected at home in the same words as in grading.
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
    """Raised if a file or a submission is rejected, with a reason such as "it is a folder"."""


def rejected_modules(chapters: Iterable[Chapter], engine: Sequence[Path]) -> dict[str, str]:
    """Return the modules in a student's folders that would be rejected, each with the reason."""
    reasons = {}
    for chapter in chapters:
        folders = [folder / chapter.name for folder in engine]
        names = {f: {path.name for path in f.iterdir()} if f.is_dir() else set() for f in folders}
        for name in chapter.handed_in:
            # Python imports a module from the first folder that has it.
            folder = next((folder for folder in folders if name in names[folder]), None)
            try:
                if folder is None:
                    refuse_renamed(chapter, name, set().union(*names.values()))
                elif folder.is_symlink():
                    raise NotTakenError(LINKED_FOLDER)
                else:
                    check_text(read_file(folder / name, LARGEST_FILE))
            except NotTakenError as error:
                reasons[module_of(chapter.name, name)] = rejection(chapter.name, name, error)
    return reasons


def module_of(chapter: str, name: str) -> str:
    """Return the name under which a file is imported, such as ch02_vectors.vector."""
    return f"{chapter}.{name.removesuffix('.py').replace('/', '.')}"


def rejection(chapter: str, name: str, error: NotTakenError) -> str:
    """Return the sentence that tells a student why a file was rejected."""
    return f"{chapter}/{name} was rejected: {error}"


def check_text(content: bytes) -> bytes:
    """Return the contents of a file unchanged, or raise NotTakenError if they are not text."""
    try:
        content.decode()
    except UnicodeDecodeError as error:
        raise NotTakenError("it is not UTF-8: save it as UTF-8 in your editor") from error
    if b"\0" in content:
        raise NotTakenError("it contains NUL bytes: save it as UTF-8 in your editor")
    return content


def refuse_renamed(chapter: Chapter, file: str, there: Iterable[str]) -> None:
    """Raise NotTakenError if a file in a chapter's folder seems to be ``file``, renamed."""
    strange = {*there} - {*chapter.handed_in, *chapter.complete}
    ending = f".{file.rpartition('.')[2]}"
    alike = [n for n in sorted(strange) if n.endswith(ending) and HARMLESS.fullmatch(n)]
    for name in difflib.get_close_matches(file, alike, 1, SIMILAR):
        raise NotTakenError(f"its name is '{name}', so rename it to {file}")


def read_file(path: Path, largest: int, what: str = "it") -> bytes:
    """Read a student's file, which errors call ``what``, without following a link."""
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
        raise NotTakenError(f"{what} is larger than {largest:,} bytes")
    return content


def cause(error: OSError) -> str:
    """Return the reason why a student's file is unreadable. If it is our fault, raise the error."""
    if error.errno in OURS:
        raise error
    return error.strerror or type(error).__name__


def _open(path: str, flags: int) -> int:
    """Open a file, but no link, which could lead out, and no pipe, which could wait forever."""
    return os.open(path, flags | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))


def _check_kind(status: os.stat_result, largest: int, what: str) -> None:
    kind = stat.S_IFMT(status.st_mode)
    if kind != stat.S_IFREG:
        kinds = {stat.S_IFLNK: "a symbolic link", stat.S_IFDIR: "a folder"}
        raise NotTakenError(f"{what} is {kinds.get(kind, 'not a regular file')}")
    if status.st_size > largest:
        raise NotTakenError(f"{what} is larger than {largest:,} bytes")
