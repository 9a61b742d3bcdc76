"""Find the submissions of a class, and choose file names for the reports on the students."""

from __future__ import annotations

import hashlib
import re
import stat
from dataclasses import dataclass
from pathlib import Path

from autograder.submissions.exports import Exported, read_export
from autograder.text.clean import visible

LONGEST_NAME = 100  # bytes without the suffix; file systems allow 255 in all
SILENT = (
    *("__pycache__", "__MACOSX", "README.md", "course.toml"),
    *("marks.csv", "roster.csv", "roster-key.csv"),
    *("times.csv", "submission_metadata.yml", "grades.csv"),  # the times of submissions
    "worksheet.csv",  # from Moodle
)
DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
HASHED = re.compile(r".*-[0-9a-f]{8}")


@dataclass(frozen=True)
class Submission:
    """The folder or zip file that a student has handed in.

    Attributes:
        student: The student's name in the reports.
        path: The path of the folder or zip file.
        export: The parsed name if Canvas or Moodle created it, otherwise None.
        aliases: The student's other names, from the submission and from the roster.
    """

    student: str
    path: Path
    export: Exported | None = None
    aliases: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """All names of the student, starting with the one used in the reports."""
        return (self.student, *self.aliases)

    @property
    def late(self) -> bool:
        """True if Canvas marked the submission as late. Other platforms do not show this."""
        return self.export is not None and self.export.late


def find_submissions(folder: Path) -> tuple[list[Submission], list[str]]:
    """Find the students' submissions in the folder of a class, with notes on everything else in it.

    A submission is a folder or a .zip file. Its name is the student's name or a name given by
    Canvas or Moodle. If a student uploaded several files to one of these platforms, only the last
    one counts. Links are never followed. Hidden files, caches and the instructor's own files are
    skipped without a note.

    Returns:
        The submissions, sorted by student, and the notes.

    Raises:
        ValueError: The path is not a folder, it contains no submissions, or it contains two by the
            same student.
        OSError: The folder cannot be read.
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
        name = printable(path.stem if is_zip else path.name)
        export = read_export(name)
        if export and not export.is_file:
            notes.append(f"{name} was left out: it is text that was typed into the platform")
            continue
        new = Submission(export.student if export else name, path, export)
        # Keyed by the name of the report, so that no report overwrites another one
        # (if the file system distinguishes A from a).
        old = found.setdefault(file_name(new.student), new)
        if old is new:
            continue
        if not (old.export and new.export):
            raise ValueError(
                f"a student must hand in only once, got {old.path.name!r} and {path.name!r} "
                f"in {str(folder)!r}"
            )
        first, last = sorted((old, new), key=_order)
        found[file_name(new.student)] = last
        notes.append(
            f"{printable(first.path.name)} was left out: {printable(last.path.name)} by the same "
            f"student was used instead. If they belong together, put both in a folder named "
            f"{printable(last.path.stem)}"
        )
    if not found:
        raise ValueError(
            f"{str(folder)!r} has no submissions: a folder or a .zip file named after each student"
        )
    return sorted(found.values(), key=lambda submission: submission.student), notes


def file_name(student: str) -> str:
    """Return a safe file name for the reports on a student, without a suffix.

    A short and harmless name is not changed. Otherwise, unsafe characters are replaced, and the
    name is truncated. A hash of the original name is then appended, so that two students do not
    share a file.
    """
    # A name that seems to end with a hash could equal the file name of another student.
    harmless = _clean(student) == student and not HASHED.fullmatch(student)
    if harmless and 0 < len(student.encode()) <= LONGEST_NAME and not DEVICE.fullmatch(student):
        return student
    digest = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:8]
    cut = _clean(student).encode()[: LONGEST_NAME - len(digest) - 1]
    return f"{cut.decode(errors='ignore')}-{digest}"


def printable(text: str) -> str:
    """Escape the unprintable characters in a text, such as the name of a submitted file.

    Backslashes are doubled, so that different texts never look the same.
    """
    return "".join(map(visible, text.replace("\\", "\\\\")))


def _order(submission: Submission) -> tuple[int, int]:
    """Return a sort key that puts a student's uploads in order, oldest first.

    Only the last upload is graded.
    """
    return submission.export.order if submission.export else (0, 0)


def _clean(name: str) -> str:
    """Replace each character in a student's name that could cause trouble in a file name."""
    kept = [char if char.isprintable() and char not in '/\\<>:"|?*' else "_" for char in name]
    return re.sub(r"^\.", "_", "".join(kept))
