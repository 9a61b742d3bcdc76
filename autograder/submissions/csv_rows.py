"""Read a CSV file written by a person or a spreadsheet, such as a roster or marks.csv."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.text.clean import clean_line

# If a cell begins with one of these characters, even in full width or after spaces, a spreadsheet
# takes it for a formula. In some countries a new cell also begins after each semicolon.
FORMULA = re.compile(r"(^|;)(\s*)(?=[=+\-@＝＋－＠])")  # noqa: RUF001


def as_cell(text: str) -> str:
    """Return text as a line that no spreadsheet takes for a formula, such as '=1+1 for =1+1."""
    return FORMULA.sub(r"\1\2'", clean_line(text))


@dataclass(frozen=True)
class Table:
    """The contents of a CSV file, with the names of its columns in lower case."""

    path: Path
    text: str
    separator: str
    first_line: str
    header: list[str]

    def rows(self) -> Iterator[tuple[int, list[str]]]:
        """Yield the rows below the header, each with the number of its first line.

        Blank rows are skipped, and missing cells at the end of a row are empty.
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
                    words = f"there must be {width} cells, got {len(cells)}. Put a cell that "
                    raise self.mistake(line, f"{words}contains {self.separator!r} in quotes")
                if line > 1 and cells:
                    yield line, cells + [""] * (width - len(cells))
                line = reader.line_num + 1
        except csv.Error as error:
            raise self.mistake(line, f"{error}. Close the quote") from error

    def mistake(self, line: int, words: object) -> ValueError:
        """Return an error that names a line of the table."""
        return ValueError(f"{self.path}, line {line}: {words}")

    def require(self, header: Sequence[str]) -> None:
        """Raise ValueError if the table has another header."""
        if self.header != [*header]:
            words = f"the header must be {','.join(header)}, got {self.first_line!r}"
            raise self.mistake(1, words)


def read_csv(path: Path) -> Table:
    """Read a CSV file, with commas or, as in some countries, semicolons between the cells."""
    try:
        text = path.read_bytes().decode("utf-8-sig")  # some spreadsheets begin with a BOM
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise ValueError(f"{path}, line {line}: this is not UTF-8. Save it as CSV UTF-8") from error
    first = (text.splitlines() or [""])[0]
    separator = ";" if ";" in first else ","
    header = [cell.strip(' "').lower() for cell in first.rstrip(separator).split(separator)]
    return Table(path, text, separator, first.strip(), header)
