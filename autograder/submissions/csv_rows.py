"""Read a CSV file that was written by a person or a spreadsheet, with the line of each row."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Table:
    """A CSV file: its separator, its first line, and the names of its columns in lower case."""

    path: Path
    text: str
    separator: str
    first_line: str
    header: list[str]

    def rows(self, longest: str) -> Iterator[tuple[int, int, list[str]]]:
        """Yield the rows below the header, each with its first and last line, counted from 1.

        Blank rows are skipped, and missing cells at the end of a row are empty. ``longest`` names
        the kind of cell that is likely to contain a separator by mistake, for use in error
        messages.

        Raises:
            ValueError: A row is too long, or a quote is never closed. The message names the line.
        """
        # Without strict, a quote that is never closed would hide the rows below it.
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
    """Read a CSV file in UTF-8. Its columns are separated by commas or by semicolons, as in Europe.

    Raises:
        ValueError: The file is not UTF-8. The message names the line.
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
