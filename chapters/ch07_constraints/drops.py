"""Read the measured drops of exercise 7.1 from a CSV file with one drop per line.

The columns are material, initial_height and bounce_height. The heights are in m, measured from the
ball's position when it lies on the ground.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import ch07_constraints

COLUMNS = ["material", "initial_height", "bounce_height"]


def read_drops(path: Path) -> list[tuple[str, float, float]]:
    """Read a file and return its drops in the order of the lines, ignoring empty lines.

    Raises:
        ValueError: if a line lacks a column or a height is not a number. The message gives the
            number of the line.
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
                wanted = "must have two heights in m, such as 1.25 and 0.8"
                raise ValueError(f"{where} {wanted}, got {','.join(row)!r}")
            drops.append((row[0].strip(), *heights))
    return drops


def find_drops(name: str = "drops.csv") -> Path:
    """Return the path of the student's own file, or of the chapter's file if there is none.

    ``name`` is the name of the file.

    Raises:
        FileNotFoundError: if no folder of the engine has the file.
    """
    for folder in ch07_constraints.__path__:
        if (path := Path(folder) / name).exists():
            return path
    raise FileNotFoundError(f"there is no {name} in {', '.join(ch07_constraints.__path__)}")
