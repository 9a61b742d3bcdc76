"""Read files in a zip that may contain anything, without extracting it to disk."""

from __future__ import annotations

import stat
import struct
import zipfile
import zlib
from pathlib import Path
from typing import IO

from autograder.accepted_files import NotTakenError

ENCRYPTED = 1 << 0  # the flag of an encrypted entry
DAMAGED = "the zip is damaged, or not an ordinary zip: zip the folder again"
# If a zip is damaged or has an unknown format, zipfile raises one of these exceptions.
UNREADABLE = (
    *(zipfile.BadZipFile, zlib.error, struct.error),
    *(EOFError, RuntimeError, ValueError, OverflowError),
)


def open_zip(source: Path | IO[bytes]) -> zipfile.ZipFile:
    """Open a zip, or raise NotTakenError if it is damaged."""
    try:
        return zipfile.ZipFile(source)
    except UNREADABLE as error:
        raise NotTakenError(DAMAGED) from error


def path_in_zip(entry: zipfile.ZipInfo) -> str:
    """Return the path of an entry with forward slashes, whichever tool wrote it."""
    # Some Windows tools write backslashes, and other tools begin paths with a dot.
    return entry.orig_filename.replace("\\", "/").removeprefix("./").removesuffix("/")


def is_folder(entry: zipfile.ZipInfo) -> bool:
    """Return True if an entry is a folder and not a file."""
    return entry.orig_filename.endswith(("/", "\\")) or stat.S_ISDIR(entry.external_attr >> 16)


def is_unsafe(name: str) -> bool:
    """Return True if a path is absolute, or could lead to a file outside the zip."""
    parts = name.removesuffix("/").split("/")
    return name[1:2] == ":" or any(part in ("", ".", "..") for part in parts)


def read_entry(file: zipfile.ZipFile, entry: zipfile.ZipInfo, largest: int) -> bytes:
    """Read a file of a zip into memory, or raise NotTakenError."""
    mode = entry.external_attr >> 16
    # Mode 0 is written by a system without modes.
    if is_folder(entry) or stat.S_IFMT(mode) not in (0, stat.S_IFREG):
        raise NotTakenError("it is not a regular file")
    if entry.flag_bits & ENCRYPTED:
        raise NotTakenError("it is encrypted in the zip: zip it without a password")
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise NotTakenError("it is compressed in an unusual way: make an ordinary zip")
    # Even an entry with little content can take long to decompress.
    if max(entry.file_size, entry.compress_size) > largest:
        raise NotTakenError(f"it is larger than {largest:,} bytes")
    try:
        with file.open(entry) as stream:
            content = stream.read(largest + 1)
        if len(content) != entry.file_size:
            raise zipfile.BadZipFile("shorter than the zip says")
    except UNREADABLE as error:
        raise NotTakenError("it is damaged in the zip: zip the folder again") from error
    return content
