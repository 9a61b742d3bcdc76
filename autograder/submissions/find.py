"""Find what the students of a class have handed in, and choose names for the reports on them."""

from __future__ import annotations

import hashlib
import re
import stat
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.submissions.exports import MOODLE, Exported, look_like_canvas, read_export
from autograder.submissions.platform_files import Upload
from autograder.text.clean import visible

RECORD = "run.json"  # in a folder of reports; records the class, the seed and so on
LONGEST_NAME = 100  # bytes without the suffix; file systems allow 255 in all
SILENT = (
    *("__pycache__", "__MACOSX", "README.md", "course.toml", "marks.csv", "roster.csv"),
    *("times.csv", "submission_metadata.yml", "grades.csv", "worksheet.csv"),  # from platforms
)
WIDE_SPACE = re.compile(r"[^\S\x00-\x7f]")
CHAPTER = re.compile(r"ch\d\d_\w+")
DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
HASHED = re.compile(r".*-[0-9a-f]{8}")
SUFFIX = re.compile(r"(\.tar)?\.[A-Za-z0-9]{1,5}$", re.IGNORECASE)
# What students hand in by mistake. A file of another type could be the instructor's own.
BY_STUDENTS = re.compile(
    r"\.(pdf|docx?|odt|rar|7z|tar|tgz|gz|bz2|xz|zst|py|ipynb|png|jpe?g)$", re.IGNORECASE
)


@dataclass(frozen=True)
class Submission:
    """What a student, or a group of students, has handed in: a folder or a zip.

    In the list of ``find_entries``, ``student`` is the name of the folder or zip, such as ann for
    ann.zip, and the names are not known yet.
    """

    student: str  # the name of the student or of the group in the reports
    path: Path
    owner: str = ""  # their name in records, whatever the name of the report is
    export: Exported | None = None  # the parsed name, if Canvas or Moodle gave it
    upload: Upload | None = None  # what a platform's file says about it
    notes: tuple[str, ...] = ()  # for the student too, such as on files that were not used
    nothing: str = ""  # why nothing of it can be graded, such as "it is a symbolic link"

    @property
    def is_by_student(self) -> bool:
        """True if it was surely handed in, even if nobody on a roster has this name."""
        return not self.nothing or bool(self.export) or bool(BY_STUDENTS.search(self.path.name))

    @property
    def late(self) -> bool:
        """True if Canvas marked the submission as late. Other platforms do not show this."""
        return self.export is not None and self.export.late


def find_entries(folder: Path, is_known: Callable[[Exported], bool]) -> list[Submission]:
    """List what was handed in, without the instructor's own files, hidden files and caches.

    A name counts as Canvas's if all folders and zips look like one download, or if ``is_known``
    says that the student is on the roster.
    """
    if not folder.is_dir():
        raise ValueError(
            f"the submissions must be in an existing folder or zip, got {str(folder)!r}"
        )
    entries = [_entry(path) for path in sorted(folder.iterdir()) if not is_no_submission(path.name)]
    for one in entries:
        if CHAPTER.fullmatch(one.path.name) and one.path.is_dir():
            raise ValueError(
                f"{str(folder)!r} has a folder {one.path.name} and so is the work of one student. "
                "Name the folder above it, which has a folder or a zip for each student"
            )
    usable = [one for one in entries if not one.nothing]
    has_folders = any(one.path.is_dir() for one in usable)  # which Canvas does not have
    is_download = look_like_canvas([one.export for one in usable]) and not has_folders
    for i, one in enumerate(entries):
        if one.export and one.export.platform == "canvas" and not is_download:
            entries[i] = one if is_known(one.export) else replace(one, export=None)
    return entries


def file_name(student: str) -> str:
    """Return a safe file name for the reports on a student, without a suffix.

    A name that is long or not harmless gets a hash, so that two students never share a file.
    """
    kept = [char if char.isprintable() and char not in '/\\<>:"|?*' else "_" for char in student]
    safe = re.sub(r"^\.", "_", "".join(kept))
    # A name that seems to end with a hash could equal the file name of another student.
    harmless = safe == student and not HASHED.fullmatch(student)
    if harmless and 0 < len(student.encode()) <= LONGEST_NAME and not DEVICE.fullmatch(student):
        return student
    digest = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:8]
    cut = safe.encode()[: LONGEST_NAME - len(digest) - 1]
    return f"{cut.decode(errors='ignore')}-{digest}"


def contents(path: Path) -> frozenset[tuple[str, str]]:
    """Return the path and a hash of each file of a submission, which is a folder or a file."""
    files = {path} if path.is_file() else {file for file in path.rglob("*") if file.is_file()}
    names = {file: file.relative_to(path).as_posix() for file in files if not file.is_symlink()}
    return frozenset((names[f], hashlib.sha256(f.read_bytes()).hexdigest()) for f in names)


def printable(text: str) -> str:
    """Escape unprintable characters and backslashes, so that no two texts look the same."""
    return "".join(map(visible, text.replace("\\", "\\\\")))


def is_no_submission(name: str) -> bool:
    """Return True if a name in the folder of a class is hidden, or that of an instructor's file."""
    # In Moodle, the name of a student can begin with a dot too.
    return name in SILENT or (name.startswith(".") and not MOODLE.fullmatch(name))


def _entry(path: Path) -> Submission:
    mode = path.lstat().st_mode
    is_zip = stat.S_ISREG(mode) and path.suffix.lower() == ".zip"
    # Rosters have ordinary spaces, but names in Japanese often have a wide one.
    name = printable(WIDE_SPACE.sub(" ", path.stem if is_zip else path.name))
    problem = ""
    if not is_zip and not stat.S_ISDIR(mode):
        is_link = stat.S_ISLNK(mode)
        problem = "it is a symbolic link" if is_link else "it is neither a folder nor a .zip file"
        name = SUFFIX.sub("", name)
    elif (path / RECORD).is_file() and (path / "results").is_dir():
        problem = "it has the reports of a graded class"
    export = read_export(name)
    if export and not export.is_file:
        problem = "it is text that was typed into the platform"
    return Submission(name, path, export=export, nothing=problem)
