"""Make submissions as folders and zips, stage them, and describe the outcome."""

from __future__ import annotations

import io
import os
import struct
import tempfile
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import ROOT, load_chapters
from autograder.submissions.stage import stage

CHAPTERS = load_chapters()[:2]
OF_CH02, OF_CH03 = (
    [f"{chapter.name}/{file}" for file in chapter.edited_files] for chapter in CHAPTERS
)
EDITED = OF_CH02 + OF_CH03
VECTOR, EXERCISES = "ch02_vectors/vector.py", "ch02_vectors/exercises.py"
CODE = b"x = 1\n"
HandIn = Callable[[dict[str, bytes]], Path]
# The files that were taken, the reasons why others were not, and the notes.
Outcome = tuple[dict[str, bytes], dict[str, str], list[str]]
TAKEN: Outcome = ({VECTOR: CODE}, {}, [])
NOTHING: Outcome = ({}, {}, [])
LINKED: Outcome = ({}, dict.fromkeys(OF_CH02, "its folder is a symbolic link"), [])

LINK = "it is a symbolic link"
NO_FILE = "it is not a regular file"
FOLDER = "it is a folder"
TOO_LARGE = "it is larger than 1,000,000 bytes"
NO_UTF8 = "it is not UTF-8: save it as UTF-8 in your editor"
DENIED = "Permission denied"
UNSEARCHED = f"was not searched: {DENIED}"
UNREAD = "a folder of the submission cannot be read"
UNKNOWN = f"{UNREAD}: {DENIED}"  # its content is unknown
GONE = "No such file or directory"
UNUSUAL = "it is compressed in an unusual way: make an ordinary zip"
SPOILT = "it is damaged in the zip: zip the folder again"
DAMAGED = "the zip is damaged, or not an ordinary zip: zip the folder again"
CROWDED = "the zip contains more than 5,000 files and folders"

posix = pytest.mark.skipif(os.name != "posix", reason="only POSIX has modes, pipes and such names")


def only(why: str) -> Outcome:
    """Return the outcome for a submission whose only file was rejected."""
    return {}, {VECTOR: why}, []


def refused(why: str) -> Outcome:
    """Return the outcome for a submission that was rejected as a whole, with a note on it."""
    return {}, dict.fromkeys(EDITED, why), [f"nothing was taken: {why}"]


def boxed(submission: Path, root: Path = ROOT) -> Outcome:
    """Copy a submission into a new box with ``stage``, and return the outcome."""
    box = Path(tempfile.mkdtemp(dir=submission.parent, prefix=".box-"))
    staged = stage(submission, CHAPTERS, box, root)
    files = {str(p.relative_to(box)): p.read_bytes() for p in box.rglob("*") if p.is_file()}
    for chapter in CHAPTERS:
        for name in chapter.complete:
            ours = (root / "chapters" / chapter.name / name).read_bytes()
            assert files.pop(f"{chapter.name}/{name}") == ours
    missing = {}
    for module, sentence in staged.rejected.items():
        file, why = f"{module.replace('.', '/')}.py", sentence
        if module not in staged.misplaced:
            start, why = sentence.split(" was rejected: ")
            assert start == file
        missing[file] = why
    return files, missing, staged.notes


def make_folder(folder: Path, files: dict[str, bytes]) -> Path:
    (folder / "ann").mkdir(exist_ok=True)
    for name, content in files.items():
        (folder / "ann" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "ann" / name).write_bytes(content)
    return folder / "ann"


def make_zip(folder: Path, files: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> Path:
    with zipfile.ZipFile(folder / "ann.zip", "w", method) as file:
        for name, content in files.items():
            file.writestr(name, content)
    return folder / "ann.zip"


def zip_of(files: Mapping[Any, bytes]) -> bytes:
    """Return the contents of a zip with these files, keyed by their names or ZipInfos."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as file:
        for name, data in files.items():
            file.writestr(name, data)
    return content.getvalue()


def special_zip(
    folder: Path, name: str = VECTOR, mode: int = 0o100644, extra: bytes = b"", **fields: int
) -> Path:
    """Create a zip with one uncompressed file, and then change some fields of its directory."""
    info = zipfile.ZipInfo(name)
    info.create_system, info.external_attr, info.extra = 3, mode << 16, extra
    with zipfile.ZipFile(folder / "ann.zip", "w") as file:
        file.writestr(info, CODE)
    return set_fields(folder / "ann.zip", **fields)


def set_fields(path: Path, **fields: int) -> Path:
    """Change some fields in a zip's directory, in the entry of its last file."""
    data = bytearray(path.read_bytes())
    short = {"version": 6, "flags": 8, "method": 10}
    long = {"crc": 16, "packed": 20, "size": 24, "offset": 42}
    for field, value in fields.items():
        place = data.rindex(b"PK\1\2") + (short | long)[field]
        struct.pack_into("<H" if field in short else "<L", data, place, value)
    path.write_bytes(data)
    return path
