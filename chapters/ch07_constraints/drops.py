"""Read the drops that were measured for exercise 7.1, from a CSV file with a line for each.

Its columns are material, initial_height and bounce_height. The heights are in m, of the same point
of the ball, above where it is when it lies still.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import ch07_constraints

COLUMNS = ["material", "initial_height", "bounce_height"]


def read_drops(path: Path) -> list[tuple[str, float, float]]:
    """Return the drops in a file, in its order; lines without anything are left out.

    Raises ValueError that names the line where a column is missing, or a height is none.
    """
    drops = []
    with path.open(encoding="utf-8-sig", newline="") as file:
        rows = csv.reader(file)
        if (heading := next(rows, [])) != COLUMNS:
            wanted = ",".join(COLUMNS)
            raise ValueError(f"{path.name}: line 1 must be {wanted}, got {','.join(heading)!r}")
        for row in rows:
            if not any(cell.strip() for cell in row):
                continue
            where = f"{path.name}, line {rows.line_num}"
            if len(row) != len(COLUMNS) or not row[0].strip():
                raise ValueError(
                    f"{where} must be a material and two heights, got {','.join(row)!r}"
                )
            try:
                heights = float(row[1]), float(row[2])
            except ValueError:
                heights = math.nan, math.nan
            if not all(0.0 <= height < math.inf for height in heights):
                wanted = "must have two heights in m, such as 1.25"
                raise ValueError(f"{where} {wanted}, got {','.join(row)!r}")
            drops.append((row[0].strip(), *heights))
    return drops


def find_drops(name: str = "drops.csv") -> Path:
    """Return the path of a file of this chapter: the student's own, where the engine has one.

    Raises FileNotFoundError where no folder of the engine has it.
    """
    for folder in ch07_constraints.__path__:
        if (path := Path(folder) / name).exists():
            return path
    raise FileNotFoundError(f"there is no {name} in {', '.join(ch07_constraints.__path__)}")
