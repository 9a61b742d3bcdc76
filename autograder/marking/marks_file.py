"""Change one mark in marks.csv, and lose no other."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

from autograder.file_lock import locked
from autograder.manifest import Chapter
from autograder.reports.marks import HEADER, Mark, Row, read_rows
from autograder.reports.texts import replace_file
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell
from autograder.text.clean import clean

# A spreadsheet would take such a comment for a formula, so we store it with an apostrophe in front.
FORMULA_START = re.compile(r"^(?='*[=+\-@＝＋－＠])")  # noqa: RUF001


class ChangedError(Exception):
    """Raised if a mark in the file is not the one that the marking page displayed."""


def change_mark(
    path: Path,
    chapters: list[Chapter],
    people: ClassList,
    answer: tuple[str, str],
    mark: Mark | None,
    seen: Mark | None,
) -> None:
    """Write a mark for ``answer``, a student and an exercise, or delete it if ``mark`` is None.

    Raises:
        ChangedError: The file does not have ``seen``, the mark that the page displayed.
        ValueError: A line in the file is invalid. The file is left unchanged.
    """
    path = path.resolve()  # the file itself, if the path is a link
    with locked(path.parent / ".marks.lock"):
        separator, rows = read_rows(path, chapters, people)
        old = rows.get(answer)
        now = old.mark if old else None
        if now != seen:
            words = f"It gives {now.points:g} points. {now.comment}" if now else "It is gone."
            raise ChangedError(f"This mark has been changed in marks.csv. {words}")
        if mark == seen:
            return
        if mark:
            name = old.student if old else _name_of(answer[0], people)
            rows[answer] = Row(name, *answer, mark, 0)
        else:
            del rows[answer]
        before = path.read_bytes().decode() if path.exists() else ""
        newline = "\r\n" if before.partition("\n")[0].endswith("\r") else "\n"
        text = io.StringIO(newline="")
        text.write("\ufeff" if before.startswith("\ufeff") else "")  # which Excel looks for
        writer = csv.writer(text, delimiter=separator, lineterminator=newline)
        writer.writerow(HEADER)
        for row in rows.values():
            points = f"{row.mark.points:.9f}".rstrip("0").rstrip(".")
            if separator == ";":  # where a spreadsheet would read 2.5 as May 2
                points = points.replace(".", ",")
            comment = FORMULA_START.sub("'", clean(row.mark.comment).strip())
            writer.writerow([row.student, row.exercise, points, comment])
        replace_file(path, text.getvalue())


def _name_of(student: str, people: ClassList) -> str:
    """Return the name for a new row, escaped if a spreadsheet would take it for a formula."""
    harmless = as_cell(student)
    try:
        return harmless if people.report_of(harmless) == student else student
    except ValueError:
        return student
