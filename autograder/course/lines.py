"""Find the line of a key in a TOML file, so that a message about a mistake can point to it.

Python's own TOML parser does not report where it found a value.
"""

from __future__ import annotations

import re

HEADER = re.compile(r"\s*(\[\[?)([^\[\]]+)\]\]?\s*(#.*)?")
KEY = re.compile(r"""\s*((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=""")
PART = re.compile(r"""[\w-]+|"[^"]*"|'[^']*'""")

Path = tuple[str | int, ...]  # the keys on the way to a value, such as ("assignment", 0, "due")


class Lines:
    """Finds the line number of any key or table in a TOML file. Line numbers start at 1."""

    def __init__(self, text: str) -> None:
        self._text = text.splitlines()
        self._first: dict[Path, int] = {}
        counts: dict[Path, int] = {}
        table: Path = ()
        for number, line in enumerate(self._text, start=1):
            if header := HEADER.fullmatch(line):
                table = ()
                for part in _parts(header[2]):
                    table = (*table, part)
                    if table in counts and table != _parts(header[2]):
                        table = (*table, counts[table])  # the last table of this array so far
                if header[1] == "[[":
                    counts[table] = counts.get(table, -1) + 1
                    table = (*table, counts[table])
                self._first.setdefault(table, number)
            elif key := KEY.match(line):
                path = table
                for part in _parts(key[1]):
                    path = (*path, part)
                    self._first.setdefault(path, number)

    def of(self, path: Path, word: str = "") -> int:
        """Return the line number of the value at ``path``, such as ("assignment", 0, "due").

        If there is no such value, return the line of its table, or 1 if there is no table either.
        If the value spans several lines, return the first one that contains ``word`` in quotes.
        """
        while path and path not in self._first:
            path = path[:-1]
        first = self._first.get(path, 1)
        later = [line for line in self._first.values() if line > first]
        end = min(later, default=len(self._text) + 1)
        for number in range(first, end if word else first):
            if re.search(rf"""["']{re.escape(word)}["']""", self._text[number - 1]):
                return number
        return first


def _parts(dotted: str) -> Path:
    """Split a dotted TOML key, such as assignment.late, into its parts, and unquote them."""
    return tuple(part.strip("\"'") for part in PART.findall(dotted))
