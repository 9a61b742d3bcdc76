"""Find a student's files in a submitted folder, and read them without following links.

The folder may contain anything, so nothing in it is trusted.
"""

from __future__ import annotations

import itertools
import os
import stat
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from autograder.accepted_files import LINKED_FOLDER, NotTakenError, cause, read_file

DEEPEST = 3  # a chapter's folder may be at most this many levels below the submission
MOST_ENTRIES = 5_000  # we look at no more than this many files and folders of one submission


@dataclass(frozen=True)
class Found:
    """A file in a student's submission that may be graded.

    Attributes:
        place: The path of the file's folder as a tuple, such as ("work", "ch02_vectors").
        file: The name of the file.
        read: A function that returns the contents of the file. Its argument is the largest size to
            accept. It raises NotTakenError if the file is rejected.
        doubtful: True if the file is rejected because of a problem with its folder, such as a
            symbolic link. The file is ignored if the submission has another folder for the chapter.
        other: True if the grader expects no file of this name in this folder. The student may have
            renamed the file, or put it into the wrong folder.
    """

    place: tuple[str, ...]
    file: str
    read: Callable[[int], bytes]
    doubtful: bool = False
    other: bool = False


def search_folder(
    submission: Path, wanted: Mapping[str, Sequence[str]]
) -> tuple[list[Found], list[str]]:
    """Find the files to be graded in a student's submitted folder, with notes on any problems.

    ``wanted`` lists the files to look for in the folder of each chapter. The result also contains
    all other files, because a file that is missing there may be in a different folder.

    Raises:
        NotTakenError: The submission's folder cannot be read at all.
    """
    found: list[Found] = []
    notes: list[str] = []
    left = MOST_ENTRIES
    level: list[tuple[str, ...]] = [()]
    for depth in range(DEEPEST + 1):
        deeper: list[tuple[str, ...]] = []
        for place in level:
            folder = submission.joinpath(*place)
            if depth < DEEPEST:
                # By looking for a chapter's name, we find it among any number of other files.
                for chapter, files in wanted.items():
                    found += _search_chapter(folder / chapter, (*place, chapter), files)
            if left < 0:
                continue
            try:
                folders, names = _entries(folder, left + 1)
            except OSError as error:
                if not place:
                    raise NotTakenError(f"the submission cannot be read: {cause(error)}") from error
                notes.append(f"'{'/'.join(place)}' was not searched: {cause(error)}")
                continue
            left -= len(folders) + len(names)
            expected = wanted.get(place[-1], ()) if place else ()
            found += [other_file(place, name) for name in names if name not in expected]
            deeper += [(*place, name) for name in folders if not is_skipped(name)]
        level = deeper
    if left < 0:
        notes.append(f"the search stopped after {MOST_ENTRIES:,} files and folders")
        reason = f"it is not among the first {MOST_ENTRIES:,} files and folders handed in"
        for chapter, files in wanted.items():
            found += refuse_all((chapter,), files, reason)
    return found, notes


def refuse(reason: str) -> Callable[[int], bytes]:
    """Create a function that rejects a submitted file for the given reason.

    The function can serve as the ``read`` attribute of a ``Found``. It raises NotTakenError instead
    of returning the contents of the file.
    """

    def read(_: int) -> bytes:
        raise NotTakenError(reason)

    return read


def refuse_all(place: tuple[str, ...], files: Sequence[str], reason: str) -> list[Found]:
    """Reject all files expected in a chapter's folder, and return their records.

    The reason is usually a problem with the whole folder. For example, it may be unreadable or a
    symbolic link.
    """
    return [Found(place, file, refuse(reason), doubtful=True) for file in files]


def other_file(place: tuple[str, ...], name: str) -> Found:
    """Create a record of a submitted file that the grader does not expect in its folder.

    The grader uses such records to recognize files that the student has renamed or put into the
    wrong folder. It never reads these files.
    """
    return Found(place, name, refuse("it is not a file of this chapter"), other=True)


def is_skipped(name: str) -> bool:
    """Return True if a folder in a student's submission should be ignored.

    This is the case for hidden folders, and for folders that programs create, such as __MACOSX and
    __pycache__.
    """
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")


def _search_chapter(folder: Path, place: tuple[str, ...], files: Sequence[str]) -> list[Found]:
    """Find the files to be graded in a chapter's folder of a student's submission.

    Links are included in the result. They are rejected later, when the grader tries to read them.
    """
    found: list[Found] = []
    try:
        mode = _mode(folder)
        if stat.S_ISLNK(mode):
            return refuse_all(place, files, LINKED_FOLDER)
        if stat.S_ISDIR(mode):
            for file in files:
                if _mode(folder / file):
                    found.append(Found(place, file, partial(read_file, folder / file)))
    except OSError as error:
        reason = f"a folder of the submission cannot be read: {cause(error)}"
        return refuse_all(place, files, reason)
    return found


def _mode(path: Path) -> int:
    """Return the mode bits of a submitted file or folder, or 0 if it does not exist."""
    try:
        return path.lstat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return 0


def _entries(folder: Path, most: int) -> tuple[list[str], list[str]]:
    """List the folders and the files inside a submitted folder, reading at most ``most`` entries.

    A link counts as a file, whatever it leads to.
    """
    with os.scandir(folder) as entries:
        seen = list(itertools.islice(entries, most))
        folders = {entry.name for entry in seen if entry.is_dir(follow_symlinks=False)}
    return sorted(folders), sorted({entry.name for entry in seen} - folders)
