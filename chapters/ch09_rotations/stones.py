"""Read the stones in a box for exercise 9.7, from a CSV file with a line for each.

Its columns are what, mass, x and y: a name, the mass in kg, and where the stone's middle is, in m
from the left and from the front side of the box. At least three stones, and the empty box, have a
line each.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import ch09_rotations

COLUMNS = ("what", "mass", "x", "y")


def read_stones(path: Path) -> list[tuple[str, float, float, float]]:
    """Return the stones in a file, in its order; empty lines are left out.

    Raises ValueError for another first line, and for one that is no name, mass and place: by number.
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
                wanted = "must be a name, a mass in kg above 0, x and y in m"
                raise ValueError(f"{where} {wanted}, got {','.join(row)!r}") from None
            stones.append((what, mass, x, y))
    return stones


def own_stones() -> Path:
    """Return the path of stones.csv: the student's own, where the engine has one.

    Raises FileNotFoundError where no folder of the engine has it.
    """
    for folder in ch09_rotations.__path__:
        if (path := Path(folder) / "stones.csv").exists():
            return path
    raise FileNotFoundError(f"there is no stones.csv in {', '.join(ch09_rotations.__path__)}")
