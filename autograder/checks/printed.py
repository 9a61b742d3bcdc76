"""Capture what a student's code prints, up to a limit."""

from __future__ import annotations

import io
from collections.abc import Callable

LONGEST = 4000  # characters


class CappedText(io.TextIOBase):
    """A text stream that captures the first 4000 characters that student code prints.

    The rest is discarded, so a print statement in an endless loop cannot fill the memory.
    """

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
