"""Capture what a student's code prints, and throw away all but the first characters."""

from __future__ import annotations

import io
from collections.abc import Callable

LONGEST = 4000  # characters


class CappedText(io.TextIOBase):
    """A text stream that keeps the first LONGEST characters that are written to it."""

    def __init__(self, keep: Callable[[str], object]) -> None:
        self.left = LONGEST
        self.keep = keep

    def write(self, text: str) -> int:
        kept = text[: self.left]
        self.left -= len(kept)
        if kept:
            self.keep(kept)
        return len(text)

    def writable(self) -> bool:
        return True
