"""Find the student whom a name means, in the same way for all commands, tables and files."""

from __future__ import annotations

import unicodedata
from collections import defaultdict
from collections.abc import Hashable, Iterable, Sequence
from typing import Generic, TypeVar

from autograder.submissions.csv_rows import as_cell

T = TypeVar("T", bound=Hashable)
MOST_LISTED = 5


class UnknownNameError(ValueError):
    """Raised if no student has a name."""


class Names(Generic[T]):
    """All names of some students, with a label for error messages for each student."""

    def __init__(self, people: Iterable[tuple[T, str, Sequence[str]]]) -> None:
        self.labels: dict[T, str] = {}
        # The strictest form of a name is the first. Each form has everyone whom it fits.
        self._levels = [defaultdict[str, dict[T, None]](dict) for _ in _levels("")]
        for who, label, names in people:
            self.labels[who] = label
            for name in filter(None, names):
                for level, forms in zip(self._levels, _levels(name), strict=True):
                    for form in forms - {""}:
                        level[form][who] = None

    def all_of(self, text: str) -> list[T]:
        """Return everyone whom a name fits.

        If an exact name fits, only exact names count, and then those with other capital letters.
        Otherwise, spaces, punctuation, leading zeros of a number and "Doe, Jane" for "Jane Doe"
        make no difference either. Accents do: a name without them may be another student's.
        """
        for level, forms in zip(self._levels, _levels(text), strict=True):
            if found := {who: None for form in sorted(forms) for who in level.get(form, ())}:
                return [*found]
        return []

    def problem(self, text: str, found: Sequence[T]) -> ValueError:
        """Say why a name does not mean one student. ``found`` is everyone whom it fits."""
        if found:
            labels = " and ".join(self.labels[who] for who in found)
            return ValueError(f"{text!r} could be {labels}. Write the id or the email")
        return UnknownNameError(f"there is no student {text!r}.")


def some(names: Sequence[str]) -> str:
    """List up to five names, and count the others."""
    more = len(names) - MOST_LISTED
    return "; ".join(names[:MOST_LISTED]) + (f"; and {more} more" if more > 0 else "")


def key(text: str) -> str:
    """Return an id, e-mail address or login without differences of case and Unicode encoding."""
    return _exact(text).casefold()


def letters(name: str) -> str:
    """Return only the letters and digits of a name, in lower case, as platforms write it."""
    # Marks that belong to a letter stay, because many scripts write vowels in this way.
    text = unicodedata.normalize("NFKC", name).casefold()
    return "".join(c for c in text if c.isalnum() or unicodedata.category(c).startswith("M"))


def _exact(text: str) -> str:
    return unicodedata.normalize("NFC", text.strip())


def _levels(text: str) -> list[set[str]]:
    """Return the forms in which two spellings of a name are equal, the strictest first."""
    last, comma, first = text.partition(",")
    loose = {letters(first + last if comma else text)}
    if text.strip().isdecimal():  # a spreadsheet makes 42 of 00042
        loose.add(text.strip().lstrip("0"))
    return [{_exact(text)}, {key(text), key(as_cell(text))}, loose]
