"""Find the submissions of a class, and name the reports on them."""

from __future__ import annotations

import hashlib
import re
import stat
from dataclasses import dataclass
from pathlib import Path

from autograder.clean import visible

LONGEST_NAME = 100  # bytes; a suffix comes after it, and file systems end at 255
SILENT = ("__pycache__", "__MACOSX", "README.md", "marks.csv")
DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
HASHED = re.compile(r".*-[0-9a-f]{8}")


@dataclass(frozen=True)
class Submission:
    """What a student handed in: a folder, or a zip file."""

    student: str
    path: Path


def find_submissions(folder: Path) -> tuple[list[Submission], list[str]]:
    """Return the submissions in a class's folder, sorted by student, and notes on what is none.

    A submission is a folder or a .zip file that is named after the student. Links are never
    followed. Hidden files, caches, a README.md and marks.csv are passed over without a note.
    Raises ValueError where it is no folder, has no submission, or has two of one student, and
    OSError where it cannot be read.
    """
    if not folder.is_dir():
        raise ValueError(f"the submissions must be in a folder, got {str(folder)!r}")
    found: dict[str, Submission] = {}
    notes: list[str] = []
    for path in sorted(folder.iterdir()):
        if path.name.startswith(".") or path.name in SILENT:
            continue
        mode = path.lstat().st_mode
        is_zip = stat.S_ISREG(mode) and path.suffix.lower() == ".zip"
        if not is_zip and not stat.S_ISDIR(mode):
            what = "a symbolic link" if stat.S_ISLNK(mode) else "neither a folder nor a .zip file"
            notes.append(f"{printable(path.name)} was left out: it is {what}")
            continue
        new = Submission(printable(path.stem if is_zip else path.name), path)
        # Keyed by the reports' name, so that no report is written over another,
        # on file systems that tell A from a.
        old = found.setdefault(file_name(new.student), new)
        if old is not new:
            raise ValueError(
                f"a student must hand in once, got {old.path.name!r} and {path.name!r} "
                f"in {str(folder)!r}"
            )
    if not found:
        raise ValueError(
            f"{str(folder)!r} has no submissions: a folder or a .zip file named after each student"
        )
    return sorted(found.values(), key=lambda submission: submission.student), notes


def file_name(student: str) -> str:
    """Return a name, without a suffix, for the files about a student: safe, and no one else's.

    It is the student's name where that is harmless and short. Otherwise it is what is harmless
    of the name, cut, with a hash of the whole name behind it.
    """
    # A name that looks as if it had a hash could be what another name turns into.
    harmless = _clean(student) == student and not HASHED.fullmatch(student)
    if harmless and 0 < len(student.encode()) <= LONGEST_NAME and not DEVICE.fullmatch(student):
        return student
    digest = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:8]
    cut = _clean(student).encode()[: LONGEST_NAME - len(digest) - 1]
    return f"{cut.decode(errors='ignore')}-{digest}"


def printable(text: str) -> str:
    """Return a text with escapes for what cannot be printed.

    A backslash is doubled: so two texts never become one.
    """
    return "".join(map(visible, text.replace("\\", "\\\\")))


def _clean(name: str) -> str:
    """Replace what some file system takes for more than a letter of a name."""
    kept = [char if char.isprintable() and char not in '/\\<>:"|?*' else "_" for char in name]
    return re.sub(r"^\.", "_", "".join(kept))
