"""Suggest the name that somebody probably meant, for a message such as "Did you mean velocity?"."""

from __future__ import annotations

from collections.abc import Iterable

SHORTEST = 3  # letters; a shorter name would be similar to too many others
LONGEST = 100  # characters of a name


def nearest(name: str, names: Iterable[str], cutoff: float = 0.6) -> str:
    """Return the most similar of the existing ``names``, or "" if none is similar enough.

    Special names such as __init__ are never suggested. A ``cutoff`` of 1 accepts only equal names.
    """
    if not SHORTEST <= len(name) <= LONGEST:
        return ""
    import difflib  # which takes a while

    usual = [other for other in names if not (other.startswith("__") and other.endswith("__"))]
    return next(iter(difflib.get_close_matches(name, usual, 1, cutoff)), "")[:LONGEST]
