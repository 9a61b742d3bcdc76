"""Fit text to a terminal window: wrap lines between words, and shorten very long output."""

from __future__ import annotations

import textwrap
from typing import IO, TYPE_CHECKING

from autograder.message import INDENT, Row, laid_out

if TYPE_CHECKING:
    from rich.console import Console

MOST_PRINTED_LINES = 5
MOST_PRINTED = 300  # characters


def plain_console(file: IO[str] | None = None, width: int | None = None) -> Console:
    """Create a rich console that does not take brackets for styles, or words for emoji."""
    from rich.console import Console

    return Console(file=file, width=width, highlight=False, markup=False, emoji=False)


def wrapped(words: str, width: int, hanging: int = 0) -> list[str]:
    """Break text into lines that fit a width, all but the first indented by ``hanging`` columns."""
    wrapper = textwrap.TextWrapper(
        max(width, 2 * INDENT), subsequent_indent=" " * hanging, break_on_hyphens=False
    )
    return [part for line in words.splitlines() for part in wrapper.wrap(line) or [""]]


def wrapped_rows(rows: list[Row], width: int) -> list[str]:
    """Wrap the labeled rows of a failure message, with each text to the right of its label."""
    return [
        line for row in rows for line in wrapped(laid_out([row]), width, INDENT if row[0] else 0)
    ]


def print_wrapped(console: Console, words: str, style: str = "", hanging: int = 0) -> None:
    """Print text, wrapped as by ``wrapped`` if the console is a terminal."""
    lines = wrapped(words, console.width, hanging) if console.is_terminal else [words]
    console.print("\n".join(lines), style=style, markup=False, soft_wrap=True)


def print_rows(console: Console, rows: list[Row]) -> None:
    """Print the labeled rows of a failure message, and wrap long rows on a terminal."""
    lines = wrapped_rows(rows, console.width) if console.is_terminal else [laid_out(rows)]
    console.print("\n".join(lines), markup=False, soft_wrap=True)


def few_lines(text: str, lines: int, characters: int) -> str:
    """Shorten a student's long output to its beginning."""
    text = text.strip("\n")
    kept = "\n".join(text.split("\n", lines)[:lines])[:characters].rstrip("\n")
    return text if kept == text else f"{kept}\n... and more"


def cut(lines: list[str], room: int, note: str) -> list[str]:
    """Shorten a list of lines to ``room`` lines, at least three, with ``note`` in the middle."""
    if len(lines) <= room:
        return lines
    room = max(room - 1, 2)
    end = room // 2
    return [*lines[: room - end], note, *lines[len(lines) - end :]]
