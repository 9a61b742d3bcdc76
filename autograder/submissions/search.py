"""Find a student's files in a submission, which is a folder, a zip, or a folder with zips in it.

The submission may contain anything, so no link is followed, and no zip is extracted to disk.
"""

from __future__ import annotations

import io
import os
import stat
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from autograder.accepted_files import LINKED_FOLDER, NotTakenError, cause, read_file
from autograder.submissions.zips import is_folder, is_unsafe, open_zip, path_in_zip, read_entry

DEEPEST = 3  # a chapter's folder may be at most this many levels below the submission
MOST_ENTRIES = 5_000  # we look at no more than this many files and folders of one submission
# This limit is in bytes. A normal submission is well below 100,000. If somebody builds a zip of
# 5 MB to keep zipfile busy, it takes about 2 s, and a larger one would take proportionally longer.
LARGEST_ZIP = 5_000_000
MOST_ZIPS = 5  # of one folder
Wanted = Mapping[str, Sequence[str]]  # the names of a chapter's files, by the name of its folder
Read = Callable[[int], bytes]  # reads so many bytes at most, or raises NotTakenError


@dataclass(frozen=True)
class Found:
    """A file in a student's submission.

    A doubtful one is rejected because of its folder, such as a symbolic link, and ignored if the
    submission has another folder for the chapter.
    """

    place: tuple[str, ...]  # the path of its folder, such as ("work", "ch02_vectors")
    file: str
    read: Read
    doubtful: bool = False
    other: bool = False  # no file of this name is wanted in this folder


def search(submission: Path, wanted: Wanted) -> tuple[list[Found], list[str]]:
    """Find files in chapters' folders, with notes, or raise NotTakenError if it is rejected."""
    try:
        mode = submission.lstat().st_mode
        if stat.S_ISLNK(mode):
            raise NotTakenError("the submission is a symbolic link")
        if stat.S_ISDIR(mode):
            return _search_folder(submission, wanted)
        return _search_zip(submission, wanted), []
    except OSError as error:
        raise NotTakenError(f"the submission cannot be read: {cause(error)}") from error


def refuse(reason: str) -> Read:
    """Return a function for ``Found.read`` that rejects the file."""

    def read(_: int) -> bytes:
        raise NotTakenError(reason)

    return read


def refuse_all(wanted: Wanted, reason: str, place: tuple[str, ...] = ()) -> list[Found]:
    """Reject all files of some chapters, in case they are in a place that cannot be read."""
    return [
        Found((*place, chapter), file, refuse(reason), doubtful=True)
        for chapter, files in wanted.items()
        for file in files
    ]


def is_hidden_or_cache(name: str) -> bool:
    """Return True if a folder is hidden, or one that programs create, such as __pycache__."""
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")


def _search_folder(submission: Path, wanted: Wanted) -> tuple[list[Found], list[str]]:
    """Search a folder level by level, and then the zips at its top."""
    found: list[Found] = []
    notes: list[str] = []
    zips: list[str] = []
    left = MOST_ENTRIES
    places: list[tuple[str, ...]] = [()]
    for place in places:  # which grows, so that each level is searched before the next
        chapters = wanted if len(place) < DEEPEST else {}
        own = {name: wanted[name] for name in place[-1:] if name in wanted}
        try:
            entries = sorted(os.scandir(submission.joinpath(*place)), key=lambda one: one.name)
            first = entries[: max(0, left + 1)]
            modes = {one.name: one.stat(follow_symlinks=False).st_mode for one in first}
        except OSError as error:
            if not place:
                raise
            notes.append(f"'{'/'.join(place)}' was not searched: {cause(error)}")
            reason = f"a folder of the submission cannot be read: {cause(error)}"
            found += refuse_all(chapters, reason, place) + refuse_all(own, reason, place[:-1])
            continue
        left -= len(modes)
        for name, mode in modes.items():
            read = partial(read_file, submission.joinpath(*place, name))
            found += _sort_out(place, name, mode, read, wanted)
            if is_hidden_or_cache(name):
                continue
            if stat.S_ISDIR(mode) and len(place) < DEEPEST:
                places.append((*place, name))
            elif not place and stat.S_ISREG(mode) and name.lower().endswith(".zip"):
                zips.append(name)
    if left < 0:
        notes.append(f"the search stopped after {MOST_ENTRIES:,} files and folders")
        reason = f"it is not among the first {MOST_ENTRIES:,} files and folders handed in"
        found += refuse_all(wanted, reason)
    if zips[MOST_ZIPS:]:
        notes.append(f"only {MOST_ZIPS} of {len(zips)} zips were opened")
    for name in zips[:MOST_ZIPS]:
        try:
            inside = _search_zip(submission / name, wanted)
        except NotTakenError as error:
            notes.append(f"'{name}' was not opened: {error}")
            inside = refuse_all(wanted, str(error))
        found += [replace(one, place=(name, *one.place)) for one in inside]
    return found, notes


def _search_zip(path: Path, wanted: Wanted) -> list[Found]:
    """Search a zip, or raise NotTakenError if the zip as a whole is rejected."""
    if path.lstat().st_size > LARGEST_ZIP:
        limit = f"the zip is larger than {LARGEST_ZIP:,} bytes"
        raise NotTakenError(f"{limit}: zip only the folders of the chapters")
    zipped = open_zip(io.BytesIO(read_file(path, LARGEST_ZIP, "the zip")))
    if len(zipped.infolist()) > MOST_ENTRIES:
        raise NotTakenError(f"the zip contains more than {MOST_ENTRIES:,} files and folders")
    found: dict[tuple[tuple[str, ...], str, bool], Found] = {}
    for entry in zipped.infolist():
        name = path_in_zip(entry)
        *folders, last = name.split("/")
        place = tuple(folders)
        if is_unsafe(name) or len(place) > DEEPEST or any(map(is_hidden_or_cache, place)):
            continue
        mode = stat.S_IFDIR if is_folder(entry) else entry.external_attr >> 16
        for one in _sort_out(place, last, mode, partial(read_entry, zipped, entry), wanted):
            key = one.place, one.file, one.doubtful
            twice = key in found
            found[key] = replace(one, read=refuse("it is in the zip twice")) if twice else one
    return [*found.values()]


def _sort_out(
    place: tuple[str, ...], name: str, mode: int, read: Read, wanted: Wanted
) -> list[Found]:
    """Return what is known of a file, link or folder, whether it is in a folder or in a zip."""
    found = []
    if stat.S_ISLNK(mode) and name in wanted and len(place) < DEEPEST:
        found += refuse_all({name: wanted[name]}, LINKED_FOLDER, place)
    if place and name in wanted.get(place[-1], ()):
        found.append(Found(place, name, read))
    elif not stat.S_ISDIR(mode):
        found.append(Found(place, name, refuse("it is not a file of this chapter"), other=True))
    return found
