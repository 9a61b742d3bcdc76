"""Read and fill the grading worksheet that an instructor has downloaded from a Moodle assignment.

Moodle accepts a worksheet only with the headers of the instructor's own language. That is why the
grades go into a copy of the downloaded file. Its columns are recognized without their headers, by
their order and by what their cells look like. The order is that of Moodle's mod/assign/
gradingtable.php: the identifier, the full name, what else is known about a student, the status,
the grade, the maximum grade, whether the grade can be changed, and the times of the last changes.
"""

from __future__ import annotations

import csv
import io
import re
from codecs import BOM_UTF8
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from dateparser.date import DateDataParser

from autograder.submissions.csv_rows import read_csv
from autograder.submissions.exports import OF_MOODLE

IDENTIFIER = re.compile(r"(.*\D)([0-9]+)")  # such as Participant 12345 or Teilnehmer/in12345
NUMBER = re.compile(r"[0-9]+(?:[.,][0-9]+)?")
EMAIL = re.compile(r"\S+@\S+")
ID_NUMBER = re.compile(r"(?=\S*\d)[^\s@+]+")
TIME = re.compile(r"-|.*\d{4}.*\d\s*[:.h]\s*\d\d.*|.*\d\s*[:.h]\s*\d\d.*\d{4}.*")
NO_TIME = "-"
YEARS = range(2000, 2100)  # others are of another calendar, such as the Thai one
EXPECTED = (
    "Save the grading worksheet there as Moodle wrote it, with the columns of the identifier, "
    "the grade, the maximum grade and the times of the last changes. The assignment must be graded "
    "with points"
)


@dataclass(frozen=True)
class Participant:
    """A row of a Moodle worksheet. What it does not show is "".

    The time of the submission is in the time zone of the instructor's Moodle. It is None if nothing
    was handed in, or if it cannot be read.
    """

    number: str  # for this assignment only; it is in the names of downloaded submissions
    name: str
    email: str
    id_number: str
    submitted: datetime | None


@dataclass(frozen=True)
class Worksheet:
    """A grading worksheet from Moodle."""

    path: Path
    rows: list[Participant]
    most: float  # the maximum grade of the assignment
    unread: list[str]  # the submission times that cannot be read
    lines: list[list[str]]  # the cells of every line, starting with the header
    grade: int  # the column for the grades, which is before that of the maximum grade
    separator: str

    def filled(self, grades: Mapping[str, float]) -> bytes:
        """Return the contents of the file with these grades, keyed by the participants' numbers.

        All other cells stay as they are. The grades have the decimal separator of the maximum.
        """
        header, *lines = ([*line] for line in self.lines)
        for line, participant in zip(lines, self.rows, strict=True):
            if participant.number in grades:
                grade = f"{grades[participant.number]:.2f}"
                comma = "," in line[self.grade + 1]
                line[self.grade] = grade.replace(".", ",") if comma else grade
        original = self.path.read_bytes()
        end = "\r\n" if original.partition(b"\n")[0].endswith(b"\r") else "\n"
        text = io.StringIO(newline="")
        csv.writer(text, delimiter=self.separator, lineterminator=end).writerows([header, *lines])
        mark = BOM_UTF8 if original.startswith(BOM_UTF8) else b""
        return mark + text.getvalue().encode()


def worksheet_in(folder: Path) -> Worksheet | None:
    """Read worksheet.csv in the folder with a class's submissions, or return None without one."""
    path = folder / OF_MOODLE
    return read_worksheet(path) if path.exists() else None


def read_worksheet(path: Path) -> Worksheet:
    """Read a grading worksheet from Moodle, in any language.

    Raises:
        ValueError: The file is not a worksheet, or its columns are not certain. The message says
            what is expected.
        OSError: The file cannot be read.
    """
    table = read_csv(path)
    reader = csv.reader(io.StringIO(table.text, newline=""), delimiter=table.separator, strict=True)
    is_none = f"{path} is not a worksheet from Moodle"
    try:
        lines = [line for line in reader if line]
    except csv.Error as error:
        raise ValueError(f"{is_none}: {error}. {EXPECTED}") from error
    if len(lines) < 2 or len({len(line) for line in lines}) > 1:
        raise ValueError(
            f"{is_none}: below its header, it must have a row of the same length for each "
            f"participant. {EXPECTED}"
        )
    columns = [[cell.strip() for cell in column] for column in zip(*lines[1:], strict=True)]
    # All identifiers begin with the same word, which is the translation of "Participant".
    found = [IDENTIFIER.fullmatch(cell) for cell in columns[0]]
    if len({one and one[1] for one in found}) > 1 or None in found:
        raise ValueError(
            f"{is_none}: its first column must have identifiers, such as 'Participant 12345', got "
            f"{columns[0][0]!r}. {EXPECTED}"
        )
    numbers = [one[2] for one in found if one]
    if len({*numbers}) < len(numbers):
        raise ValueError(f"{path}: a participant appears twice. {EXPECTED}")
    grade, times = _places(path, columns)
    names, emails, ids = _known(columns[1:grade])
    submitted = columns[times[0]] if len(times) > 1 else [NO_TIME] * len(numbers)
    read = _read_times(submitted)
    unread = [text for text, at in zip(submitted, read, strict=True) if not at and text != NO_TIME]
    rows = [*map(Participant, numbers, names, emails, ids, read)]
    most = _number(columns[grade + 1][0])
    return Worksheet(path, rows, most, unread, lines, grade, table.separator)


def _places(path: Path, columns: Sequence[Sequence[str]]) -> tuple[int, list[int]]:
    """Find the position of the column for the grades, and those of the columns with times.

    The column after the grades has the maximum grade, which is the same in each row. One or two
    columns with words follow, such as "Yes", and then the first column with times.
    """
    times = [place for place, cells in enumerate(columns) if _fits(TIME, cells, empty=False)]
    found = [
        place - 1
        for place, cells in enumerate(columns)
        if place > 1
        and len({*cells}) == 1
        and _fits(NUMBER, cells, empty=False)
        and _number(cells[0]) > 0
        and _fits(NUMBER, columns[place - 1])
        and {place + 2, place + 3} & {*times}
    ]
    if len(found) != 1:
        raise ValueError(
            f"{path}: it is not certain which column is for the grades. The next column must have "
            f"the maximum grade in each row. {EXPECTED}"
        )
    return found[0], [place for place in times if place > found[0] + 2]


def _known(columns: Sequence[list[str]]) -> tuple[list[str], list[str], list[str]]:
    """Find the names, the e-mail addresses and the ID numbers in a worksheet, or "" for each.

    ``columns`` are those between the identifiers and the grades. The names come first, but if the
    participants are anonymous, the status does, which most of them share. The ID numbers are just
    before the e-mail addresses. Without e-mail addresses, the ID numbers are found only if no other
    column looks the same.
    """
    unknown = [""] * len(columns[0])
    names, others = columns[0], columns[1:]
    if not others or max(map(names.count, names)) > max(1, len(names) // 2):
        return unknown, unknown, unknown
    names = [re.sub(r"<[^>]*>", "", name).strip() for name in names]  # of suspended students
    emails = next((cells for cells in others if any(cells) and _fits(EMAIL, cells)), unknown)
    if any(emails):
        others = others[: others.index(emails)][-1:]
    ids = [
        cells
        for cells in others
        if any(cells) and _fits(ID_NUMBER, cells)
        if all(not cell or cells.count(cell) == 1 for cell in cells)
    ]
    return names, emails, ids[0] if len(ids) == 1 else unknown


def _number(cell: str) -> float:
    return float(cell.replace(",", "."))


def _fits(pattern: re.Pattern[str], cells: Sequence[str], *, empty: bool = True) -> bool:
    """Check that every cell matches a pattern. With ``empty``, a cell may also be empty."""
    return all((empty and not cell) or pattern.fullmatch(cell) for cell in cells)


def _read_times(cells: Sequence[str]) -> list[datetime | None]:
    """Read times such as "Friday, 23 October 2026, 8:15 PM", in any of many languages.

    The result is None for a cell that is not a time, for one whose day and month are both numbers
    that could be the other, and for a year of another calendar.
    """
    readers = [
        DateDataParser(
            settings={"STRICT_PARSING": True, "PARSERS": ["absolute-time"], "DATE_ORDER": order}
        )
        for order in ("DMY", "MDY")
    ]
    times: list[datetime | None] = []
    for cell in cells:
        found = {reader.get_date_data(cell).date_obj for reader in readers} if cell else set()
        at = found.pop() if len(found) == 1 else None
        times.append(at.replace(tzinfo=None) if at and at.year in YEARS else None)
    return times
