"""Read the stones in a box for exercise 9.7 from a CSV file with one stone per line.

The columns are what, mass, x and y. ``what`` is the name of the stone, and ``mass`` is in kg. ``x``
and ``y`` are the distances of the stone's center from the left side and from the front side of the
box, in m. Enter at least three stones, and add a line for the empty box.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import ch09_rotations

COLUMNS = ("what", "mass", "x", "y")


def read_stones(path: Path) -> list[tuple[str, float, float, float]]:
    """Read a file and return its stones in the order of the lines, ignoring empty lines.

    Raises:
        ValueError: if the first line is not the heading, or a line does not contain a name, a mass
            and a position. The message gives the number of the line.
    """
    stones = []
    with path.open(encoding="utf-8-sig", newline="") as file:
        rows = csv.reader(file)
        if tuple(next(rows, ())) != COLUMNS:
            raise ValueError(f"{path.name}: line 1 must be {','.join(COLUMNS)}")
        for row in filter(None, rows):
            try:
                what, (mass, x, y) = row[0], map(float, row[1:])
                if not (what.strip() and 0.0 < mass < math.inf and math.isfinite(x + y)):
                    raise ValueError
            except ValueError:
                where = f"{path.name}, line {rows.line_num}"
                wanted = "must be a name, a positive mass in kg, and x and y in m"
                raise ValueError(f"{where} {wanted}, got {','.join(row)!r}") from None
            stones.append((what, mass, x, y))
    return stones


def own_stones() -> Path:
    """Return the path of the student's own stones.csv, or of the chapter's file if there is none.

    Raises:
        FileNotFoundError: if no folder of the engine has the file.
    """
    for folder in ch09_rotations.__path__:
        if (path := Path(folder) / "stones.csv").exists():
            return path
    raise FileNotFoundError(f"there is no stones.csv in {', '.join(ch09_rotations.__path__)}")
