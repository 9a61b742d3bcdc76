"""Unpack a zip that contains all submissions of a class into a new folder next to the zip."""

from __future__ import annotations

import errno
import hashlib
import shutil
import unicodedata
import zipfile
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import msgspec

from autograder.accepted_files import NotTakenError
from autograder.file_lock import locked
from autograder.files import is_new, replace_bytes
from autograder.submissions.find import SILENT, is_no_submission, printable
from autograder.submissions.zips import is_folder, is_unsafe, open_zip, path_in_zip, read_entry

MARKER = ".unpacked.json"
COUNTS = (".zip", ".py", ".md", ".csv")  # we unpack no content of other types
# These limits are in bytes. A student's zip may have 5 MB. We unpack a larger one as well, so that
# the grader can report that it is too large.
LARGEST_FILE = 50_000_000
MOST_OF_ONE = 100_000_000  # for all files of one student
MOST_IN_ALL = 2_000_000_000
MOST_FILES = 100_000
# If one of these errors occurs, a name in the zip is to blame and not this machine.
NAMES = (errno.EEXIST, errno.ENOTDIR, errno.EISDIR, errno.ENAMETOOLONG, errno.EILSEQ, errno.EINVAL)
# The parts of a path, and its entry, or None if it is only known that the first part is there.
File = tuple[list[str], zipfile.ZipInfo | None]


@dataclass(frozen=True)
class Unpacked:
    """A record of what was unpacked."""

    zip: str  # a hash of it
    names: list[str]  # of the submissions
    notes: list[str]  # on what was left out


def class_folder(path: Path) -> Path:
    """Return the folder with the submissions of a class, and unpack it first if it is in a zip.

    If the zip has changed since the last time, it is unpacked again, but marks.csv is kept.
    """
    if not path.is_file():
        return path
    if path.suffix.lower() != ".zip":
        raise ValueError(f"the submissions must be a folder or a .zip file, got {str(path)!r}")
    folder = path.with_suffix("")
    with locked(path.with_name(f".{path.name}.lock")):  # another command may be unpacking it
        unpacked, digest = _read_marker(folder), _digest(path)
        if unpacked.zip != digest:
            unpacked = _unpack(path, folder, unpacked, digest)
    for note in unpacked.notes:
        print(note)
    print(f"{path.name} is unpacked in {folder}: {len(unpacked.names)} entries")
    return folder


def refuse_newer_zip(folder: Path) -> None:
    """Raise ValueError if the zip from which a folder was unpacked has changed since then."""
    is_unpacked = (folder / MARKER).is_file()
    for path in (folder.with_name(folder.name + suffix) for suffix in (".zip", ".ZIP")):
        if is_unpacked and path.is_file() and _read_marker(folder).zip != _digest(path):
            raise ValueError(
                f"{path} has changed since it was unpacked. Name it to grade what is in it now "
                f"(make: SUBMISSIONS={path}), or name {folder} to grade what was in it before"
            )


def _unpack(path: Path, folder: Path, before: Unpacked, digest: str) -> Unpacked:
    """Unpack a zip, after deleting the submissions from an earlier version of it."""
    try:
        file = open_zip(path)
    except NotTakenError as error:
        raise ValueError(f"{path} cannot be unpacked: {error}") from error
    with file:
        files, notes = _plan(path, file)
        names = sorted({parts[0] for parts, _ in files})
        folder.mkdir(exist_ok=True)
        there = {one.name: one for one in folder.iterdir()}
        own = [name for name in there if name not in before.names]
        if taken := {*own} & {*names}:
            raise ValueError(f"{folder / min(taken)} did not come from {path.name}: move it")
        own = [name for name in own if not name.startswith(".")]
        if own and before.names and not {*before.names} & {*names}:
            raise ValueError(
                f"{path} has no submission that is in {folder}, so it may be of another "
                f"assignment, and {own[0]} there not for it. Rename {folder} first, or move "
                f"{own[0]} elsewhere"
            )
        # If a run is killed, the next one starts over, even if the earlier zip is back by then.
        _write_marker(folder, Unpacked("", before.names, []))
        for one in [there[name] for name in before.names if name in there]:
            shutil.rmtree(one) if one.is_dir() and not one.is_symlink() else one.unlink()
        _write_marker(folder, Unpacked("", names, []))
        unpacked = Unpacked(digest, names, notes + _write(folder, file, files))
    _write_marker(folder, unpacked)
    return unpacked


def _plan(path: Path, file: zipfile.ZipFile) -> tuple[list[File], list[str]]:
    """Decide which files of a zip to write to disk, with notes on the files that are left out."""
    if len(file.infolist()) > MOST_FILES:
        raise ValueError(f"{path} contains more than {MOST_FILES:,} files and folders")
    files: list[File] = []
    notes: list[str] = []
    for entry in file.infolist():
        name = path_in_zip(entry)
        parts = name.split("/")
        if not _is_path(name):
            notes.append(f"{printable(name)} was left out: its path is not that of an upload")
            if parts[1:] and _is_path(parts[0]):
                files.append((parts[:1], None))
        elif not is_no_submission(parts[0]):
            is_left_out = any(part.startswith(".") or part in SILENT for part in parts[1:])
            files.append((parts, None if is_left_out or is_folder(entry) else entry))
    return files, notes


def _is_path(name: str) -> bool:
    """Return True if a path is safe, and text. Some scripts need invisible joiners."""
    characters = all(c.isprintable() or unicodedata.category(c) in ("Zs", "Cf") for c in name)
    return characters and not is_unsafe(name)


def _write(folder: Path, file: zipfile.ZipFile, files: Iterable[File]) -> list[str]:
    """Extract zips and the types of files that students hand in, and return notes on the rest.

    Other files, such as a PDF, become empty, so that it is known that they were handed in.
    """
    notes: list[str] = []
    sizes: Counter[str] = Counter()
    for parts, entry in files:
        student, target = parts[0], folder.joinpath(*parts)
        try:
            if entry is None:
                (folder / student).mkdir(exist_ok=True)  # even if nothing in it counts
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            counts = target.name.lower().endswith(COUNTS)
            content = read_entry(file, entry, LARGEST_FILE) if counts else b""
            sizes[student] += len(content)
            if sizes[student] > MOST_OF_ONE:
                raise NotTakenError(f"its student uploaded more than {MOST_OF_ONE:,} bytes")
            if sizes.total() > MOST_IN_ALL:
                raise ValueError(f"{file.filename} contains more than {MOST_IN_ALL:,} bytes")
            with target.open("xb") as out:  # does not follow a link or overwrite another file
                out.write(content)
        except NotTakenError as error:
            if not parts[1:]:
                target.touch(exist_ok=True)
            notes.append(f"{'/'.join(parts)} was left out: {error}")
        except OSError as error:
            if error.errno not in NAMES:
                raise
            notes.append(f"{'/'.join(parts)} was left out: {error.strerror}")
    return notes


def _read_marker(folder: Path) -> Unpacked:
    if is_new(folder, folder / MARKER):
        return Unpacked("", [], [])
    try:
        return msgspec.json.decode((folder / MARKER).read_bytes(), type=Unpacked)
    except (OSError, msgspec.DecodeError) as error:
        problem = f"{folder} already exists, but was not unpacked from {folder.name}.zip"
        raise ValueError(f"{problem}: grade that folder instead, or move it elsewhere") from error


def _write_marker(folder: Path, unpacked: Unpacked) -> None:
    replace_bytes(folder / MARKER, msgspec.json.encode(unpacked))


def _digest(path: Path) -> str:
    if (size := path.stat().st_size) > MOST_IN_ALL:
        raise ValueError(f"{path} is larger than {MOST_IN_ALL:,} bytes: it has {size:,}")
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
