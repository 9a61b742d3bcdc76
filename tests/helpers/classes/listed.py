"""Read the list of a class from names of submissions, for tests of what is made from the list."""

from __future__ import annotations

import csv
import tempfile
from pathlib import Path

from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.roster import COLUMNS, GROUP, Student


def listed(*names: str, roster: list[Student] | None = None) -> ClassList:
    """Return the class that has handed in folders, zips and PDFs of these names, all empty."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "roster.csv"
        rows = [[one.id, one.name, one.email, one.login, one.group] for one in roster or []]
        with path.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([[*COLUMNS, GROUP], *rows])
        for name in names:
            place = Path(folder) / name
            place.touch() if name.lower().endswith((".zip", ".pdf")) else place.mkdir()
        return read_class(Path(folder), path if roster else None)
