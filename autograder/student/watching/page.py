"""Lay out the `watch` page, and shorten it until its heading and keys fit on the terminal."""

from __future__ import annotations

from dataclasses import dataclass, field

from autograder.message import Row, laid_out
from autograder.student.failure import Failure
from autograder.text.wrapping import (
    MOST_PRINTED,
    MOST_PRINTED_LINES,
    cut,
    few_lines,
    plain_console,
    wrapped,
    wrapped_rows,
)

KEYS = "h next hint   l list   a check all   r reset   p plot   q quit"
Line = tuple[str, str]  # a text and its style


@dataclass
class Page:
    """The content of the `watch` page."""

    top: list[Line] = field(default_factory=list)
    failure: Failure | None = None
    bottom: list[Line] = field(default_factory=list)
    whole: str = ""  # the command that prints the failure in full
    note: list[Line] = field(default_factory=list)  # a short message at the end

    def say(self, words: str, style: str = "") -> None:
        """Add a line below the explanation of the failed check."""
        self.bottom.append((words, style))

    def draw(self, *, with_keys: bool) -> None:
        """Print the page, and the keys. On a terminal, clear the screen and make the page fit."""
        console, keys = plain_console(), [(KEYS, "bold")] if with_keys else []
        if console.is_terminal:
            console.clear()
            lines = self.fitted(console.width, console.height, keys)
        else:
            rows = [*self.failure.diagnosis, *self._printed()] if self.failure else []
            diagnosis = [(laid_out(rows), "")] if self.failure else []
            lines = [*self.top, *diagnosis, *self._below(), *keys]
        for words, style in lines:
            console.print(words, style=style, soft_wrap=True)

    def fitted(self, width: int, height: int, keys: list[Line]) -> list[Line]:
        """Shorten the page by leaving out the middle of a long explanation."""
        top, below = _wrapped(self.top, width), _wrapped(self._below(), width)
        printed = [(words, "") for words in wrapped_rows(self._printed(), width)]
        diagnosis = wrapped_rows(self.failure.diagnosis if self.failure else [], width)
        room = height - 1 - len(top) - len(below) - len(keys)
        # The diagnosis matters more than the printed output, but at least one line of that stays.
        few = max(2, room - len(diagnosis))
        if len(printed) > few:
            printed = [*printed[: few - 1], (f"{'...':10}in full: {self.whole}", "")]
        note = f"{'...':10}too long for this screen; in full: {self.whole}"
        middle = [(words, "") for words in cut(diagnosis, room - len(printed), note[:width])]
        return [*top, *middle, *printed, *below, *keys]

    def _printed(self) -> list[Row]:
        printed = self.failure.printed if self.failure else ""
        return [("printed", few_lines(printed, MOST_PRINTED_LINES, MOST_PRINTED))] * bool(printed)

    def _below(self) -> list[Line]:
        """Return the lines below the failed check: what to do next, the progress and a message."""
        steps: list[Line] = []
        if self.failure is not None:
            first, *others = self.failure.steps
            steps = [("", ""), (first, "bold"), *((step, "") for step in others), ("", "")]
        return [*steps, *self.bottom, *self.note]


def _wrapped(lines: list[Line], width: int) -> list[Line]:
    return [(part, style) for words, style in lines for part in wrapped(words, width) or [""]]
