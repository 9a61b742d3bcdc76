"""Find and read files in a zip that nobody vouches for.

The zipfile module believes a zip: of 20 MB it may build 400,000 objects, or spend seconds on one
field. Here the directory is read by hand, up to a limit, and a file is inflated up to a limit.
Nothing is ever extracted by name.
"""

from __future__ import annotations

import stat
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from autograder.submissions.folders import (
    DEEPEST,
    MOST_ENTRIES,
    Found,
    NotTakenError,
    is_skipped,
    read_file,
    refuse,
    refuse_all,
    too_large,
)

LARGEST_ZIP = 20_000_000  # bytes
# The three records of a zip: https://pkware.cachefly.net/webdocs/casestudies/APPNOTE.TXT,
# of which only what is used here is unpacked.
END = struct.Struct("<10x H LL 2x")
ENTRY = struct.Struct("<4s 4x HH 4x LLL HHH 4x LL")
HEADER = struct.Struct("<4s 22x HH")
LONGEST_COMMENT = 65_535
ENCRYPTED = 1 << 0  # a flag
STORED, DEFLATED = 0, 8  # methods
DAMAGED = "is damaged, or no ordinary zip: zip the folder again"
SPOILT = "it is damaged in the zip: zip the folder again"


@dataclass(frozen=True)
class Entry:
    """What a zip's directory says about a file."""

    name: str
    flags: int
    method: int
    crc: int
    packed: int
    size: int
    mode: int
    offset: int


def search_zip(path: Path, wanted: Mapping[str, Sequence[str]]) -> tuple[list[Found], list[str]]:
    """Find the wanted files of each chapter; return them and notes for the instructor.

    Raises NotTakenError where the zip as a whole cannot be taken.
    """
    data = read_file(path, LARGEST_ZIP, "the zip")
    found: dict[tuple[tuple[str, ...], str], Found] = {}
    doubtful: list[Found] = []
    for entry in _entries(data):
        # Some tools for Windows write backslashes, some others begin with a dot.
        name = entry.name.replace("\\", "/").removeprefix("./").removesuffix("/")
        *above, last = name.rsplit("/", 2)
        if last in wanted and stat.S_ISLNK(entry.mode):
            doubtful += refuse_all((last,), wanted[last], "its folder is a symbolic link")
        if not above or last not in wanted.get(above[-1], ()):
            continue
        if _is_unsafe(name):
            doubtful += refuse_all(
                (above[-1],), [last], "its path in the zip is absolute or has dots in it"
            )
        elif name.count("/") <= DEEPEST:
            *place, _ = name.split("/")
            if any(map(is_skipped, place)):
                continue
            key = (tuple(place), last)
            twice = key in found
            read = refuse("it is in the zip twice") if twice else partial(_read, data, entry)
            found[key] = Found(*key, read)
    return [*found.values(), *doubtful], []


def _entries(data: bytes) -> Iterator[Entry]:
    """Yield what a zip's directory lists; raise NotTakenError, maybe late, for a bad one."""
    end = data.rfind(b"PK\5\6", max(0, len(data) - END.size - LONGEST_COMMENT))
    if end < 0:
        raise NotTakenError(f"the zip {DAMAGED}")
    try:
        count, length, start = END.unpack_from(data, end)
        if count > MOST_ENTRIES:
            raise NotTakenError(f"the zip has more than {MOST_ENTRIES:,} files and folders in it")
        position = start
        for _ in range(count):
            magic, flags, method, crc, packed, size, *rest = ENTRY.unpack_from(data, position)
            name_length, extra_length, comment_length, attributes, offset = rest
            if magic != b"PK\1\2":
                raise NotTakenError(f"the zip {DAMAGED}")
            position += ENTRY.size
            name = data[position : position + name_length]
            # A chapter's name is ASCII, whatever the folders above it are written in.
            text = name.decode("utf-8", "surrogateescape")
            yield Entry(text, flags, method, crc, packed, size, attributes >> 16, offset)
            position += name_length + extra_length + comment_length
    except struct.error as error:
        raise NotTakenError(f"the zip {DAMAGED}") from error
    if not position == start + length <= end:
        raise NotTakenError(f"the zip {DAMAGED}")


def _is_unsafe(name: str) -> bool:
    """Say whether a path begins at a root or a drive, or has parts that are no names."""
    return name[1:2] == ":" or any(part in f"/{name}" for part in ("//", "/./", "/../"))


def _read(data: bytes, entry: Entry, largest: int) -> bytes:
    """Return the content of a regular file. Raises NotTakenError for anything else."""
    if stat.S_ISLNK(entry.mode):
        raise NotTakenError("it is a symbolic link")
    if entry.name.endswith(("/", "\\")) or stat.S_ISDIR(entry.mode):
        raise NotTakenError("it is a folder")
    if stat.S_IFMT(entry.mode) not in (0, stat.S_IFREG):  # 0: written by a system without modes
        raise NotTakenError("it is no regular file")
    if entry.flags & ENCRYPTED:
        raise NotTakenError("it is encrypted in the zip: zip it without a password")
    if entry.method not in (STORED, DEFLATED):
        raise NotTakenError("it is compressed in an unusual way: make an ordinary zip")
    # Deflating adds next to nothing, but can hide much work in what inflates to little.
    if entry.size > largest or entry.packed > largest + largest // 100:
        raise too_large("it", largest)
    try:
        content = _inflate(data, entry, largest)
    except (struct.error, zlib.error) as error:
        raise NotTakenError(SPOILT) from error
    if len(content) > largest:
        raise too_large("it", largest)
    if len(content) != entry.size or zlib.crc32(content) != entry.crc:
        raise NotTakenError(SPOILT)
    return content


def _inflate(data: bytes, entry: Entry, largest: int) -> bytes:
    """Return what an entry holds, of which there may be one byte more than allowed."""
    magic, name_length, extra_length = HEADER.unpack_from(data, entry.offset)
    if magic != b"PK\3\4":
        raise zlib.error("no header")
    start = entry.offset + HEADER.size + name_length + extra_length
    packed = data[start : start + entry.packed]
    if entry.method == STORED:
        return packed
    return zlib.decompressobj(-zlib.MAX_WBITS).decompress(packed, largest + 1)
