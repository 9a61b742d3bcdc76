"""Read the roster of a class, which lists its students.

The roster is a CSV file with the columns id, name, email and login.
"""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from pathlib import Path

from autograder.reports.gradebook import FORMULA
from autograder.submissions.csv_rows import Table, read_csv
from autograder.text.clean import clean_line

COLUMNS = ("id", "name", "email", "login")
UNIQUE = ("id", "email", "login")  # by these columns a platform recognizes a student


@dataclass(frozen=True)
class Student:
    """A student on the roster of a class.

    ``line`` is the number of the student's line in the file. The ``email`` and the ``login`` may be
    empty.
    """

    id: str
    name: str
    email: str
    login: str
    line: int

    @property
    def keys(self) -> set[str]:
        """The student's id, e-mail address and login, in a form that can be compared.

        A submission that is named after one of them belongs to the student.
        """
        return {key(text) for text in (self.id, self.email, self.login) if text}

    @property
    def names(self) -> set[str]:
        """The spellings of a student's name to expect on a submission, such as janedoe and doejane.

        Canvas puts the last name first. A roster may do so too, as in "Doe, Jane".
        """
        last, comma, first = self.name.partition(",")
        *given, family = self.name.split()
        return {letters(self.name), letters(first + last if comma else family + "".join(given))}


def read_roster(path: Path) -> list[Student]:
    """Read the list of students from the roster of a class, which is a CSV file.

    The columns may be in any order, separated by commas or semicolons. Other columns are ignored.
    The students are returned in the order of the file.

    Raises:
        ValueError: The roster contains a mistake. The message gives the line number.
        OSError: The file cannot be read.
    """
    table = read_csv(path)
    places = _places(table)
    other = "," if table.separator == ";" else ";"
    students: list[Student] = []
    lines: dict[tuple[str, str], int] = {}
    for line, _, cells in table.rows("cell"):
        where = f"{path}, line {line}"
        if other in cells[0] and not any(cells[1:]):
            raise ValueError(
                f"{where}: cells must be separated by {table.separator!r}, as in the header, "
                f"got {cells[0]!r}"
            )
        values = {name: clean_line(cells[place]).strip() for name, place in places.items()}
        for name in ("id", "name"):
            if not values[name]:
                raise ValueError(f"{where}: the {name} is empty")
        for name in UNIQUE:
            value = values[name]
            # Platforms identify students by these cells, so a formula must not get a prefix.
            if FORMULA.search(value):
                raise ValueError(
                    f"{where}: the {name} must not begin like a spreadsheet formula, got {value!r}"
                )
            before = lines.setdefault((name, key(value)), line) if value else line
            if before != line:
                raise ValueError(
                    f"{where}: the {name} {value!r} is already in line {before}. Give each "
                    "student one row"
                )
        students.append(Student(**values, line=line))
    if not students:
        raise ValueError(f"{path} has no students below its header")
    return students


def key(text: str) -> str:
    """Normalize a student's id, e-mail address or login, so that it can be compared.

    Comparisons then ignore case, and treat the two encodings of an accented letter as equal.
    """
    return unicodedata.normalize("NFC", text.strip()).casefold()


def letters(name: str) -> str:
    """Reduce a student's name to its letters and digits, in lower case, so that it can be compared.

    Platforms drop all other characters from the names of the files that students upload.
    """
    text = unicodedata.normalize("NFKC", name).casefold()
    return "".join(character for character in text if character.isalnum())


def _places(table: Table) -> dict[str, int]:
    """Find the position of every required column in the header of a roster.

    Raises:
        ValueError: A column is missing, or appears twice.
    """
    for name in COLUMNS:
        if (count := table.header.count(name)) != 1:
            problem = f"there are {count} columns {name!r}" if count else f"no column {name!r}"
            raise ValueError(
                f"{table.path}, line 1: {problem}. The header must have {','.join(COLUMNS)}, "
                f"got {table.first_line!r}"
            )
    return {name: table.header.index(name) for name in COLUMNS}
