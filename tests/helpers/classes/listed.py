"""Read the list of a class from names of submissions, for tests of what is made from the list."""

from __future__ import annotations

import csv
import io
import re
import tempfile
from collections.abc import Mapping
from pathlib import Path

from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.roster import COLUMNS, GROUP, Student

FILE = re.compile(r"\.(zip|pdf|txt|csv|gz)$", re.IGNORECASE)
Files = Mapping[str, str]


def class_in(folder: Path, names: str, roster: str = "", files: Files | None = None) -> ClassList:
    """Return the class that handed in empty folders, zips and PDFs of these names, separated by |.

    ``roster`` has the lines below the header, and ``files`` the texts of other files.
    """
    place = folder / "class"
    place.mkdir(exist_ok=True)
    for name in names.split("|"):
        path = place / name
        path.touch() if FILE.search(name) else path.mkdir(exist_ok=True)
    for name, text in (files or {}).items():
        (place / name).write_text(text, encoding="utf-8")
    path = folder / "roster.csv"
    path.write_text(f"{','.join([*COLUMNS, GROUP])}\n{roster}", encoding="utf-8")
    return read_class(place, path if roster else None)


def handed_in(people: ClassList) -> dict[str, str]:
    """Return what each member of a class has handed in, or "" for nothing."""
    return {m.shown: m.submission.path.name if m.submission else "" for m in people.members}


def listed(*names: str, roster: list[Student] | None = None) -> ClassList:
    """Return the class that has handed in folders, zips and PDFs of these names, all empty."""
    rows = io.StringIO(newline="")
    csv.writer(rows).writerows(
        [one.id, one.name, one.email, one.login, one.group] for one in roster or []
    )
    with tempfile.TemporaryDirectory() as folder:
        return class_in(Path(folder), "|".join(names), rows.getvalue())
