"""Read a CSV file written by a person or a spreadsheet, such as a roster or marks.csv.

The line number of each row is kept for use in error messages.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Table:
    """The contents of a CSV file such as a roster, with the separator and the column names.

    Column names are converted to lower case.
    """

    path: Path
    text: str
    separator: str
    first_line: str
    header: list[str]

    def rows(self, longest: str) -> Iterator[tuple[int, int, list[str]]]:
        """Yield the rows below the header of a CSV file, each with its first and last line number.

        Blank rows are skipped, and missing cells at the end of a row are empty. A row with too many
        cells is an error. The usual cause is a cell that contains a separator but is not in quotes.
        ``longest`` is the error message's name for this cell, such as "comment".

        Raises:
            ValueError: A row is too long, or a quote is never closed. The message gives the line
                number.
        """
        # If this were not strict, a quote that is never closed would hide all rows below it.
        source = io.StringIO(self.text, newline="")
        reader = csv.reader(source, delimiter=self.separator, strict=True)
        width = len(self.header)
        line = 1
        try:
            for row in reader:
                cells = [cell.strip() for cell in row]
                while cells and not cells[-1]:
                    cells.pop()  # spreadsheets pad rows
                if line > 1 and len(cells) > width:
                    raise ValueError(
                        f"{self.path}, line {line}: there must be {width} cells, got {len(cells)}. "
                        f"Put a {longest} that contains {self.separator!r} in quotes"
                    )
                if line > 1 and cells:
                    yield line, reader.line_num, cells + [""] * (width - len(cells))
                line = reader.line_num + 1
        except csv.Error as error:
            raise ValueError(f"{self.path}, line {line}: {error}. Close the quote") from error


def read_csv(path: Path) -> Table:
    """Read a CSV file, such as a roster, with commas or semicolons between the cells.

    Semicolons are common in files from European spreadsheets.

    Raises:
        ValueError: The file is not UTF-8. The message gives the line number.
        OSError: The file cannot be read.
    """
    try:
        text = path.read_bytes().decode("utf-8-sig")  # some spreadsheets begin with a BOM
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise ValueError(f"{path}, line {line}: this is not UTF-8. Save it as CSV UTF-8") from error
    first = (text.splitlines() or [""])[0]
    separator = ";" if ";" in first else ","
    header = [cell.strip(' "').lower() for cell in first.rstrip(separator).split(separator)]
    return Table(path, text, separator, first.strip(), header)
