"""Search an untrusted folder, and read files from it without following links."""

from __future__ import annotations

import errno
import itertools
import os
import stat
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

# Errors that are caused by the machine rather than the submission. The grader is at fault.
OURS = (errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.EIO, errno.ESTALE)
DEEPEST = 3  # levels below the submission at which a chapter's folder is found
MOST_ENTRIES = 5_000  # that are searched in one submission


class NotTakenError(Exception):
    """Raised when a file or a whole submission is rejected.

    The text is a clause with the reason.
    """


@dataclass(frozen=True)
class Found:
    """A file of a chapter that was found in a submission.

    ``place`` lists the folders that lead to the file, of which the last is the chapter's own.
    ``read`` takes the maximum size, and returns the content or raises NotTakenError. A ``doubtful``
    file is in a folder that cannot be read. It counts only if no other file was found.
    """

    place: tuple[str, ...]
    file: str
    read: Callable[[int], bytes]
    doubtful: bool = False


def search_folder(
    submission: Path, wanted: Mapping[str, Sequence[str]]
) -> tuple[list[Found], list[str]]:
    """Find the wanted files of each chapter. Return them with notes for the instructor.

    Raises:
        NotTakenError: The submission's folder cannot be read at all.
    """
    found: list[Found] = []
    notes: list[str] = []
    left = MOST_ENTRIES
    level: list[tuple[str, ...]] = [()]
    for depth in range(1, DEEPEST + 1):
        deeper: list[tuple[str, ...]] = []
        for place in level:
            folder = submission.joinpath(*place)
            # Look chapters up by name, so that they are found among any number of other files.
            for chapter, files in wanted.items():
                found += _search_chapter(folder / chapter, (*place, chapter), files)
            if depth == DEEPEST or left < 0:
                continue
            try:
                names, seen = _subfolders(folder, left + 1)
            except OSError as error:
                if not place:
                    raise NotTakenError(f"the submission cannot be read: {cause(error)}") from error
                notes.append(f"'{'/'.join(place)}' was not searched: {cause(error)}")
                continue
            left -= seen
            deeper += [(*place, name) for name in names]
        level = deeper
    if left < 0:
        notes.append(f"the search stopped after {MOST_ENTRIES:,} files and folders")
        reason = f"it is not among the first {MOST_ENTRIES:,} files and folders handed in"
        for chapter, files in wanted.items():
            found += refuse_all((chapter,), files, reason)
    return found, notes


def read_file(path: Path, largest: int, what: str = "it") -> bytes:
    """Return the content of a regular file that has at most ``largest`` bytes.

    ``what`` is the subject of the sentence in error messages.

    Raises:
        NotTakenError: The file is too large, or it is a link, a pipe or something else.
    """
    try:
        _check_kind(path.lstat(), largest, what)
        with open(path, "rb", opener=_open) as file:
            # Another file may have taken its place.
            _check_kind(os.fstat(file.fileno()), largest, what)
            content = file.read(largest + 1)
    except OSError as error:
        if error.errno == errno.ELOOP:
            raise NotTakenError(f"{what} is a symbolic link") from error
        raise NotTakenError(f"{what} cannot be read: {cause(error)}") from error
    if len(content) > largest:
        raise too_large(what, largest)
    return content


def refuse(reason: str) -> Callable[[int], bytes]:
    """Return a function that raises NotTakenError with this reason, to be used as ``read``."""

    def read(_: int) -> bytes:
        raise NotTakenError(reason)

    return read


def refuse_all(place: tuple[str, ...], files: Sequence[str], reason: str) -> list[Found]:
    """Return an entry for each of the files in a folder that cannot be read."""
    return [Found(place, file, refuse(reason), doubtful=True) for file in files]


def too_large(what: str, largest: int) -> NotTakenError:
    """Return the exception for a file or an archive of more than ``largest`` bytes."""
    return NotTakenError(f"{what} is larger than {largest:,} bytes")


def is_skipped(name: str) -> bool:
    """Return whether a folder is hidden, or was created by an operating system for its own use."""
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")


def _search_chapter(folder: Path, place: tuple[str, ...], files: Sequence[str]) -> list[Found]:
    """Return those of the wanted files that exist in a chapter's folder, whatever their type."""
    found: list[Found] = []
    try:
        mode = _mode(folder)
        if stat.S_ISLNK(mode):
            return refuse_all(place, files, "its folder is a symbolic link")
        if stat.S_ISDIR(mode):
            for file in files:
                if _mode(folder / file):
                    found.append(Found(place, file, partial(read_file, folder / file)))
    except OSError as error:
        reason = f"a folder of the submission cannot be read: {cause(error)}"
        return refuse_all(place, files, reason)
    return found


def _mode(path: Path) -> int:
    """Return the mode of a path, or 0 if the path does not exist."""
    try:
        return path.lstat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return 0


def _subfolders(folder: Path, most: int) -> tuple[list[str], int]:
    """Return the folders among the first ``most`` entries, and the number of entries examined."""
    with os.scandir(folder) as entries:
        seen = list(itertools.islice(entries, most))
        names = [entry.name for entry in seen if entry.is_dir(follow_symlinks=False)]
    return sorted(name for name in names if not is_skipped(name)), len(seen)


def _open(path: str, flags: int) -> int:
    """Open a file. Do not follow a link, and do not wait for a pipe."""
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


def cause(error: OSError) -> str:
    """Return the reason why something cannot be read.

    If the grader is at fault, raise the error.
    """
    if error.errno in OURS:
        raise error
    return error.strerror or type(error).__name__
