"""Capture what a student's code prints, up to a limit."""

from __future__ import annotations

import io
from collections.abc import Callable

LONGEST = 4000  # characters


class CappedText(io.TextIOBase):
    """A text stream that keeps only the beginning, so that endless printing fills no memory."""

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
