"""Read the roster of a class, a CSV file with the columns id, name, email, login and group."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from autograder.submissions.csv_rows import FORMULA, Mistakes, Table, read_csv
from autograder.submissions.names import key, letters
from autograder.text.clean import clean_line

COLUMNS = ("id", "name", "email", "login")
GROUP = "group"
ROUNDED = re.compile(r"[0-9]([.,][0-9]+)?[eE][+][0-9]+")  # such as 1.23457E+11
UNIQUE = ("id", "email", "login")  # by these columns a platform recognizes a student


@dataclass(frozen=True)
class Student:
    """A student in one line of the roster. Students who have the same group hand in together."""

    id: str
    name: str
    email: str
    login: str
    line: int
    group: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """What this student may be called in a table, or on a submission."""
        return (self.name, self.id, self.email, self.login)

    @property
    def canvas_names(self) -> set[str]:
        """What Canvas may make of the name: doejane for Jane Doe."""
        # The family name comes first, and may have several words, as in vanderbergjan.
        words = self.name.replace(",", " ").split()
        return {letters("".join(words[i:] + words[:i])) for i in range(len(words))} - {""}


def read_roster(path: Path) -> list[Student]:
    """Read the students on a roster, in its order. Other columns are ignored."""
    table = read_csv(path)
    places = _places(table)
    students: list[Student] = []
    lines: dict[tuple[str, str], int] = {}
    mistakes = Mistakes(path)
    for line, _, cells in table.rows("cell", mistakes):
        values = {name: clean_line(cells[place]).strip() for name, place in places.items()}
        found = [f"the {name} is empty" for name in ("id", "name") if not values[name]]
        for name, value in [(name, values[name]) for name in UNIQUE if values[name]]:
            about = f"the {name} {value!r}"
            # Platforms identify students by these cells, so a formula must not get a prefix.
            if FORMULA.search(value):
                found.append(f"{about} must not begin like a spreadsheet formula")
            if ROUNDED.fullmatch(value):
                found.append(f"{about} was rounded by a spreadsheet. Format its column as text")
            before = lines.setdefault((name, key(value)), line)
            if before != line:
                found.append(f"{about} is already in line {before}. Give each student one row")
        for words in found:
            mistakes.add(line, words)
        students.append(Student(**values, line=line))
    mistakes.raise_any()
    if not students:
        raise ValueError(f"{path} has no students below its header")
    return students


def _places(table: Table) -> dict[str, int]:
    """Find the position of every column, or raise ValueError if one is missing or appears twice."""
    for name in (*COLUMNS, GROUP):
        count = table.header.count(name)
        if count > 1 or (count == 0 and name != GROUP):
            problem = f"there are {count} columns {name!r}" if count else f"no column {name!r}"
            raise ValueError(
                f"{table.path}, line 1: {problem}. The header must have {','.join(COLUMNS)}, "
                f"got {table.first_line!r}"
            )
    return {name: table.header.index(name) for name in (*COLUMNS, GROUP) if name in table.header}
