"""Lay a message out on a terminal: no line breaks inside a word, and no more lines than there are.

A message has labeled lines: a word such as called or likely, and what it says from column 10 on.
"""

from __future__ import annotations

import re
import textwrap
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

INDENT = 10  # columns of the label
LABELED = re.compile(rf"(?=[a-z]+ )[a-z ]{{{INDENT - 1}}} \S")
PRINTED = "printed   "
MOST_PRINTED_LINES = 5
MOST_PRINTED = 300  # characters
LONGEST_PRINTED = 4000  # characters, of which more is not kept anywhere
MORE = re.compile(r"\.\.\. and (at least )?(\d+) more lines?")


def wrapped(message: str, width: int) -> list[str]:
    """Return the lines of a message on a terminal of this width, without breaks inside a word.

    Labeled lines have a hanging indent. A word is broken only where it is longer than a line.
    """
    lines = []
    for line in message.splitlines():
        lines += textwrap.wrap(
            line,
            max(width, 2 * INDENT),
            subsequent_indent=" " * INDENT if LABELED.match(line) else "",
            break_on_hyphens=False,
        ) or [""]
    return lines


def print_wrapped(console: Console, words: str, style: str) -> None:
    """Print words, wrapped on a terminal; where the output goes to a file, lines stay whole."""
    lines = wrapped(words, console.width) if console.is_terminal else [words]
    console.print("\n".join(lines), style=style, markup=False, soft_wrap=True)


def without_printed(message: str) -> tuple[str, str]:
    """Return a message up to what the student's code printed, and that part, empty without one."""
    diagnosis, label, printed = message.partition(f"\n{PRINTED}")
    return diagnosis, label.lstrip("\n") + printed


def few_lines(text: str, lines: int, characters: int) -> str:
    """Return the beginning of a text, and how many lines are left out.

    Lines that an earlier call has left out count too. What is LONGEST_PRINTED or longer has
    been cut before, so there were more.
    """
    cut_before = len(text) >= LONGEST_PRINTED
    text = text[:LONGEST_PRINTED].strip("\n")
    every = text.split("\n")
    if len(every) <= lines and len(text) <= characters and not cut_before:
        return text
    count = len(every)
    if earlier := MORE.fullmatch(every[-1]):
        count += int(earlier[2]) - 1
        cut_before = bool(earlier[1])
    kept = "\n".join(every[:lines])[:characters].rstrip("\n")
    left = count - len(kept.split("\n"))
    least = "at least " if cut_before else ""
    more = f"{least}{left} more line{'' if left == 1 else 's'}" if left else "more"
    return f"{kept}\n... and {more}"


def cut(lines: list[str], room: int, note: str) -> list[str]:
    """Return the lines, cut in the middle to as many as there is room for, with a note there."""
    if len(lines) <= room:
        return lines
    room = max(room - 1, 2)
    end = room // 2
    return [*lines[: room - end], note, *lines[len(lines) - end :]]
