"""Find and read a student's files in a submitted zip, without ever extracting it to disk.

The zip may contain anything, so it is not trusted.
"""

from __future__ import annotations

import io
import itertools
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from autograder.accepted_files import LINKED_FOLDER, NotTakenError, read_file, too_large
from autograder.submissions.folders import (
    DEEPEST,
    MOST_ENTRIES,
    Found,
    is_skipped,
    other_file,
    refuse,
    refuse_all,
)

# This limit is in bytes. A normal submission is well below 100,000. If somebody builds a zip of
# 5 MB to keep zipfile busy, it takes about 2 s, and a larger one would take proportionally longer.
LARGEST_ZIP = 5_000_000
MOST_ZIPS = 5  # we open no more than this many zips in one folder
ENCRYPTED = 1 << 0  # the flag of an encrypted entry
DAMAGED = "the zip is damaged, or not an ordinary zip: zip the folder again"
# If a zip is damaged or has an unknown format, zipfile raises one of these exceptions.
UNREADABLE = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    EOFError,
    RuntimeError,
    ValueError,
    OverflowError,
)


def search_zip(path: Path, wanted: Mapping[str, Sequence[str]]) -> tuple[list[Found], list[str]]:
    """Find the files to be graded in a student's submitted zip, with notes on any problems.

    ``wanted`` lists the files to look for in the folder of each chapter. The result also contains
    all other files, because a file that is missing there may be in a different folder.

    Raises:
        NotTakenError: The zip as a whole is rejected.
    """
    if path.lstat().st_size > LARGEST_ZIP:
        limit = f"the zip is larger than {LARGEST_ZIP:,} bytes"
        raise NotTakenError(f"{limit}: zip only the folders of the chapters")
    try:
        file = zipfile.ZipFile(io.BytesIO(read_file(path, LARGEST_ZIP, "the zip")))
    except UNREADABLE as error:
        raise NotTakenError(DAMAGED) from error
    if len(file.infolist()) > MOST_ENTRIES:
        raise NotTakenError(f"the zip contains more than {MOST_ENTRIES:,} files and folders")
    found: dict[tuple[tuple[str, ...], str], Found] = {}
    doubtful: list[Found] = []
    others: list[Found] = []
    for entry in file.infolist():
        name = path_in_zip(entry)
        *folders, last = name.split("/")
        place = tuple(folders)
        chapter = place[-1] if place else ""
        is_graded = last in wanted.get(chapter, ())
        if last in wanted and stat.S_ISLNK(entry.external_attr >> 16):
            doubtful += refuse_all((last,), wanted[last], LINKED_FOLDER)
        if is_unsafe(name):
            if is_graded:
                reason = "its path in the zip is absolute or has dots in it"
                doubtful += refuse_all((chapter,), [last], reason)
        elif len(place) > DEEPEST or any(map(is_skipped, place)):
            continue
        elif not is_graded:
            if not is_folder(entry):
                others.append(other_file(place, last))
        else:
            key = (place, last)
            twice = key in found
            read = refuse("it is in the zip twice") if twice else partial(read_entry, file, entry)
            found[key] = Found(*key, read)
    return [*found.values(), *doubtful, *others], []


def search_zips_in(
    folder: Path, wanted: Mapping[str, Sequence[str]]
) -> tuple[list[Found], list[str]]:
    """Find the files to be graded in the zips inside a student's submitted folder.

    Each zip is treated like a folder with the same contents. Return the files, with notes on any
    problems.
    """
    with os.scandir(folder) as entries:
        names = [
            entry.name
            for entry in itertools.islice(entries, MOST_ENTRIES)
            if entry.name.lower().endswith(".zip")
            and not is_skipped(entry.name)
            and entry.is_file(follow_symlinks=False)
        ]
    notes = [f"only {MOST_ZIPS} of {len(names)} zips were opened"] if names[MOST_ZIPS:] else []
    found: list[Found] = []
    for name in sorted(names)[:MOST_ZIPS]:
        try:
            inside, _ = search_zip(folder / name, wanted)
        except NotTakenError as error:
            notes.append(f"'{name}' was not opened: {error}")
            for chapter, files in wanted.items():
                found += refuse_all((name, chapter), files, str(error))
            continue
        found += [replace(one, place=(name, *one.place)) for one in inside]
    return found, notes


def path_in_zip(entry: zipfile.ZipInfo) -> str:
    """Return the path of a file in a submitted zip, with forward slashes between its parts.

    Some Windows tools write backslashes instead.
    """
    # Some Windows tools write backslashes, and other tools begin paths with a dot.
    return entry.orig_filename.replace("\\", "/").removeprefix("./").removesuffix("/")


def is_folder(entry: zipfile.ZipInfo) -> bool:
    """Return True if an entry of a submitted zip is a folder and not a file."""
    return entry.orig_filename.endswith(("/", "\\")) or stat.S_ISDIR(entry.external_attr >> 16)


def is_unsafe(name: str) -> bool:
    """Return True if a path in a submitted zip could lead to a file outside the zip.

    A path is unsafe if it is absolute, or if a part of it is empty, "." or "..".
    """
    parts = name.removesuffix("/").split("/")
    return name[1:2] == ":" or any(part in ("", ".", "..") for part in parts)


def read_entry(file: zipfile.ZipFile, entry: zipfile.ZipInfo, largest: int) -> bytes:
    """Read a file from a submitted zip into memory, and return its contents.

    Raises:
        NotTakenError: The file is not a regular file, is too large, or cannot be read.
    """
    mode = entry.external_attr >> 16
    if stat.S_ISLNK(mode):
        raise NotTakenError("it is a symbolic link")
    if is_folder(entry):
        raise NotTakenError("it is a folder")
    if stat.S_IFMT(mode) not in (0, stat.S_IFREG):  # 0: written by a system without modes
        raise NotTakenError("it is not a regular file")
    if entry.flag_bits & ENCRYPTED:
        raise NotTakenError("it is encrypted in the zip: zip it without a password")
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise NotTakenError("it is compressed in an unusual way: make an ordinary zip")
    # Even an entry with little content can take long to decompress.
    if max(entry.file_size, entry.compress_size) > largest:
        raise too_large("it", largest)
    try:
        with file.open(entry) as stream:
            content = stream.read(largest + 1)
        if len(content) != entry.file_size:
            raise zipfile.BadZipFile("shorter than the zip says")
    except UNREADABLE as error:
        raise NotTakenError("it is damaged in the zip: zip the folder again") from error
    return content
