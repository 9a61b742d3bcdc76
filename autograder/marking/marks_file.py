"""Change individual marks in marks.csv without altering the rest of the file.

The file holds the points and comments that instructors enter for students' written answers.
"""

from __future__ import annotations

import csv
import io
from pathlib import Path

from autograder.file_lock import locked
from autograder.manifest import Chapter
from autograder.reports.marks import HEADER, Mark, Marks, read_marks, read_rows, row_of
from autograder.reports.texts import replace_file
from autograder.submissions.class_list import ClassList


class ChangedError(Exception):
    """Raised if somebody else has changed a mark since the marking page displayed it."""


class MarksFile:
    """The marks for the written answers of a class, stored in marks.csv.

    Several people may be changing the file at the same time, for example on two marking pages.
    """

    def __init__(self, path: Path, chapters: list[Chapter], people: ClassList) -> None:
        self.path = path.resolve()  # the file itself, if the path is a link
        self.chapters = chapters
        self.people = people

    def read(self) -> Marks:
        """Read all marks from marks.csv.

        Raises:
            ValueError: A line is invalid. The error gives its number.
        """
        marks, _ = read_marks(self.path, self.chapters, self.people)
        return marks

    def change(self, student: str, exercise: str, mark: Mark | None, seen: Mark | None) -> None:
        """Write a student's mark for an answer into marks.csv, or delete it if ``mark`` is None.

        ``seen`` is the old mark that the marking page displayed. It must match the one in the file,
        so that nobody overwrites a mark without having seen it.

        Raises:
            ChangedError: The old mark in the file differs from ``seen``.
            ValueError: A line in the file is invalid. The file is left unchanged.
        """
        with locked(self.path.parent / ".marks.lock"):
            separator, rows = read_rows(self.path, self.chapters, self.people)
            old = next((r for r in rows if (r.report, r.exercise) == (student, exercise)), None)
            if (old.mark if old else None) != seen:
                raise ChangedError
            if mark == seen:
                return
            lines = self._lines()
            newline = "\r\n" if lines[0].endswith("\r\n") else "\n"
            if not lines[-1].endswith(("\n", "\r")):
                lines[-1] += newline
            new = [] if mark is None else [self._line(student, exercise, mark, separator, newline)]
            if old:
                lines[old.first - 1 : old.last] = new
            else:
                lines += new
            replace_file(self.path, "".join(lines))

    def _lines(self) -> list[str]:
        """Return the lines of marks.csv, or only the header if the file does not exist.

        Each line keeps its line ending. The file is split into lines in the same way as in
        ``read_rows``. The line numbers that ``read_rows`` returns are therefore valid for this
        list.
        """
        if not self.path.exists():
            return [",".join(HEADER) + "\n"]
        with self.path.open(encoding="utf-8", newline="") as file:
            return [*file]

    def _line(self, student: str, exercise: str, mark: Mark, separator: str, newline: str) -> str:
        cells = row_of(student, exercise, mark, self.people)
        if separator == ";":  # where a spreadsheet would read 2.5 as May 2
            cells[2] = cells[2].replace(".", ",")
        text = io.StringIO(newline="")
        csv.writer(text, delimiter=separator, lineterminator=newline).writerow(cells)
        return text.getvalue()
