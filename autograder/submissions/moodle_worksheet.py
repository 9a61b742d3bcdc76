"""Read and fill the grading worksheet that an instructor has downloaded from a Moodle assignment.

Its headers are in the instructor's language, so its columns are recognized by their order and by
what their cells look like. The order is that of Moodle's mod/assign/gradingtable.php: the
identifier, the full name, what else is known about a student, the status, the grade, the maximum
grade, whether the grade can be changed, and the times of the last changes.
"""

from __future__ import annotations

import csv
import io
import re
from codecs import BOM_UTF8
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import pairwise
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
    "Save the worksheet there as Moodle wrote it, with the columns of the identifier, the grade, "
    "the maximum grade and the times of the last changes. The assignment must be graded with points"
)


@dataclass(frozen=True)
class Participant:
    """A row of a Moodle worksheet. What it does not show is ""."""

    number: str  # for this assignment only; it is in the names of downloaded submissions
    name: str
    email: str
    id_number: str
    submitted: datetime | None  # in the time zone of the Moodle; None if unknown


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
        """Return the contents of the file with these grades, by the participants' numbers."""
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
    """Read a grading worksheet from Moodle, in any language."""
    table = read_csv(path)
    reader = csv.reader(io.StringIO(table.text, newline=""), delimiter=table.separator, strict=True)

    def refused(problem: object) -> ValueError:
        return ValueError(f"{path} is not a worksheet from Moodle: {problem}. {EXPECTED}")

    try:
        lines = [line for line in reader if line]
    except csv.Error as error:
        raise refused(error) from error
    if len(lines) < 2 or len({len(line) for line in lines}) > 1:
        raise refused("below its header, it must have a row of the same length for each student")
    columns = [[cell.strip() for cell in column] for column in zip(*lines[1:], strict=True)]
    # All identifiers begin with the same word, which is the translation of "Participant".
    found = [IDENTIFIER.fullmatch(cell) for cell in columns[0]]
    numbers = [one[2] for one in found if one]
    if len({one and one[1] for one in found}) > 1 or len({*numbers}) < len(found):
        raise refused(
            "its first column must have different identifiers, such as 'Participant 12345', got "
            f"{columns[0][0]!r}"
        )
    # The column after the grades has the maximum grade, which is the same in each row. One or two
    # columns with words follow, such as "Yes", and then the first column with times.
    times = [place for place, cells in enumerate(columns) if _fits(TIME, cells, empty=False)]
    places = [
        place
        for place, (cells, maximum) in enumerate(pairwise(columns))
        if place and len({*maximum}) == 1 and _fits(NUMBER, maximum, empty=False)
        if _number(maximum[0]) > 0 and _fits(NUMBER, cells) and {place + 3, place + 4} & {*times}
    ]
    if len(places) != 1:
        raise refused("it is not certain which column is for the grades")
    grade = places[0]
    names, emails, ids = _known(columns[1:grade])
    times = [place for place in times if place > grade + 2]
    submitted = columns[times[0]] if len(times) > 1 else [NO_TIME] * len(numbers)
    read = _read_times(submitted)
    unread = [text for text, at in zip(submitted, read, strict=True) if not at and text != NO_TIME]
    rows = [*map(Participant, numbers, names, emails, ids, read)]
    most = _number(columns[grade + 1][0])
    return Worksheet(path, rows, most, unread, lines, grade, table.separator)


def _known(columns: Sequence[list[str]]) -> tuple[list[str], list[str], list[str]]:
    """Find the names, the e-mail addresses and the ID numbers in a worksheet, or "" for each.

    ``columns`` are those between the identifiers and the grades. The names come first, but if the
    participants are anonymous, the status does, which most of them share. The ID numbers are just
    before the e-mail addresses or, without those, in the only column that looks so.
    """
    unknown = [""] * len(columns[0])
    names, *others = columns
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
    return all((empty and not cell) or pattern.fullmatch(cell) for cell in cells)


def _read_times(cells: Sequence[str]) -> list[datetime | None]:
    """Read times in many languages. The result is None if the day could also be the month."""
    options = {"STRICT_PARSING": True, "PARSERS": ["absolute-time"]}
    orders = ("DMY", "MDY")
    readers = [DateDataParser(settings={**options, "DATE_ORDER": order}) for order in orders]
    times: list[datetime | None] = []
    for cell in cells:
        found = {reader.get_date_data(cell).date_obj for reader in readers} if cell else set()
        at = found.pop() if len(found) == 1 else None
        times.append(at.replace(tzinfo=None) if at and at.year in YEARS else None)
    return times
