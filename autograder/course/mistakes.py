"""Collect every mistake in a course file, so that the instructor sees all of them at once.

Each mistake is reported with its line number.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable, Mapping
from typing import Any

from autograder.course.lines import Lines, Path
from autograder.text.clean import clean_line

MOST_SIMILAR = 3
LARGEST = 1_000_000  # the largest number that we accept for points, percent and so on
NAMES = {str: "a string", int: "a whole number", list: "a list", dict: "a table"}


class Mistakes:
    """Collects the mistakes that an instructor made in a course file, each with its line number.

    Most methods read a value and record a mistake if the value is invalid.
    """

    def __init__(self, file: str, text: str) -> None:
        self.file = file
        self._lines = Lines(text)
        # Each with its line, and the number of the assignment whose table contains it.
        self._found: list[tuple[int, str, str | int | None]] = []

    def add(self, path: Path, words: str, word: str = "", *, concerns_all: bool = False) -> None:
        """Record a mistake in the course file, so that it can be reported with its line number.

        ``path`` contains the keys that lead to the invalid value, such as ("assignment", 0, "due").
        If the value is a list, ``word`` is the invalid item. ``concerns_all`` is True for a mistake
        that matters to all assignments, although it is in the table of one.
        """
        is_in_one = path[:1] == ("assignment",) and len(path) > 1 and not concerns_all
        self._found.append((self._lines.of(path, word), words, path[1] if is_in_one else None))

    def raise_any(self, assignments: Collection[int] | None = None) -> None:
        """Raise a ValueError that lists all recorded mistakes by line, if there are any.

        With ``assignments``, do not raise an error if all mistakes are in the tables of others.
        """
        tables = {table for _, _, table in self._found}
        if tables and (assignments is None or tables & {None, *assignments}):
            raise ValueError(self.listed())

    def listed(self, where: str = "") -> str:
        """List all recorded mistakes by line. If there are none, return an empty string.

        ``where`` is inserted after the number of mistakes.
        """
        if not self._found:
            return ""
        found = sorted(dict.fromkeys(mistake[:2] for mistake in self._found), key=lambda m: m[0])
        count = "one mistake" if len(found) == 1 else f"{len(found)} mistakes"
        lines = [f"  line {line}: {words}" for line, words in found]
        return "\n".join([f"{self.file} has {count}{where}:", *lines])

    def check_keys(
        self,
        table: Mapping[str, Any],
        path: Path,
        known: Iterable[str],
        elsewhere: Collection[str] = (),
    ) -> None:
        """Record each unknown key of a table as a mistake, and suggest the most similar valid key.

        For example, a misspelled "tilte" leads to the suggestion "title". A key in ``elsewhere`` is
        known, but only at the top of the file.
        """
        keys = list(known)
        for key in table:
            if key in elsewhere:
                words = f"{key} belongs at the top of the file, before the first [[assignment]]"
                self.add((*path, key), words, concerns_all=True)
            elif key not in keys:
                wanted = nearest(key, keys, 1) or f"The keys here are {', '.join(keys)}."
                self.add((*path, key), f"there is no key {key!r}. {wanted}")

    def value(self, table: Mapping[str, Any], path: Path, key: str, kind: type) -> Any:
        """Read the value of a key in the course file, or return None if it is missing or invalid.

        If the value has the wrong type, record a mistake. A missing key is not a mistake.
        """
        value = table.get(key)
        if value is None or type(value) is kind:
            return value
        self.add((*path, key), f"{key} must be {NAMES[kind]}, got {shown(value)}")
        return None

    def items(self, table: Mapping[str, Any], path: Path, key: str, kind: type) -> list[Any]:
        """Read a list from the course file, and return the items that have the right type.

        Each item of any other type is recorded as a mistake.
        """
        value = self.value(table, path, key, list) or []
        for item in value:
            if type(item) is not kind:
                wanted = "strings" if kind is str else "whole numbers"
                self.add((*path, key), f"{key} must be a list of {wanted}, got {shown(item)} in it")
        return [item for item in value if type(item) is kind]

    def number(self, table: Mapping[str, Any], path: Path, key: str) -> float | None:
        """Read a positive number from the course file, or return None if it is missing or invalid.

        An invalid value is recorded as a mistake, but a missing key is not.
        """
        value: Any = table.get(key)
        if type(value) in (int, float) and 0 < value <= LARGEST:
            return float(value) if value % 1 else int(value)
        if value is not None:
            is_large = type(value) in (int, float) and value > LARGEST
            wanted = f"at most {LARGEST:,}" if is_large else "a positive number"
            self.add((*path, key), f"{key} must be {wanted}, got {shown(value)}")
        return None


def shown(value: Any) -> str:
    """Format a value as TOML, and truncate the result if it is long."""
    text = {True: "true", False: "false"}.get(value) if type(value) is bool else None
    text = text or (f'"{value}"' if isinstance(value, str) else str(value))
    text = clean_line(text)
    return text if len(text) <= 60 else f"{text[:57]}..."


def nearest(name: str, known: Iterable[str], most: int = MOST_SIMILAR) -> str:
    """Suggest the known names that are most similar to a wrong one, as in "Did you mean B2.1?".

    Return an empty string if no known name is similar.
    """
    names = {other.lower(): other for other in known}
    wanted = name.lower()
    bare = re.sub(r"^[a-z]\s*(?=\d)", "", wanted)
    # Exercises often differ only in the letter before or after the number.
    alike = [key for key in names if key.startswith(wanted) and wanted]
    alike += [key for key in names if bare and re.sub(r"^[a-z](?=\d)", "", key) == bare]
    alike += difflib.get_close_matches(wanted, names, most, 0.6)
    found = [names[key] for key in dict.fromkeys(alike)][:most]
    return f"Did you mean {' or '.join(found)}?" if found else ""
