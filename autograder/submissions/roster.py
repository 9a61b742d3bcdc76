"""Read the roster of a class, a CSV file with the columns id, name, email, login and group."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from autograder.submissions.csv_rows import FORMULA, read_csv
from autograder.submissions.names import key, letters
from autograder.text.clean import clean_line

COLUMNS = ("id", "name", "email", "login")
GROUP = "group"
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
    for name in (*COLUMNS, GROUP):
        count = table.header.count(name)
        if count > 1 or (count == 0 and name != GROUP):
            header = f"The header must have {','.join(COLUMNS)}, got {table.first_line!r}"
            raise table.mistake(1, f"there are {count} columns {name!r}. {header}")
    students: list[Student] = []
    lines: dict[tuple[str, str], int] = {}
    for line, cells in table.rows():
        row = dict(zip(table.header, cells, strict=True))
        values = {name: clean_line(row.get(name, "")).strip() for name in (*COLUMNS, GROUP)}
        for name in ("id", "name"):
            if not values[name]:
                raise table.mistake(line, f"the {name} is empty")
        for name, value in [(name, values[name]) for name in UNIQUE if values[name]]:
            about = f"the {name} {value!r}"
            # Platforms identify students by these cells, so a formula must not get a prefix.
            if FORMULA.search(value):
                raise table.mistake(line, f"{about} must not begin like a spreadsheet formula")
            before = lines.setdefault((name, key(value)), line)
            if before != line:
                words = f"{about} is already in line {before}. Give each student one row"
                raise table.mistake(line, words)
        students.append(Student(**values, line=line))
    if not students:
        raise ValueError(f"{path} has no students below its header")
    return students
