"""Compute fingerprints of students' code by winnowing (Schleimer, Wilkerson and Aiken, 2003).

Every sequence of GRAM consecutive tokens is hashed. From every WINDOW neighboring hashes, the
smallest is kept as a fingerprint. If two functions have GRAM + WINDOW - 1 consecutive tokens in
common, they therefore share at least one fingerprint.

Renaming variables does not hide a copy. In each sequence, the student's own names are replaced with
numbers, in the order in which they appear. Moving statements changes only a few fingerprints,
because a sequence is no longer than a short statement.
"""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterable
from functools import cache

from autograder.similarity.code import LOCAL, Token

GRAM = 8
WINDOW = 4


@cache
def hashes(words: tuple[str, ...]) -> tuple[int, ...]:
    """Hash every sequence of GRAM consecutive tokens, in the order of the code."""
    return tuple(_hash(words[i : i + GRAM]) for i in range(len(words) - GRAM + 1))


def fingerprints(words: tuple[str, ...]) -> set[int]:
    """Compute the fingerprints of a function by winnowing its hashes."""
    found = hashes(words)
    windows = range(max(1, len(found) - WINDOW + 1)) if found else ()
    return {min(found[i : i + WINDOW]) for i in windows}


def covered(tokens: list[Token], shared: Collection[int]) -> set[int]:
    """Return the indices of the tokens in any sequence whose hash is in ``shared``."""
    found = hashes(tuple(token.word for token in tokens))
    starts: Iterable[int] = (i for i, value in enumerate(found) if value in shared)
    return {i for start in starts for i in range(start, start + GRAM)}


def _hash(run: tuple[str, ...]) -> int:
    names: dict[str, int] = {}
    words = [
        f"{LOCAL}{names.setdefault(word, len(names))}" if word.startswith(LOCAL) else word
        for word in run
    ]
    digest = hashlib.blake2b("\n".join(words).encode("utf-8", "surrogatepass"), digest_size=8)
    return int.from_bytes(digest.digest(), "big")  # the same in every run, unlike hash()
